import XCTest

/// The app's screens on a simulator, which has no sensors: a whole practice, a plan, what stays after a restart, and Apple's own
/// audit of what can be seen, touched and heard.
final class ScreensTests: XCTestCase {
  override func setUpWithError() throws {
    continueAfterFailure = false
  }

  @MainActor
  func testAPracticeComesToItsResult() {
    let app = launched()
    app.buttons["Practise on a simulated hull"].tap()
    app.buttons["60×"].tap()
    goThrough(app, until: app.navigationBars["Result"])
    XCTAssertTrue(app.buttons["All of the result"].exists)
  }

  @MainActor
  func testAPracticeIsGoneOnWithAfterAKill() {
    let app = launched()
    app.buttons["Practise on a simulated hull"].tap()
    app.buttons["Begin"].tap()
    XCTAssertTrue(app.navigationBars["Level"].waitForExistence(timeout: 10))
    app.terminate()
    app.launch()
    app.buttons["Go on with the last practice"].tap()
    XCTAssertTrue(app.navigationBars["Level"].waitForExistence(timeout: 10))
  }

  @MainActor
  func testABoatIsPlanned() {
    let app = launched()
    app.buttons["Measure a boat"].tap()
    for (label, text) in [("Mass of all that hangs, kg", "120"), ("Length overall, m", "4.5"), ("Beam, m", "1.5")] {
      app.textFields[label].tap()
      app.textFields[label].typeText(text)
    }
    app.swipeUp()
    app.buttons["Plan the swings"].tap()
    XCTAssertTrue(app.buttons["To the boat"].waitForExistence(timeout: 60))
  }

  @MainActor
  func testThePhoneSpeaksGerman() {
    let app = launched(language: "de")
    XCTAssertTrue(app.navigationBars["Messungen"].waitForExistence(timeout: 10))
    app.buttons["Ein Boot messen"].tap()
    XCTAssertTrue(app.buttons["Schwünge planen"].waitForExistence(timeout: 10))
  }

  @MainActor
  func testTheScreensPassApplesAudit() throws {
    let app = launched()
    try app.performAccessibilityAudit()
    app.buttons["Measure a boat"].tap()
    try app.performAccessibilityAudit()
    app.navigationBars.firstMatch.buttons.firstMatch.tap()
    app.buttons["About"].tap()
    try app.performAccessibilityAudit()
  }

  @MainActor
  private func launched(language: String = "en") -> XCUIApplication {
    let app = XCUIApplication()
    app.launchArguments = ["-AppleLanguages", "(\(language))"]
    app.launch()
    return app
  }

  /// Does what the screen offers first, as an operator would who agrees with everything.
  @MainActor
  private func goThrough(_ app: XCUIApplication, until end: XCUIElement) {
    let offers = ["Begin", "Accept", "As typed", "Start the recording"]
    for _ in 0..<300 where !end.exists {
      if let offer = offers.map({ app.buttons[$0] }).first(where: \.exists) { offer.tap() }
      _ = end.waitForExistence(timeout: 1)
    }
    XCTAssertTrue(end.exists)
  }
}
