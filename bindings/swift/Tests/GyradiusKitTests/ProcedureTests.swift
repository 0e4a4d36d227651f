import Foundation
import TestSupport
import Testing

@testable import GyradiusKit

private let second: Int64 = 1_000_000_000

/// The procedure as an app drives it, and its rehearsal to the end.
@Suite struct ProcedureTests {
  private let folder: TemporaryFolder

  init() throws {
    folder = try TemporaryFolder()
  }

  private func task() async throws -> ProcedureTask {
    let hull = RoughHull(massKg: 212, lengthM: 5.05, beamM: 1.6, boatType: "dinghy")
    return try await Plan.make(.usual(hull: hull, wanted: ["k_yaw=1%"])).task()
  }

  @Test func aRehearsalGoesByTheBookToTheResultAndIsNearTheTruth() async throws {
    let seed = UInt64.random(in: 0..<1 << 53)
    print("seed \(seed)")
    let rehearsal = try Rehearsal.create(folder: folder.url.path, rig: Shared.rig(), seed: seed)
    var phases: [ProcedurePhase] = []
    while rehearsal.state().phase != .critique {
      let state = rehearsal.state()
      if !phases.contains(state.phase) { phases.append(state.phase) }
      #expect(!state.instruction.english.isEmpty && !state.instruction.english.contains("{"))
      if let event = try rehearsal.byTheBook(atUtc: Shared.atUtc) {
        try rehearsal.handle(event: event)
      } else if state.work != nil {
        try await rehearsal.work()
      } else {
        _ = try rehearsal.advance(seconds: 5)
      }
    }
    #expect(phases == [.start, .level, .rest, .hang, .ready, .record, .judge, .measure])
    try rehearsal.handle(event: .skip)
    #expect(rehearsal.state().phase == .done)
    let result = try #require(rehearsal.state().result)
    for name in ["k_yaw_m", "k_pitch_m"] {
      let found = try #require(result.quantities.first { $0.name == name }).quantity
      let truth = try #require(rehearsal.truth().first { $0.name == name }).value
      let (value, u) = (try #require(found.value.number), try #require(found.u.number))
      // Off by more than five of its own uncertainties once in a million.
      #expect(abs(value - truth) < 5 * u, "\(name)")
    }
    let session = try await Session.load(folder.url.appending(path: "session"))
    #expect(session.swingIds() == ["yaw-sway", "surge-pitch"])
  }

  @Test func aProcedureKeepsEverySampleAndGoesOnWhereTheAppWasKilled() async throws {
    let file = folder.url.appending(path: try begin(task: await task()))

    let again = try Procedure.open(folder: folder.url.path)
    #expect(again.state().phase == .interrupted)
    #expect(again.state().actions.contains(.continue))
    try again.handle(event: .continue)
    try hangsStill(again, fromS: 66, untilS: 70)
    try again.handle(event: .stopRecording)
    #expect(again.state().phase == .judge)
    let judgement = try #require(again.state().judgement)
    #expect(judgement.recommend == .repeat)
    #expect(judgement.reasons.contains { $0.key == "reason_no_swing" })
    let tracks = try RecorderFile.read(path: file.path).samples()
    let recorded = try #require(tracks.first { $0.channel == .gyroscope }).stampsNs
    // Never more than half a second behind: what was told before the kill is there but for its last half second.
    let (before, after) = (recorded.filter { $0 < 66 * second }, recorded.filter { $0 >= 66 * second })
    #expect(after == (0..<400).map { 66 * second + 10_000_000 * $0 })
    #expect((450...500).contains(before.count))
    #expect(before == before.indices.map { 60 * second + 10_000_000 * Int64($0) })
  }

  /// Goes as far as five seconds of a recording, and leaves it as a kill does; the recording's file.
  private func begin(task: ProcedureTask) throws -> String {
    let procedure = try Procedure.create(folder: folder.url.path, task: task)
    let phone = PhoneInfo(model: "phone", sensors: [PhoneSensor(channel: .gyroscope, name: "gyro", fullScale: nil)])
    try procedure.handle(event: .begin(atUtc: Shared.atUtc, measuredOn: nil, phone: phone, placement: .flatTopToBow))
    try hangsStill(procedure, fromS: 0, untilS: 20)
    let tilt = try #require(procedure.state().tilt)
    #expect(tilt.against == .phonePlane)
    #expect(try abs(#require(tilt.bowUpDeg)) < 0.1)
    try procedure.handle(event: .accept)
    try hangsStill(procedure, fromS: 20, untilS: 40)
    let rest = try #require(procedure.state().rest?.found)
    #expect(abs(rest.gyroscope.rateHz - 100) < 0.01)
    #expect(try abs(#require(rest.gravityMS2) - 9.81) < 0.01)
    try procedure.handle(event: .accept)
    let planned = try #require(procedure.state().step?.planned.swing).suspension
    try procedure.handle(event: .measured(MeasuredDimensions(planned)))
    try procedure.handle(event: .startRecording(atUtc: Shared.atUtc))
    try hangsStill(procedure, fromS: 60, untilS: 65)
    return try #require(procedure.state().recording).file
  }

  /// A hull that hangs still, by a phone that lies flat.
  private func hangsStill(_ procedure: Procedure, fromS: Int64, untilS: Int64) throws {
    for start in stride(from: 100 * fromS, to: 100 * untilS, by: 20) {
      let stamps = (start..<start + 20).map { 10_000_000 * $0 }
      for (channel, up) in [(Channel.gyroscope, 0), (.accelerometer, 9.81)] {
        let values = (0..<60).map { Double.random(in: -1e-3...1e-3) + ($0 % 3 == 2 ? up : 0) }
        try procedure.push(Samples(channel: channel, stampsNs: stamps, values: values))
      }
    }
  }

  @Test func whatIsNotOfferedIsRefusedAndChangesNothing() async throws {
    let task = try await task()
    let procedure = try Procedure.create(folder: folder.url.path, task: task)
    let before = try procedure.stateJson()
    let error = try await thrown { try procedure.handle(event: .accept) }
    guard case .BadArgument(let text, _) = error else {
      Issue.record(error)
      return
    }
    #expect(text.contains("one of: begin"))
    #expect(try procedure.stateJson() == before)
    guard case .Unwritable = try await thrown({ try Procedure.create(folder: folder.url.path, task: task) }) else {
      Issue.record("a second procedure in one folder")
      return
    }
    #expect(try procedureEventFromJson(text: #"{"event": "tick", "stamp_ns": 5}"#) == .tick(stampNs: 5))
  }
}

extension MeasuredDimensions {
  /// The lengths of a swing as they are planned.
  init(_ planned: Suspension) {
    self.init(
      lineLengthM: planned.lineLengthM, spacingM: planned.spacingM, topSpacingM: nil, hullPitchDeg: nil,
      pointsMovedM: nil, axisHeightM: nil, massKg: nil, armM: nil, depthM: nil
    )
  }
}
