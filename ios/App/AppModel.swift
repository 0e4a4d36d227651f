import Foundation
import GyradiusApp
import GyradiusKit
import Observation

/// What lives as long as the app does: the sessions, the procedure under way, and what is told to an operator who stands aside.
@MainActor @Observable
final class AppModel {
  let sessions = SessionsModel(SessionStore(documents: .documentsDirectory, support: .applicationSupportDirectory))
  let procedure = ProcedureModel()
  let settings = GyradiusApp.Settings()
  private let announcer = Announcer()

  init() {
    procedure.onState = { [settings, announcer] before, now in
      guard let cue = Cue.of(before, now) else { return }
      if settings.isAloud { announcer.say(cue) }
      if settings.isFelt { announcer.tap(cue) }
    }
  }

  /// Whether the procedure covers the screen. Nothing but `leave` ends it: what a view sets here is not heard.
  var isUnderWay: Bool {
    get { procedure.state != nil }
    set {}
  }

  /// A touch of a wet sleeve must not cut a recording off.
  var mayLeave: Bool { !procedure.isListening || procedure.state?.phase != .record }

  /// A boat is measured as it was planned.
  func measure(_ task: ProcedureTask, limits: [String]) async {
    guard let folder = sessions.create(title: task.title, limits: limits) else { return }
    await begin { await $0.measure(in: folder, task: task, source: CoreMotionSource()) }
  }

  /// Goes on with a session that was left.
  func goOn(with session: Listed) async {
    await begin { await $0.goOn(in: session.folder, source: CoreMotionSource()) }
  }

  /// The practice on a simulated hull, from its beginning or from where it was left.
  func practise(afresh: Bool) async {
    guard let folder = afresh ? sessions.practiceAfresh() : sessions.store.practice else { return }
    // It comes with the app.
    let rigText = try! String(
      contentsOf: Bundle.main.url(forResource: "keelboat", withExtension: "toml")!, encoding: .utf8)
    await begin { await $0.practise(in: folder, rigText: rigText, title: Words.practiceTitle, seed: 1) }
  }

  /// Leaves the procedure; it is kept.
  func leave() async {
    await procedure.leave()
    await refresh()
  }

  /// Reads the list of sessions anew, unless one of them is under way: a procedure has one owner.
  func refresh() async {
    if !isUnderWay { await sessions.refresh() }
  }

  /// The session of the procedure under way, once it can be measured.
  var measurable: Measurable? { procedure.folder.flatMap { sessions.store.measurable($0) } }

  /// The name of the phone's model, as Apple numbers them: sensors differ by it.
  static var phone: String {
    var system = utsname()
    uname(&system)
    return withUnsafeBytes(of: &system.machine) { String(decoding: $0.prefix { $0 != 0 }, as: UTF8.self) }
  }

  private func begin(_ what: (ProcedureModel) async -> Void) async {
    await what(procedure)
    procedure.goOnLooking()
  }
}
