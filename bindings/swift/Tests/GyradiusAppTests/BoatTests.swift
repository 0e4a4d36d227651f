import Foundation
import GyradiusKit
import TestSupport
import Testing

@testable import GyradiusApp

/// A boat from its set-up to the result through the models, by samples at 100 Hz as iPhones give them. The hull is the core's
/// simulation; what is true of it stands in `Park`.
@MainActor @Suite struct BoatTests {
  @Test func aBoatIsMeasuredAndTheTruthIsInsideOfTheInterval() async throws {
    let park = try Park()
    try await park.begin()
    try await park.rest(seconds: 5)
    #expect(try abs(#require(park.state.tilt?.bowUpDeg)) < 0.2)
    await park.model.handle(.accept)
    try await park.rest(seconds: 20)
    let rest = try #require(park.state.rest?.found)
    #expect(abs(rest.gyroscope.rateHz - 100) < 0.1)
    // Standard gravity, with the accelerometer's noise of 0.02 m/s² over 15 s.
    #expect(try abs(#require(rest.gravityMS2) - 9.80665) < 0.003)
    await park.model.handle(.accept)
    while try park.state.phase == .hang { try await swing(park) }
    await park.model.workDone()
    await park.model.look()
    try judge(#require(park.state.result))
    await park.model.handle(.skip)
    #expect(try park.state.phase == .done)
  }

  /// Hangs, lets go and accepts one step.
  private func swing(_ park: Park) async throws {
    try await park.hang()
    await park.model.record()
    try await park.swing()
    #expect(try park.state.phase == .judge)
    let judgement = try #require(park.state.judgement)
    #expect(judgement.recommend == .accept, "\(judgement.reasons.map(\.english))")
    await park.model.handle(.accept)
  }

  private func judge(_ result: ResultView) throws {
    for name in ["k_yaw_m", "k_pitch_m"] {
      let (truth, found) = (Park.truth[name]!, try #require(result.quantities.first { $0.name == name }).quantity)
      let interval = try #require(found.interval95)
      #expect((interval.low...interval.high).contains(truth), "\(name): \(interval), true \(truth)")
      #expect(try #require(found.u.number) < 0.005 * truth)
    }
  }

  @Test func whatIsNotOfferedIsToldAndChangesNothing() async throws {
    let park = try Park()
    try await park.begin()
    await park.model.record()
    guard case .told(let why)? = park.model.error else {
      Issue.record("\(String(describing: park.model.error))")
      return
    }
    #expect(why.contains("one of:"))
    #expect(try park.state.phase == .level)
    try await park.rest(seconds: 3)
    await park.model.handle(.accept)
    #expect(park.model.error == nil)
    #expect(try park.state.phase == .rest)
  }

  @Test func aPracticeGoesByTheBookAndIsGoneOnWith() async throws {
    let folder = try TemporaryFolder()
    let rig = try String(contentsOf: root.appending(path: "python/gyradius/rigs/keelboat.toml"), encoding: .utf8)
    let model = ProcedureModel()
    await model.practise(in: folder.url, rigText: rig, title: "Kielboot", seed: 1)
    #expect(model.isPractice && !model.isListening)
    #expect(model.state?.instruction.english.hasPrefix("Measure Kielboot: ") == true)
    model.pace = 10
    while let phase = model.state?.phase, phase != .record {
      await model.byTheBook()
      await model.look()
    }
    // The simulated phone is seen on the screen as a real one would be.
    #expect(!model.recorder.trace.isEmpty)
    await model.leave()
    #expect(model.state == nil)
    await model.practise(in: folder.url, rigText: rig, title: "Kielboot", seed: 1)
    #expect(model.state?.phase == .interrupted)
    await model.leave()
  }
}
