import Foundation
import GyradiusKit
import TestSupport
import Testing

@testable import GyradiusApp

/// A boat park: the app's models, a phone at 100 Hz taped to a simulated hull, and an operator who knows the procedure.
@MainActor final class Park {
  /// What is true of the hull.
  static let truth = ["k_yaw_m": 1.093, "k_pitch_m": 1.121, "cm_depth_m": 0.33]
  static let rateHz = 100

  let model = ProcedureModel(now: { Date(timeIntervalSince1970: 1_777_887_000) })
  let source = PlayedSource(name: "simulated", nowNs: 7_000_000_000_000)
  let folder: URL
  private let temporary: TemporaryFolder

  /// In a folder of its own, or on a disk that a test chose.
  init(on disk: URL? = nil) throws {
    temporary = try TemporaryFolder()
    folder = (disk ?? temporary.url).appending(path: "session-\(UUID().uuidString)")
  }

  var state: ProcedureState {
    get throws { try #require(model.state) }
  }

  /// Plans for the boat, and opens its session.
  func open() async throws {
    let setup = SetupModel()
    (setup.title, setup.massKg, setup.lengthM, setup.beamM, setup.boatType) = ("Finn", 120, 4.5, 1.5, "dinghy")
    await setup.makePlan()
    await model.measure(in: folder, task: try #require(setup.task), source: source)
  }

  /// Plans for the boat, and begins at it.
  func begin() async throws {
    try await open()
    #expect(try state.phase == .start)
    await model.start(phone: "phone", placement: .flatTopToBow)
    #expect(try state.phase == .level)
  }

  /// From nothing to a recording that has begun.
  func record() async throws {
    try await begin()
    try await rest(seconds: 3)
    await model.handle(.accept)
    await model.handle(.skip)
    try await hang()
    await model.record()
    #expect(try state.phase == .record, "\(String(describing: model.error))")
  }

  /// Types in the lengths as they were planned: the simulated hull hangs on just these.
  func hang() async throws {
    #expect(try state.phase == .hang)
    await model.handle(.measured(MeasuredDimensions(try #require(state.step?.hanging))))
    #expect(try state.phase == .ready, "\(String(describing: model.error))")
  }

  /// The hull hangs still for so long.
  func rest(seconds: Double) async throws {
    try hangsStill(seconds: seconds)
    try await goOn(seconds: seconds)
  }

  /// What is to come of a hull that hangs still.
  func hangsStill(seconds: Double) throws {
    let rig = try Rig.parse(text: rigText(heldS: 0, durationS: seconds + 1, start: "", on: nil), name: "the hull")
    try SimulatedHull(rig: rig, source: source, seed: 3).hangsStill(like: "swing", seconds: seconds)
  }

  /// The hull is let go as the step asks, and swings for as long as the recording runs.
  func swing() async throws {
    let step = try #require(state.step)
    let planned = try #require(step.planned.swing)
    let start = planned.excited.map(Self.start).joined(separator: "\n")
    let durationS = planned.durationS + 30
    let text = rigText(heldS: 4, durationS: durationS, start: start, on: step.hanging)
    try SimulatedHull(rig: Rig.parse(text: text, name: "the hull"), source: source, seed: 7)
      .swings("swing", seconds: durationS)
    try await goOn(seconds: durationS) { $0.phase == .record }
    source.cut()
  }

  /// Time goes by, look by look.
  func goOn(seconds: Double, while goes: (ProcedureState) -> Bool = { _ in true }) async throws {
    for _ in 0..<Int((seconds / ProcedureModel.lookS).rounded()) {
      guard goes(try state) else { return }
      await model.look()
    }
  }

  /// The hull goes on, and the phone tells the app nothing of it.
  func isHeldBack(seconds: Double) {
    source.mute([.gyroscope, .accelerometer])
    source.letGoBy(seconds: seconds)
    _ = source.take()
    source.mute([])
  }

  /// Waits in real time until the model, by its own looking, has recorded so much.
  func waits(untilRecordedS wantedS: Double) async throws {
    for _ in 0..<600 {
      if try #require(state.recording).recordedS >= wantedS { return }
      try await Task.sleep(for: .milliseconds(50))
    }
    Issue.record("recorded \(String(describing: model.state?.recording?.recordedS)) s of \(wantedS)")
  }

  /// The newest recording.
  func take() throws -> RecorderFile {
    let takes = folder.appending(path: "takes")
    return try RecorderFile.read(path: takes.appending(path: #require(names(in: takes).last)).path)
  }

  /// How many samples of a stream the newest recording holds.
  func recorded(_ channel: Channel) throws -> Int {
    try take().samples().first { $0.channel == channel }?.stampsNs.count ?? 0
  }

  nonisolated private static func start(_ excited: Excitation) -> String {
    switch excited {
    case .yaw: "yaw_deg = 5.0"
    case .sway: "sway_m = 0.15"
    case .surge: "surge_m = 0.15"
    case .pitch: "pitch_deg = 5.0"
    case .roll: "roll_deg = 5.0"
    }
  }

  private func rigText(heldS: Double, durationS: Double, start: String, on hanging: Suspension?) -> String {
    let orientation = hanging?.orientation == .foreAndAft ? "fore_and_aft" : "athwartships"
    return """
      format = "gyradius-rig/1"
      title = "Finn"
      [body]
      name = "Finn"
      mass = 120.0
      [site]
      gravity = { value = 9.80665, u = 0.015 }
      [truth]
      k_yaw_m = \(Self.truth["k_yaw_m"]!)
      k_pitch_m = \(Self.truth["k_pitch_m"]!)
      k_roll_m = 0.55
      cm_depth_m = \(Self.truth["cm_depth_m"]!)
      position_x_m = 0.8
      position_z_m = 0.1
      gyro_bias_x_rad_s = 0.003
      rate_hz = \(Double(Self.rateHz))
      [[swing]]
      id = "swing"
      recording = "swing.csv"
      [swing.suspension]
      kind = "bifilar"
      orientation = "\(orientation)"
      line_length = { value = \(hanging?.lineLengthM?.value ?? 3), u = 0.003 }
      spacing = { value = \(hanging?.spacingM?.value ?? 1.5), u = 0.001 }
      [swing.truth]
      \(start)
      held_s = \(heldS)
      duration_s = \(durationS)
      [[effect]]
      id = "linear_damping"
      surge_n_s_m = 1.2
      sway_n_s_m = 1.2
      pitch_n_m_s = 1.3
      yaw_n_m_s = 1.3
      [[effect]]
      id = "white_noise"
      gyro_rad_s = 0.002
      acc_m_s2 = 0.02
      """
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
