// STUB: what the UI tests use of Apple's XCTest, as we read its documentation. It checks names and types, and does nothing.
import Foundation

open class XCTestCase {
  public init() {}
  open var continueAfterFailure: Bool = true
  open func setUpWithError() throws {}
}

@MainActor public protocol XCUIElementTypeQueryProvider {}
extension XCUIElementTypeQueryProvider {
  public var buttons: XCUIElementQuery { fatalError() }
  public var textFields: XCUIElementQuery { fatalError() }
  public var navigationBars: XCUIElementQuery { fatalError() }
}

@MainActor open class XCUIElementQuery: XCUIElementTypeQueryProvider {
  open subscript(key: String) -> XCUIElement { fatalError() }
  open var firstMatch: XCUIElement { fatalError() }
}

@MainActor open class XCUIElement: XCUIElementTypeQueryProvider {
  open var exists: Bool { false }
  open func tap() {}
  open func typeText(_ text: String) {}
  open func swipeUp() {}
  open func waitForExistence(timeout: TimeInterval) -> Bool { false }
}

public struct XCUIAccessibilityAuditType: OptionSet, Sendable {
  public let rawValue: UInt64
  public init(rawValue: UInt64) { self.rawValue = rawValue }
  public static let all = XCUIAccessibilityAuditType(rawValue: .max)
}

@MainActor open class XCUIApplication: XCUIElement {
  public override init() {}
  open var launchArguments: [String] = []
  open func launch() {}
  open func terminate() {}
  open func performAccessibilityAudit(for auditTypes: XCUIAccessibilityAuditType = .all) throws {}
}

public func XCTAssertTrue(_ expression: @autoclosure () throws -> Bool, _ message: @autoclosure () -> String = "") {}
