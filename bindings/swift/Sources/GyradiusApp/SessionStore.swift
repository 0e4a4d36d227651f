import Foundation
import GyradiusKit

/// A session as the list shows it.
public struct Listed: Sendable, Identifiable, Equatable {
  public let folder: URL
  public let title: String
  public let at: Date?
  /// Where its procedure stands; absent for a file that came from elsewhere.
  public var phase: ProcedurePhase?
  /// The figures, once there are some.
  public var figures: [NamedQuantity] = []
  /// Why it cannot be read.
  public var damage: String?

  public var id: URL { folder }
}

/// A session that can be measured.
public struct Measurable: Sendable, Hashable {
  /// The session's folder, or a file from elsewhere.
  public let session: URL
  public let title: String
  /// Class limits to judge it by.
  public let limits: [String]
  /// Where its limits are kept, and its criticism once there is one.
  public let folder: URL
}

/// The sessions on the disk: a folder each, named by the moment it was made.
public struct SessionStore: Sendable {
  /// Everything; the document browser shows it.
  public let root: URL
  /// The one practice; begun afresh whenever it is not gone on with.
  public let practice: URL
  /// The limits that were used last.
  private let usual: URL
  private let now: @Sendable () -> Date

  private static let titleFile = "title.txt"
  /// A class limit in each line.
  private static let limitsFile = "limits.txt"
  private static let importedPrefix = "imported-"

  public init(documents: URL, support: URL, now: @escaping @Sendable () -> Date = { Date() }) {
    root = documents.appending(path: "sessions")
    practice = support.appending(path: "practice")
    usual = support.appending(path: Self.limitsFile)
    self.now = now
  }

  /// Whether a folder is a procedure's.
  public static func hasProcedure(_ folder: URL) -> Bool {
    FileManager.default.fileExists(atPath: folder.appending(path: "procedure.journal").path)
  }

  /// Whether a practice was left that has not come to its end.
  public var isPracticeLeft: Bool {
    guard Self.hasProcedure(practice), let left = try? Procedure.open(folder: practice.path) else { return false }
    return left.state().phase != .done
  }

  /// Throws the last practice away.
  public func practiceAfresh() throws -> URL {
    try? FileManager.default.removeItem(at: practice)
    try FileManager.default.createDirectory(at: practice, withIntermediateDirectories: true)
    return practice
  }

  /// A folder for a new session, with the class limits that it will be judged by.
  public func create(title: String, limits: [String] = []) throws -> URL {
    let folder = try begin(in: root, title: title)
    if !limits.isEmpty { try keep(limits: limits, in: folder) }
    return folder
  }

  private func begin(in place: URL, title: String) throws -> URL {
    let folder = place.appending(path: Self.name(of: now()))
    try FileManager.default.createDirectory(at: folder, withIntermediateDirectories: true)
    try write(title, to: folder.appending(path: Self.titleFile))
    return folder
  }

  /// Keeps the class limits that a session is judged by; the next session is offered the same.
  public func keep(limits: [String], in folder: URL) throws {
    // iOS makes no folder for an app's own files by itself.
    try FileManager.default.createDirectory(at: usual.deletingLastPathComponent(), withIntermediateDirectories: true)
    for file in [folder.appending(path: Self.limitsFile), usual] {
      try write(limits.joined(separator: "\n"), to: file)
    }
  }

  /// Class limits that were used last.
  public var usualLimits: [String] { limits(in: usual) }

  private func limits(in file: URL) -> [String] {
    let text = try? String(contentsOf: file, encoding: .utf8)
    return text?.split(separator: "\n").map(String.init) ?? []
  }

  /// All sessions, the newest first. Must not be asked while one is under way: a procedure has one owner.
  public func list() -> [Listed] {
    let names = (try? FileManager.default.contentsOfDirectory(atPath: root.path)) ?? []
    return names.sorted(by: >).map { listed(root.appending(path: $0)) }
  }

  /// Removes it for good.
  public func remove(_ folder: URL) throws {
    try FileManager.default.removeItem(at: folder)
  }

  /// Takes in a file from elsewhere, which must be readable as a session or a recording. It comes to the others once it is
  /// whole and read: the list never shows half of one, nor what was left when the app was killed meanwhile.
  public func take(_ file: URL) throws -> Listed {
    let arriving = FileManager.default.temporaryDirectory.appending(path: "arriving-\(UUID().uuidString)")
    defer { try? remove(arriving) }
    let folder = try begin(in: arriving, title: file.deletingPathExtension().lastPathComponent)
    let copy = folder.appending(path: Self.importedPrefix + file.lastPathComponent)
    try FileManager.default.copyItem(at: file, to: copy)
    try write(try Session.load(path: copy.path, mapping: []).title(), to: folder.appending(path: Self.titleFile))
    let arrived = root.appending(path: folder.lastPathComponent)
    try FileManager.default.createDirectory(at: root, withIntermediateDirectories: true)
    try FileManager.default.moveItem(at: folder, to: arrived)
    return listed(arrived)
  }

  /// What of a session's folder can be measured: an imported file, or what a procedure has gathered.
  public func measurable(_ folder: URL) -> Measurable? {
    let gathered = folder.appending(path: "session")
    guard let session = imported(folder) ?? (exists(gathered) ? gathered : nil) else { return nil }
    let limits = limits(in: folder.appending(path: Self.limitsFile))
    return Measurable(session: session, title: title(of: folder), limits: limits, folder: folder)
  }

  private func listed(_ folder: URL) -> Listed {
    let at = Self.date(of: folder.lastPathComponent)
    var one = Listed(folder: folder, title: title(of: folder), at: at)
    guard imported(folder) == nil else { return one }
    do {
      let state = try Procedure.open(folder: folder.path).state()
      one.phase = state.phase
      one.figures = state.result?.quantities.filter { $0.quantity.value.number != nil } ?? []
    } catch {
      one.damage = sentence(of: error)
    }
    return one
  }

  /// The file that an imported session is.
  private func imported(_ folder: URL) -> URL? {
    let names = try? FileManager.default.contentsOfDirectory(atPath: folder.path)
    return names?.first { $0.hasPrefix(Self.importedPrefix) }.map { folder.appending(path: $0) }
  }

  private func title(of folder: URL) -> String { (try? text(folder, Self.titleFile)) ?? "" }

  private func text(_ folder: URL, _ name: String) throws -> String {
    try String(contentsOf: folder.appending(path: name), encoding: .utf8)
  }

  private func write(_ text: String, to file: URL) throws {
    try text.write(to: file, atomically: true, encoding: .utf8)
  }

  private func exists(_ file: URL) -> Bool { FileManager.default.fileExists(atPath: file.path) }

  /// No colon: not every system that the folder is carried to takes one. `2026-05-04T093000.123Z`.
  private static let style = Date.ISO8601FormatStyle(timeSeparator: .omitted, includingFractionalSeconds: true)

  private static func name(of date: Date) -> String { date.formatted(style) }

  private static func date(of name: String) -> Date? { try? style.parse(name) }
}
