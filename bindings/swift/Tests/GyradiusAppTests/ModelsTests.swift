import Foundation
import GyradiusKit
import TestSupport
import Testing

@testable import GyradiusApp

/// The models beside the procedure.
@MainActor @Suite struct ModelsTests {
  private let folder: TemporaryFolder
  private let sessions: SessionsModel

  init() throws {
    folder = try TemporaryFolder()
    sessions = SessionsModel(SessionStore(documents: folder.url, support: folder.url))
  }

  private func shipped(_ name: String) -> URL { root.appending(path: "python/gyradius/sessions/\(name)") }

  @Test func aPlanIsMadeOfWhatIsTypedIn() async throws {
    let setup = SetupModel()
    await setup.makePlan()
    #expect(setup.error != nil && setup.plan == nil)
    (setup.title, setup.massKg, setup.lengthM, setup.beamM, setup.boatType) = ("Finn", 120, 4.5, 1.5, "dinghy")
    setup.known[typed: "k_yaw_m"].value = 1.1
    #expect(setup.request.hull.kYawM == nil)
    setup.known[typed: "k_yaw_m"].u = 0.02
    setup.wanted = ["k_yaw": 0.5]
    setup.means.mostLineLengthM = 2.5
    setup.means.rateHz = nil
    setup.limits = [TypedLimit(quantity: "k_yaw_m"), TypedLimit(quantity: "k_pitch_m")]
    setup.limits[0].value = 1.05
    #expect(setup.limitTexts == ["k_yaw_m>=1.05"])
    await setup.makePlan()
    let plan = try #require(setup.plan)
    #expect(setup.error == nil && setup.task?.title == "Finn")
    #expect(plan.means.rateHz == usualMeans().rateHz && plan.means.mostLineLengthM == 2.5)
    #expect(plan.hull.kYawM == Quantity(value: 1.1, u: 0.02))
    let longest = plan.steps.compactMap { $0.swing?.suspension.lineLengthM?.value }.max()
    #expect(try #require(longest) <= 2.5)
    let yaw = try #require(plan.quantities.first { $0.name == "k_yaw_m" }).quantity
    #expect(try abs(#require(yaw.wantedU) - 0.005 * yaw.value) < 1e-12)
  }

  @Test func sessionsAreListedTakenInDeletedAndHadBack() async throws {
    await sessions.refresh()
    #expect(sessions.listed.isEmpty && !sessions.isPracticeLeft)
    await sessions.take(shipped("boat-park").appending(path: "yaw-sway.csv"))
    #expect(sessions.error == nil)
    let one = try #require(sessions.listed.first)
    #expect(one.phase == nil && one.damage == nil && !one.title.isEmpty && one.at != nil)
    let measurable = try #require(sessions.store.measurable(one.folder))
    #expect(measurable.session.lastPathComponent == "imported-yaw-sway.csv")
    sessions.delete(one)
    #expect(sessions.listed.isEmpty)
    await sessions.undo()
    #expect(sessions.listed == [one])
    sessions.delete(one)
    sessions.forget()
    await sessions.refresh()
    #expect(sessions.listed.isEmpty && !FileManager.default.fileExists(atPath: one.folder.path))
  }

  @Test func whatIsNoSessionIsRefusedAndLeavesNothing() async throws {
    let file = folder.url.appending(path: "shopping.txt")
    try "milk, bread".write(to: file, atomically: true, encoding: .utf8)
    await sessions.take(file)
    #expect(sessions.error != nil && sessions.listed.isEmpty)
    #expect(!FileManager.default.fileExists(atPath: sessions.store.root.path))
  }

