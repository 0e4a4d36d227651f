import Foundation
import GyradiusKit
import Observation

/// How much of the phone an app has.
public enum Presence: Sendable {
  /// The screen and the fingers.
  case active
  /// The screen, or a part of it.
  case inactive
  /// Neither, and soon no time.
  case background
}

/// The procedure under way. It lives as long as the app: screens come and go while a hull swings. The library is never called
/// from the main actor.
@MainActor @Observable
public final class ProcedureModel {
  /// Between two looks at what came, s.
  public static let lookS = 0.1

  /// Everything that the screens show; absent while nothing is under way.
  public private(set) var state: ProcedureState?
  /// Where it is kept.
  public private(set) var folder: URL?
  public private(set) var isPractice = false
  /// How much of the work under way is done, 0 to 1.
  public private(set) var workShare: Double?
  /// The work that is wanted has failed, and waits for `workAgain`.
  public private(set) var isWorkStuck = false
  public private(set) var error: Failure?
  /// Simulated seconds that go by in one; only in practice.
  public var pace = 1
  /// What the sensors give.
  public let recorder = RecorderModel()
  /// Follows the states: sound, voice and touch.
  public var onState: ((_ before: ProcedureState, _ now: ProcedureState) -> Void)?

  private let now: @Sendable () -> Date
  private var run: (any Run)?
  private var looking: Task<Void, Never>?
  private var working: Task<Void, Never>?
  private var workBegun: ProcedureWork?

  public init(now: @escaping @Sendable () -> Date = { Date() }) {
    self.now = now
  }

  /// Whether the phone's sensors are listened to: the screen then stays on.
  public var isListening: Bool { run != nil && !isPractice }

  /// Goes on with the practice in a folder, or begins one there under a title.
  public func practise(in folder: URL, rigText: String, title: String, seed: UInt64) async {
    await begin(in: folder, isPractice: true) {
      try Practising.of(folder, rigText: rigText, title: title, seed: seed)
    }
  }

  /// Begins a measurement in a folder, on what a source gives.
  public func measure(in folder: URL, task: ProcedureTask, source: any MotionSource) async {
    await begin(in: folder, isPractice: false) {
      try Measuring.create(in: folder, task: task, source: source)
    }
  }

  /// Goes on with the measurement in a folder.
  public func goOn(in folder: URL, source: any MotionSource) async {
    await begin(in: folder, isPractice: false) { try Measuring.open(in: folder, source: source) }
  }

  /// Begins, phone and placement told; in practice the book says which.
  public func start(phone: String, placement: Placement) async {
    let info = PhoneInfo(model: phone, sensors: recorder.sensors)
    await act {
      try await $0.handle(.begin(atUtc: self.utc, measuredOn: self.today, phone: info, placement: placement))
    }
  }

  /// The recording begins.
  public func record() async {
    await act { try await $0.handle(.startRecording(atUtc: self.utc)) }
  }

  /// What an operator who plays by the book does now; only in practice, where it types in what the tape says.
  public func byTheBook() async {
    await act { run in
      guard let event = try await run.byTheBook(atUtc: self.utc) else { return }
      try await run.handle(event)
    }
  }

  /// Takes what the operator did.
  public func handle(_ event: ProcedureEvent) async {
    await act { try await $0.handle(event) }
  }

  /// Tries the work once more that failed.
  public func workAgain() {
    workBegun = nil
  }

  /// One look at what came since the last one.
  public func look(afterS seconds: Double = lookS) async {
    guard let run else { return }
    show(await run.look(afterS: Double(pace) * seconds))
    workAsWanted(run)
  }

  /// Follows the app as iOS moves it. A lock of the screen sends it to the background, and so does a call that is taken; the banner
  /// of a call, or the list of apps, makes it inactive for a moment: it still has time and samples, and is not told whether
  /// the background comes next.
  public func follow(_ presence: Presence) async {
    switch presence {
    case .active: goOnLooking()
    case .inactive: await look(afterS: 0)
    case .background: await pauseLooking()
    }
  }

  /// Looks again and again, until the app leaves the screen.
  public func goOnLooking() {
    guard run != nil, looking == nil else { return }
    looking = Task {
      while !Task.isCancelled {
        await look()
        try? await Task.sleep(for: .seconds(Self.lookS))
      }
    }
  }

  /// The app leaves the screen: iOS gives it no time and no samples until it comes back. What came so far is on the disk, and
  /// the gap will stand in the recording.
  public func pauseLooking() async {
    looking?.cancel()
    looking = nil
    await look(afterS: 0)
  }

  /// Leaves it; it is kept, and goes on where it stands.
  public func leave() async {
    looking?.cancel()
    working?.cancel()
    await working?.value
    await run?.close()
    (run, looking, working, workBegun) = (nil, nil, nil, nil)
    (state, folder, workShare, isWorkStuck) = (nil, nil, nil, false)
    recorder.begin([])
  }

  /// Waits for the work under way, if there is any.
  func workDone() async {
    await working?.value
  }

  private func begin(in folder: URL, isPractice: Bool, _ make: @escaping @Sendable () throws -> any Run) async {
    await leave()
    error = nil
    do {
      let made = try await Task.detached(operation: make).value
      (run, self.folder, self.isPractice, pace) = (made, folder, isPractice, 1)
      recorder.begin(made.sensors)
      await look(afterS: 0)
    } catch {
      self.error = Failure(error)
    }
  }

  private func act(_ what: (any Run) async throws -> Void) async {
    guard let run else { return }
    error = nil
    do {
      try await what(run)
    } catch {
      self.error = Failure(error)
    }
    await look(afterS: 0)
  }

  private func show(_ look: Look) {
    if let failure = look.failure { error = Failure(failure) }
    recorder.see(look)
    let before = state
    // Views are drawn anew only where something changed.
    guard before != look.state else { return }
    state = look.state
    if let before { onState?(before, look.state) }
  }

  /// Begins the work that is newly wanted, and stops what is wanted no more. What failed is not begun again by itself.
  private func workAsWanted(_ run: any Run) {
    guard let wanted = state.map(\.work), wanted != workBegun else { return }
    workBegun = wanted
    working?.cancel()
    (workShare, isWorkStuck) = (nil, false)
    guard wanted != nil else { return }
    working = Task { await work(run, wanted) }
  }

  private func work(_ run: any Run, _ wanted: ProcedureWork?) async {
    do {
      try await run.work { share, _ in Task { @MainActor in self.told(share, of: wanted) } }
    } catch is CancellationError {
      return
    } catch {
      (isWorkStuck, self.error) = (true, Failure(error))
    }
    workShare = nil
  }

  private func told(_ share: Double, of work: ProcedureWork?) {
    if workBegun == work, state?.work == work, !isWorkStuck { workShare = share }
  }

  private var utc: String { now().formatted(.iso8601) }

  /// The date where the phone is.
  private var today: String { now().formatted(Date.ISO8601FormatStyle(timeZone: .current).year().month().day()) }
}
