// STUB: what the app uses of Apple's UniformTypeIdentifiers, as we read its documentation. It checks names and types, and does nothing.
public struct UTType: Hashable, Sendable {
  public static var item: UTType { fatalError() }
  public static var data: UTType { fatalError() }
  public static var zip: UTType { fatalError() }
  public static var html: UTType { fatalError() }
}
