import CoreTransferable
import GyradiusApp
import SwiftUI
import UniformTypeIdentifiers

/// A file that could not be made.
struct NotMade: LocalizedError {
  var errorDescription: String? { Words.fileNotMade }
}

/// A session as others take it: the zip of its folder, or the file that it came as. It is made when somebody wants it.
struct SharedSession: Transferable {
  private let session: URL
  private let name: String
  private let isFolder: Bool

  init(_ measurable: Measurable) {
    (session, name) = (measurable.session, measurable.title)
    var isFolder: ObjCBool = false
    self.isFolder = FileManager.default.fileExists(atPath: session.path, isDirectory: &isFolder) && isFolder.boolValue
  }

  static var transferRepresentation: some TransferRepresentation {
    FileRepresentation(exportedContentType: .zip) { try SentTransferredFile($0.zipped()) }
      .exportingCondition { $0.isFolder }
    FileRepresentation(exportedContentType: .data) { SentTransferredFile($0.session) }
      .exportingCondition { !$0.isFolder }
  }

  /// What the system gives of a folder that is to be uploaded is a zip of it, gone when the reading ends.
  private func zipped() throws -> URL {
    let copy = FileManager.default.temporaryDirectory.appending(path: "\(name.isEmpty ? "session" : name).zip")
    var unread: NSError?
    var uncopied: (any Error)?
    NSFileCoordinator().coordinate(readingItemAt: session, options: .forUploading, error: &unread) { zip in
      do {
        try? FileManager.default.removeItem(at: copy)
        try FileManager.default.copyItem(at: zip, to: copy)
      } catch {
        uncopied = error
      }
    }
    if let failure = unread ?? uncopied { throw failure }
    return copy
  }
}

/// The report of a result: one HTML file, made when somebody wants it.
struct SharedReport: Transferable {
  let model: ResultModel

  static var transferRepresentation: some TransferRepresentation {
    FileRepresentation(exportedContentType: .html) { shared in
      let folder = FileManager.default.temporaryDirectory
      guard let file = await shared.model.report(into: folder, in: libraryLanguage) else { throw NotMade() }
      return SentTransferredFile(file)
    }
  }
}
