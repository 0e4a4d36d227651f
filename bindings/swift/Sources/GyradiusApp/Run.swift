import Foundation
import GyradiusKit

/// What one look at a procedure under way shows.
public struct Look: Sendable {
  /// Everything that the screens show.
  public let state: ProcedureState
  /// What came since the last look.
  public let found: [Samples]
  /// Streams that have stopped.
  public let silent: Set<Channel>
  /// What could not be kept.
  public let failure: GyradiusError?
}

/// A procedure under way: on a real hull or on a simulated one.
public protocol Run: Sendable {
  /// The sensors that it listens to.
  var sensors: [PhoneSensor] { get }

  /// Takes in what came since the last look; where time is simulated, lets so much of it go by, s.
  func look(afterS seconds: Double) async -> Look

  /// Takes what the operator did.
  func handle(_ event: ProcedureEvent) async throws

  /// What an operator who plays by the book does now; known only where the hull is simulated.
  func byTheBook(atUtc: String) async throws -> ProcedureEvent?

  /// Does the work that is wanted: seconds or minutes. The rest goes on meanwhile.
  func work(onProgress: @escaping OnProgress) async throws

  /// Ends it; it is kept, and goes on where it stands.
  func close() async
}

/// A real hull, on what a source gives.
public actor Measuring: Run {
  public nonisolated let sensors: [PhoneSensor]
  private nonisolated let procedure: Procedure
  private let source: any MotionSource
  private var silence: Silence
  private var newestNs: Int64 = 0
  /// Of what has stopped, what the recording under way knows.
  private var told: Set<Channel> = []

  private init(_ procedure: Procedure, _ source: any MotionSource) {
    self.procedure = procedure
    self.source = source
    sensors = source.sensors
    silence = Silence(of: source.sensors.map(\.channel))
    source.open()
  }

  /// Begins in a folder.
  public static func create(in folder: URL, task: ProcedureTask, source: any MotionSource) throws -> Measuring {
    Measuring(try Procedure.create(folder: folder.path, task: task), source)
  }

  /// Goes on with what was left in a folder.
  public static func open(in folder: URL, source: any MotionSource) throws -> Measuring {
    Measuring(try Procedure.open(folder: folder.path), source)
  }

  public func look(afterS seconds: Double) -> Look {
    (source as? any TimedSource)?.letGoBy(seconds: seconds)
    var (found, failure): ([Samples], GyradiusError?) = ([], nil)
    do {
      found = try source.take()
      let stopped = silence.look(found)
      try push(found)
      try tell(stopped)
    } catch {
      failure = error as? GyradiusError
    }
    return Look(state: procedure.state(), found: found, silent: silence.silent, failure: failure)
  }

  /// What came before it is taken in before it: a recording that is stopped has all samples up to then.
  public func handle(_ event: ProcedureEvent) throws {
    try push(source.take())
    try procedure.handle(event: event)
  }

  public func byTheBook(atUtc: String) -> ProcedureEvent? { nil }

  public nonisolated func work(onProgress: @escaping OnProgress) async throws {
    try await procedure.work(onProgress: onProgress)
  }

  public func close() {
    source.close()
    // What cannot be kept at the end was told of before it: the disk is full.
    try? push(source.take())
  }

  /// Every batch is offered, whatever became of the one before: the library says which it can still use.
  private func push(_ batches: [Samples]) throws {
    let outcomes = batches.map { batch in Result { try procedure.push(batch) } }
    newestNs = batches.compactMap(\.stampsNs.last).reduce(newestNs, max)
    for outcome in outcomes { try outcome.get() }
  }

  /// It then stands in the recording itself, and whoever judges it knows.
  private func tell(_ stopped: Set<Channel>) throws {
    let isRecording = procedure.state().phase == .record
    let news = isRecording ? stopped.subtracting(told) : []
    told = isRecording ? stopped : []
    for sensor in news.compactMap(\.sensor) {
      try procedure.handle(event: .sensorStopped(sensor: sensor, stampNs: newestNs))
    }
  }
}

/// A simulated hull: practice.
public actor Practising: Run {
  public nonisolated let sensors: [PhoneSensor] = []
  private nonisolated let rehearsal: Rehearsal

  private init(_ rehearsal: Rehearsal) {
    self.rehearsal = rehearsal
  }

  /// Goes on with a practice that was left in a folder, or begins there under a title.
  public static func of(_ folder: URL, rigText: String, title: String, seed: UInt64) throws -> Practising {
    let rig = try Rig.parse(text: rigText, name: "practice")
    let isKnown = SessionStore.hasProcedure(folder)
    return Practising(
      isKnown
        ? try Rehearsal.open(folder: folder.path, rig: rig, seed: seed)
        : try Rehearsal.create(folder: folder.path, rig: rig.titled(title: title), seed: seed)
    )
  }

  public func look(afterS seconds: Double) -> Look {
    let advanced = Result { try rehearsal.advance(seconds: seconds) }
    var failure: GyradiusError?
    if case .failure(let error) = advanced { failure = error as? GyradiusError }
    return Look(state: rehearsal.state(), found: rehearsal.heard().map(\.samples), silent: [], failure: failure)
  }

  public func handle(_ event: ProcedureEvent) throws {
    try rehearsal.handle(event: event)
  }

  public func byTheBook(atUtc: String) throws -> ProcedureEvent? {
    try rehearsal.byTheBook(atUtc: atUtc)
  }

  public nonisolated func work(onProgress: @escaping OnProgress) async throws {
    try await rehearsal.work(onProgress: onProgress)
  }

  public func close() {}
}
