extension GyradiusError {
  /// What went wrong, in a sentence that says where.
  public var text: String {
    switch self {
    case .BadFile(let text, _, _), .Unwritable(let text, _), .DiskFull(let text, _), .NoResult(let text, _),
      .BadArgument(let text, _), .Cancelled(let text):
      text
    }
  }
}