  @Test func aSessionUnderWayIsListedWithItsPhaseAndADamagedOneWithItsReason() async throws {
    let setup = SetupModel()
    (setup.title, setup.massKg, setup.lengthM, setup.beamM) = ("Finn", 120, 4.5, 1.5)
    await setup.makePlan()
    let folder = try #require(sessions.create(title: "Finn", limits: ["k_yaw_m>=1.0"]))
    let model = ProcedureModel()
    await model.measure(in: folder, task: try #require(setup.task), source: PlayedSource(name: "phone"))
    await model.leave()
    await sessions.refresh()
    #expect(sessions.listed.map(\.phase) == [.start] && sessions.listed.map(\.title) == ["Finn"])
    #expect(sessions.store.measurable(folder) == nil)
    try Data().write(to: folder.appending(path: "procedure.journal"))
    await sessions.refresh()
    #expect(sessions.listed.first?.damage?.isEmpty == false)
  }

  @Test func aResultIsMeasuredJudgedAndReported() async throws {
    let critique = root.appending(path: "core/crates/report/tests/it/report/critiques/ambiguous.json")
    let kept = try sessions.store.create(title: "keelboat", limits: ["k_yaw_m>=1.000"])
    try FileManager.default.copyItem(at: critique, to: kept.appending(path: "critique.json"))
    let measurable = Measurable(
      session: shipped("keelboat"), title: "keelboat", limits: sessions.store.usualLimits, folder: kept)
    let model = ResultModel()
    await model.open(measurable)
    #expect(model.error == nil && model.share == nil)
    #expect(model.result?.verdicts.map(\.quantity) == ["k_yaw_m"])
    #expect(model.criticism.critique?.verdict.status == "ambiguous")
    let limits = ["k_yaw_m<=1.200", "k_yaw_m>=1.000"]
    await model.judge(by: limits, keepingIn: sessions.store)
    #expect(model.result?.verdicts.count == 2 && model.limits == limits)
    // Kept with the session, and offered for the next.
    #expect(sessions.store.usualLimits == limits)
    #expect(
      try String(contentsOf: kept.appending(path: "limits.txt"), encoding: .utf8) == limits.joined(separator: "\n"))
    let report = try #require(await model.report(into: folder.url))
    let html = try String(contentsOf: report, encoding: .utf8)
    #expect(html.contains("gyradius-critique") && html.contains("probability that the hull conforms"))
    await model.judge(by: ["k_yaw"], keepingIn: sessions.store)
    #expect(model.error != nil && model.result?.verdicts.count == 2)
    #expect(sessions.store.usualLimits == limits)
  }

  @Test func aCriticismIsMadeOfASession() async throws {
    let model = ResultModel()
    let measurable = Measurable(session: shipped("keelboat"), title: "", limits: [], folder: folder.url)
    await model.open(measurable)
    #expect(model.criticism.critique == nil)
    await model.criticism.criticise()
    #expect(model.criticism.error == nil && model.criticism.share == nil)
    let made = try #require(model.criticism.critique)
    #expect(made.format == "gyradius-critique/1")
    let german = sentenceIn(sentence: made.verdict.message, language: .german)
    #expect(german != made.verdict.message.english && german.contains("Widersprüche"))
    // It is there when the session is opened again.
    let again = ResultModel()
    await again.open(measurable)
    #expect(again.criticism.critique == made)
  }

  @Test(.timeLimit(.minutes(10)))
  func aCriticismIsKeptWithItsCurves() async throws {
    let rig = try String(contentsOf: root.appending(path: "python/gyradius/rigs/keelboat.toml"), encoding: .utf8)
    let drag = "\n[[effect]]\nid = \"quadratic_drag\"\nyaw_torque_coefficient = 30.0\n"
    let session = folder.url.appending(path: "session")
    try Rig.parse(text: rig + drag, name: "drag").write(
      folder: session.path, truthFile: folder.path("truth.json"), seed: 1, overwrite: .refuse)
    let measurable = Measurable(session: session, title: "", limits: [], folder: folder.url)
    let model = ResultModel()
    await model.open(measurable)
    await model.criticism.criticise()
    let curves = model.criticism.compared
    #expect(!curves.isEmpty && curves.allSatisfy { !$0.measured.y.isEmpty })
    let again = ResultModel()
    await again.open(measurable)
    #expect(again.criticism.compared == curves)
  }

  @Test func settingsAreKept() throws {
    let name = UUID().uuidString
    let defaults = try #require(UserDefaults(suiteName: name))
    defer { defaults.removePersistentDomain(forName: name) }
    let settings = Settings(defaults)
    #expect(settings.isAloud && settings.isFelt && settings.placement == .flatTopToBow)
    (settings.isAloud, settings.isFlat) = (false, false)
    let again = Settings(defaults)
    #expect(!again.isAloud && again.isFelt && again.placement == .anyWay)
  }

  @Test func figuresShowTheUncertaintyWithTwoDigits() {
    let english = Locale(identifier: "en")
    #expect(withUncertainty(1.09346, 0.00123, locale: english) == ("1.0935", "0.0012"))
    #expect(withUncertainty(1.09345, 0.0996, locale: english) == ("1.09", "0.10"))
    #expect(withUncertainty(9.806, 12.3, locale: english) == ("10", "12"))
    #expect(withUncertainty(1.5, 0.02, locale: Locale(identifier: "de")) == ("1,500", "0,020"))
    #expect(withUncertainty(-5.52, 0.65, locale: english) == ("−5.52", "0.65"))
    #expect(withUncertainty(1.5, 0, locale: english) == ("1.5000", "–"))
  }

  @Test func aLimitThatWasKeptStandsInItsFieldsAgain() throws {
    var typed = try #require(TypedLimit("k_pitch_m<=1.18"))
    #expect((typed.quantity, typed.isLeast, typed.value) == ("k_pitch_m", false, 1.18))
    #expect(typed.text == "k_pitch_m<=1.18")
    typed.isLeast = true
    #expect(typed.text == "k_pitch_m>=1.18")
    #expect(TypedLimit("mast_m<=1.18") == nil && TypedLimit("k_pitch_m") == nil && TypedLimit("k_yaw_m>=a") == nil)
    #expect(SetupModel(usualLimits: ["k_yaw_m>=1.1", "?"]).limitTexts == ["k_yaw_m>=1.1"])
  }

