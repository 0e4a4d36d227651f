// STUB: what the app uses of Apple's Foundation, which has these on Apple's systems alone, as we read its documentation. It checks names and types, and does nothing.
extension URL {
  public static var documentsDirectory: URL { fatalError() }
  public static var applicationSupportDirectory: URL { fatalError() }
  public func startAccessingSecurityScopedResource() -> Bool { false }
  public func stopAccessingSecurityScopedResource() {}
}

open class NSFileCoordinator {
  public struct ReadingOptions: OptionSet, Sendable {
    public let rawValue: UInt
    public init(rawValue: UInt) { self.rawValue = rawValue }
    public static let forUploading = ReadingOptions(rawValue: 8)
  }
  public init() {}
  open func coordinate(
    readingItemAt url: URL, options: ReadingOptions = [], error outError: UnsafeMutablePointer<NSError?>?,
    byAccessor reader: (URL) -> Void
  ) {}
}
