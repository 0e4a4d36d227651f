import Foundation
import TestSupport
import Testing

@testable import GyradiusKit

/// The same files through Swift give the same bytes as through Python.
@Suite struct PythonTests {
  private let folder: TemporaryFolder

  init() throws {
    folder = try TemporaryFolder()
  }

  private func doubles(_ name: String) throws -> [UInt64] { bits(try Shared.bytes(name).doubles) }

  @Test(arguments: ["boat-park", "keelboat", "model-hull"])
  func aSessionsMeasurementAndReport(_ name: String) async throws {
    let session = try await Session.load(Shared.session(name))
    let analysis = try await session.measure(limits: ["k_yaw_m>=1.000", "k_pitch_m<=1.2"])
    #expect(try analysis.json() == Shared.text("measure-\(name).json"))
    let report = try await analysis.reportHtml()
    #expect(try report == Shared.text("report-\(name).html"))
  }

  @Test func aBareRecording() async throws {
    let bare = try await Session.load(Shared.session("boat-park").appending(path: "yaw-sway.csv"))
    #expect(try await bare.measure().json() == Shared.text("measure-bare.json"))
  }

  @Test(arguments: ["keelboat", "model-hull"])
  func aCriticism(_ name: String) async throws {
    let criticism = try await Session.load(Shared.session(name)).critique()
    #expect(try criticism.json() == Shared.text("critique-\(name).json"))
  }

  @Test func aPlanAndItsFiles() async throws {
    let plan = try await Plan.make(planRequestFromJson(text: Shared.text("plan-request.json")))
    #expect(try plan.json() == Shared.text("plan.json"))
    #expect(try plan.sessionToml() == Shared.text("plan-session.toml"))
    #expect(try plan.rigToml() == Shared.text("plan-rig.toml"))
  }

  @Test func aSimulatedSwingAndItsOscillations() throws {
    let numbers = try Shared.texts("simulation-numbers.json")
    let swung = try Shared.rig().simulate(swing: "surge-pitch", derivatives: numbers, seed: Shared.seed)
    let (times, readings) = (swung.tS().doubles, swung.readings().doubles)
    #expect(try bits(times) == doubles("simulation-t_s.bin"))
    #expect(try bits(readings) == doubles("simulation-readings.bin"))
    #expect(try bits(swung.derivatives().doubles) == doubles("simulation-derivatives.bin"))
    let gyroscope = (0..<3).map { axis in (1000..<5000).map { readings[6 * $0 + axis] } }
    let found = try Decomposition.of(atS: Array(times[1000..<5000]), channels: gyroscope)
    #expect(try found.json() == Shared.text("decomposition.json"))
  }

  @Test func theLiveEstimateOfThatSwing() throws {
    let readings = try Shared.rig().simulate(swing: "surge-pitch", seed: Shared.seed).readings().doubles
    let stamps = try Shared.bytes("live-stamps_ns.bin").stamps
    let live = try LiveEstimator(wanted: 1e-4, gyroscopeFullScaleRadS: nil, accelerometerFullScaleMS2: nil)
    for start in stride(from: 0, to: stamps.count, by: 100) {
      let rows = start..<min(start + 100, stamps.count)
      for (channel, first) in [(Channel.gyroscope, 0), (.accelerometer, 3)] {
        let values = rows.flatMap { readings[6 * $0 + first..<6 * $0 + first + 3] }
        try live.push(Samples(channel: channel, stampsNs: Array(stamps[rows]), values: values))
      }
    }
    #expect(try live.estimateJson() == Shared.text("live.json"))
  }

  @Test func aPracticeStateByStateAndItsRecordings() throws {
    let rehearsal = try Rehearsal.create(folder: folder.path("practice"), rig: Shared.rig(), seed: Shared.seed)
    try rehearsal.mishap(step: "yaw-sway", take: 1, what: "slip")
    var told = [try rehearsal.stateJson()]
    while rehearsal.state().work == nil {
      if let event = try rehearsal.byTheBook(atUtc: Shared.atUtc) {
        try rehearsal.handle(event: event)
        told.append(try rehearsal.stateJson())
      } else {
        _ = try rehearsal.advance(seconds: 5)
      }
    }
    #expect(try told == Shared.texts("practice-states.json"))
    let takes = folder.url.appending(path: "practice/takes")
    #expect(try names(in: takes) == names(in: Shared.python("practice/takes")))
    for take in try names(in: takes) {
      try isTheSameTake(takes.appending(path: take), as: Shared.python("practice/takes/\(take)"))
    }
  }

  private func isTheSameTake(_ take: URL, as python: URL) throws {
    let name = take.lastPathComponent
    #expect(try Data(contentsOf: take) == Data(contentsOf: python), "\(name)")
    let gyroscope = try #require(RecorderFile.read(path: python.path).samples().first { $0.channel == .gyroscope })
    #expect(try gyroscope.stampsNs == Shared.bytes("\(name)-stamps_ns.bin").stamps)
    #expect(try bits(gyroscope.values) == doubles("\(name)-values.bin"))
    #expect(gyroscope.stampsNs.count > 1000)
  }

  @Test func anImport() throws {
    let phyphox = root.appending(path: "core/crates/recording/tests/fixtures/import/phyphox-android.zip")
    let imported = folder.url.appending(path: "imported")
    let notes = try importRecordings(
      files: [phyphox.path, Shared.python("cut.gyr").path],
      folder: imported.path,
      request: request,
      overwrite: .refuse
    )
    #expect(try notes == Shared.texts("import-notes.json"))
    let python = Shared.python("imported")
    #expect(try names(in: imported) == names(in: python))
    for name in try names(in: python) {
      let (found, expected) = (imported.appending(path: name), python.appending(path: name))
      #expect(try Data(contentsOf: found) == Data(contentsOf: expected), "\(name)")
    }
  }

  private var request: ImportRequest {
    ImportRequest(
      mapping: [],
      trial: nil,
      platform: nil,
      flagWidthM: nil,
      title: "faces",
      massKg: Quantity(value: 622.7, u: 0.5),
      gravityMS2: nil,
      suspension: Suspension(
        kind: .bifilar,
        orientation: .athwartships,
        lineLengthM: Quantity(value: 3.477, u: 0.003),
        spacingM: Quantity(value: 1.8, u: 0.001),
        topSpacingM: nil,
        hullPitchDeg: nil,
        hullRollDeg: nil,
        pointsM: nil,
        pointsMovedM: nil,
        axisHeightM: nil
      )
    )
  }
}
