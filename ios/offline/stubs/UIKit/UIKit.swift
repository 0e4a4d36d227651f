// STUB: what the app uses of Apple's UIKit, as we read its documentation. It checks names and types, and does nothing.
@_exported import Foundation

@MainActor open class UIResponder: NSObject {}

@MainActor open class UIApplication: UIResponder {
  public class var shared: UIApplication { fatalError() }
  open var isIdleTimerDisabled: Bool = false
  open var connectedScenes: Set<UIScene> { fatalError() }
}

@MainActor open class UIScene: UIResponder {}
@MainActor open class UIWindowScene: UIScene {
  open var keyWindow: UIWindow? { fatalError() }
}

@MainActor open class UIView: UIResponder {
  open var bounds: CGRect { fatalError() }
  open func viewPrintFormatter() -> UIViewPrintFormatter { fatalError() }
}
@MainActor open class UIWindow: UIView {}

public enum UIUserInterfaceIdiom: Int, Sendable { case unspecified, phone, pad }

@MainActor open class UIDevice: NSObject {
  open class var current: UIDevice { fatalError() }
  open var userInterfaceIdiom: UIUserInterfaceIdiom { fatalError() }
}

@MainActor open class UIPrintFormatter: NSObject {}
@MainActor open class UIViewPrintFormatter: UIPrintFormatter {}

@MainActor open class UIPrintInfo: NSObject {
  public enum OutputType: Int, Sendable { case general, photo, grayscale, photoGrayscale }
  public init(dictionary: [AnyHashable: Any]?) {}
  open var jobName: String = ""
  open var outputType: OutputType = .general
}

@MainActor open class UIPrintInteractionController: NSObject {
  public typealias CompletionHandler = (UIPrintInteractionController, Bool, (any Error)?) -> Void
  open class var shared: UIPrintInteractionController { fatalError() }
  open var printInfo: UIPrintInfo?
  open var printFormatter: UIPrintFormatter?
  @discardableResult
  open func present(animated: Bool, completionHandler: CompletionHandler?) -> Bool { fatalError() }
  @discardableResult
  open func present(from rect: CGRect, in view: UIView, animated: Bool, completionHandler: CompletionHandler?) -> Bool {
    fatalError()
  }
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