  @Test func numbersAreReadAsPeopleTypeThem() {
    #expect(number(in: " 1,25 ") == 1.25 && number(in: "-0.5") == -0.5)
    #expect(number(in: "") == nil && number(in: "a yard") == nil && number(in: "inf") == nil)
    #expect(asTyped(9.806650001, locale: Locale(identifier: "de")) == "9,80665")
    #expect(asTyped(12345, locale: Locale(identifier: "en")) == "12345")
    #expect(asTyped(0.00012, locale: Locale(identifier: "en")) == "0.00012")
  }

  @Test func aSentenceOfTheLibraryIsShownWithACapitalAndItsUnitsStayWithTheirFigures() {
    #expect(
      asShown("the gyroscope has 2 gaps, the longest of 0.51 s")
        == "The gyroscope has 2 gaps, the longest of 0.51\u{A0}s")
    #expect(asShown("über 3 m und 2 min: 9.8 m/s²") == "Über 3\u{A0}m und 2\u{A0}min: 9.8\u{A0}m/s²")
    // No word begins with k_yaw, and steps are no seconds.
    #expect(asShown("k_yaw in 4 steps of 5 %") == "k_yaw in 4 steps of 5\u{A0}%")
    #expect(withUnit("3.1 ± 0.2\u{A0}°") == "3.1 ± 0.2°")
    #expect(withUnit("3.1 ± 0.2\u{A0}m") == "3.1 ± 0.2\u{A0}m")
  }

  @Test func aStepAsksForWhatItsHangingHasAndTakesItOnceAllIsThere() async throws {
    let rig = try String(contentsOf: root.appending(path: "python/gyradius/rigs/keelboat.toml"), encoding: .utf8)
    let model = ProcedureModel()
    await model.practise(in: folder.url, rigText: rig, title: "Kielboot", seed: 1)
    model.pace = 60
    while model.state?.phase != .hang {
      await model.byTheBook()
      await model.look()
    }
    let step = try #require(model.state?.step)
    var form = HangingForm(step)
    #expect(form.measured?.lineLengthM == step.hanging?.lineLengthM)
    #expect(form.measured?.spacingM == step.hanging?.spacingM)
    #expect(form.measured?.massKg == nil)
    let at = try #require(form.entries.firstIndex { $0.id == .spacingM })
    form.entries[at].typed = TypedQuantity(value: 0.81)
    #expect(form.measured == nil)
    form.entries[at].typed.u = -0.003
    #expect(form.measured == nil)
    form.entries[at].typed.u = 0.003
    #expect(form.measured?.spacingM == Quantity(value: 0.81, u: 0.003))
    await model.leave()
  }

  @Test func headlinesBeginWithTheGyradiiAndAreNumbers() {
    let one = QuantityResult(value: .scalar(value: 1), u: .scalar(value: 0.1), interval95: nil, method: "")
    let many = QuantityResult(
      value: .vector(values: [1, 2]), u: .vector(values: [0.1, 0.1]), interval95: nil, method: "")
    let named = [("mass_kg", one), ("psi_deg", one), ("axes_m", many), ("k_pitch_m", one), ("k_yaw_m", one)]
    let shown = headlines(named.map { NamedQuantity(name: $0, quantity: $1) })
    #expect(shown.map(\.name) == ["k_yaw_m", "k_pitch_m", "psi_deg", "mass_kg"])
  }

  @Test func cuesTellWhoDoesNotLook() async throws {
    let rig = try String(contentsOf: root.appending(path: "python/gyradius/rigs/keelboat.toml"), encoding: .utf8)
    let rehearsal = try Rehearsal.create(
      folder: folder.url.path, rig: Rig.parse(text: rig, name: "practice"), seed: 1)
    try rehearsal.mishap(step: "yaw-sway", take: 1, what: "touch")
    try rehearsal.mishap(step: "surge-pitch", take: 1, what: "slip")
    var (told, before): ([Cue], ProcedureState) = ([], rehearsal.state())
    while before.phase != .measure {
      if let event = try rehearsal.byTheBook(atUtc: "2026-05-04T09:30:00Z") {
        try rehearsal.handle(event: event)
      } else {
        _ = try rehearsal.advance(seconds: 0.5)
      }
      let now = rehearsal.state()
      if let cue = Cue.of(before, now), told.last != cue { told.append(cue) }
      before = now
    }
    #expect(told.prefix(4) == [.good, .releaseNow, .recording, .touched])
    #expect(told.contains(.repeat))
    #expect(told.last == .good)
  }
}
