// STUB: what the app uses of Apple's UIKit, as we read its documentation. It checks names and types, and does nothing.
@_exported import Foundation

@MainActor open class UIResponder {}

@MainActor open class UIApplication: UIResponder {
  public class var shared: UIApplication { fatalError() }
  open var isIdleTimerDisabled: Bool = false
}

open class UIColor {
  open class var systemBackground: UIColor { fatalError() }
  open class var secondarySystemBackground: UIColor { fatalError() }
}

@MainActor open class UIFeedbackGenerator {
  public init() {}
}

@MainActor open class UINotificationFeedbackGenerator: UIFeedbackGenerator {
  public enum FeedbackType: Int, Sendable { case success, warning, error }
  open func notificationOccurred(_ notificationType: FeedbackType) {}
}

public enum UIAccessibility {
  public struct Notification: Sendable {
    public static let announcement = Notification()
  }
  @MainActor public static func post(notification: Notification, argument: Any?) {}
}

public enum UIKeyboardType: Int, Sendable { case `default`, numbersAndPunctuation, decimalPad }
