import Foundation
import Testing

@testable import GyradiusKit

/// Long work tells how far it is, and stops when nobody wants it any more.
@Suite struct WorkTests {
  // Five swings with samples: its criticism takes a minute or more.
  private let session: Session

  init() throws {
    session = try Session.load(path: Shared.session("boat-park").path, mapping: [])
  }

  @Test(.timeLimit(.minutes(5)))
  func aCriticismIsCancelledHalfWayWithItsTask() async throws {
    let (told, telling) = AsyncStream.makeStream(of: Double.self)
    let work = Task {
      try await session.critique { share, doing in
        #expect(!doing.isEmpty)
        telling.yield(share)
      }
    }
    var shares: [Double] = []
    for await share in told {
      shares.append(share)
      if share > 0 {
        work.cancel()
        break
      }
    }
    await #expect(throws: CancellationError.self) { try await work.value }
    #expect(shares == shares.sorted())
    #expect(shares.last.map { $0 < 1 } == true)
    // The session is as good as before.
    #expect(session.swingIds().count == 5)
  }

  @Test func aTaskThatIsCancelledAlreadyDoesNoWork() async throws {
    let late = Task {
      withUnsafeCurrentTask { $0?.cancel() }
      return try await session.critique()
    }
    await #expect(throws: CancellationError.self) { try await late.value }
  }

  @Test func whatTheListenerThrowsStopsTheWorkAndIsThrown() async {
    struct Enough: Error {}
    await #expect(throws: Enough.self) {
      try await session.critique { _, _ in throw Enough() }
    }
  }

  @Test func aListenerThatAnswersNoGetsCancelled() async throws {
    let no = Listener { _ in false }
    guard case .Cancelled = try await thrown({ try session.critiqueBlocking(listener: no) }),
      case .Cancelled = try await thrown({ try session.measureBlocking(limits: [], listener: no) })
    else {
      Issue.record("not cancelled")
      return
    }
  }

  @Test func aMeasurementStopsBetweenTwoSwings() async throws {
    let untilSecond = Listener { $0.count < 2 }
    guard case .Cancelled = try await thrown({ try session.measureBlocking(limits: [], listener: untilSecond) })
    else {
      Issue.record("not cancelled")
      return
    }
    #expect(untilSecond.told == ["reading yaw-sway", "reading surge-pitch"])
  }

  @Test(.timeLimit(.minutes(5)))
  func workAsAStreamEndsWithWhatCameOfIt() async throws {
    var (shares, done): ([Double], Analysis?) = ([], nil)
    let measured = working { try await Session.load(Shared.session("keelboat")).measure(onProgress: $0) }
    for try await step in measured {
      switch step {
      case .going(let share, _): shares.append(share)
      case .done(let analysis): done = analysis
      }
    }
    #expect(shares.count > 3 && shares.first == 0 && shares == shares.sorted())
    #expect(try done?.json().contains("gyradius-measurement/1") == true)
  }

  @Test(.timeLimit(.minutes(5)))
  func whoIsCancelledWhileReadingStopsTheWork() async throws {
    let (begun, beginning) = AsyncStream.makeStream(of: Void.self)
    let (ended, ending) = AsyncStream.makeStream(of: (any Error).self)
    let session = session
    let criticism = working { onProgress in
      do {
        return try await session.critique(onProgress: onProgress)
      } catch {
        ending.yield(error)
        throw error
      }
    }
    let reading = Task { for try await _ in criticism { beginning.yield() } }
    for await _ in begun { break }
    reading.cancel()
    for await error in ended {
      #expect(error is CancellationError)
      break
    }
  }
}

/// Answers what it is made to; remembers what it was told.
private final class Listener: ProgressListener, @unchecked Sendable {
  private let lock = NSLock()
  private let goesOn: @Sendable ([String]) -> Bool
  private var doings: [String] = []

  init(goesOn: @escaping @Sendable ([String]) -> Bool) {
    self.goesOn = goesOn
  }

  var told: [String] { lock.withLock { doings } }

  func onProgress(share: Double, doing: String) -> Bool {
    lock.withLock {
      doings.append(doing)
      return goesOn(doings)
    }
  }
}
