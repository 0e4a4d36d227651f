import Foundation
import GyradiusKit

/// What went wrong, for a screen to say.
public enum Failure: Equatable, Sendable {
  /// No room is left on the phone: the app has its own words for it.
  case diskFull
  /// What the library or the system says of it.
  case told(String)

  /// What an error comes to, whether the library or the system has met it.
  init(_ error: any Error) {
    if case .DiskFull? = error as? GyradiusError {
      self = .diskFull
    } else if (error as? CocoaError)?.code == .fileWriteOutOfSpace {
      self = .diskFull
    } else {
      self = .told(sentence(of: error))
    }
  }
}

/// What an error says by itself.
func sentence(of error: any Error) -> String {
  (error as? GyradiusError)?.text ?? error.localizedDescription
}
