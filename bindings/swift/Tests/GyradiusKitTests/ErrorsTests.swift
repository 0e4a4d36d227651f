import Foundation
import TestSupport
import Testing

@testable import GyradiusKit

/// What goes wrong arrives as the right error, with what is wrong and where.
@Suite struct ErrorsTests {
  private let folder: TemporaryFolder

  init() throws {
    folder = try TemporaryFolder()
  }

  @Test func aFileThatIsNotThereAndOneThatIsWrongInALine() async throws {
    let missing = try await thrown { try await Session.load(URL(filePath: "/no/such/session")) }
    guard case .BadFile(_, "/no/such/session", nil) = missing else {
      Issue.record(missing)
      return
    }
    let whole = try String(contentsOf: Shared.session("keelboat").appending(path: "session.toml"), encoding: .utf8)
    try (whole + "\n[sight]\n").write(toFile: folder.path("session.toml"), atomically: true, encoding: .utf8)
    let wrong = try await thrown { try await Session.load(folder.url) }
    guard case .BadFile(let text, let file, let line) = wrong else {
      Issue.record(wrong)
      return
    }
    #expect(file == folder.path("session.toml"))
    #expect(line.map(Int.init) == whole.split(separator: "\n", omittingEmptySubsequences: false).count + 1)
    #expect(text.contains("unknown key `sight`") && text.contains("`site`"))
    #expect(wrong.text == text && wrong.description == text)
  }

  @Test func aFileThatIsThereAlready() async throws {
    let (header, path) = (RecorderHeader(phone: "phone", sensors: [], notes: []), folder.path("take.gyr"))
    _ = try RecorderWriter.create(path: path, header: header)
    let error = try await thrown { try RecorderWriter.create(path: path, header: header) }
    guard case .Unwritable(_, path) = error else {
      Issue.record(error)
      return
    }
  }

  @Test func aBareRecordingCannotBeCriticised() async throws {
    let bare = try await Session.load(Shared.session("boat-park").appending(path: "yaw-sway.csv"))
    let error = try await thrown { try await bare.critique() }
    guard case .NoResult(let text, let what) = error else {
      Issue.record(error)
      return
    }
    #expect(text.contains("dimensions"))
    #expect(what == bare.title())
  }

  @Test func argumentsOutsideOfTheirDomain() async throws {
    try await isBadArgument("yaw_gyradius") { try evaluateRoute(name: "yaw_gyradus", inputs: [:]) }
    try await isBadArgument("k_yaw") { try await Session.load(Shared.session("keelboat")).measure(limits: ["k_yaw"]) }
    try await isBadArgument("above 0") {
      try LiveEstimator(wanted: 0, gyroscopeFullScaleRadS: nil, accelerometerFullScaleMS2: nil)
    }
    try await isBadArgument("channels") { try Decomposition.of(atS: [0, 1], channels: [[1]]) }
  }

  @Test func aBlockThatIsNotWhole() async throws {
    let live = try LiveEstimator(wanted: 1e-4, gyroscopeFullScaleRadS: nil, accelerometerFullScaleMS2: nil)
    try await isBadArgument("as many values as stamps") {
      try live.push(Samples(channel: .gyroscope, stampsNs: [0, 1], values: [0, 0, 0]))
    }
    try await isBadArgument("`values`") {
      try live.push(Samples(channel: .gyroscope, stampsNs: [0], values: [0, 0]))
    }
    try await isBadArgument("8 bytes") {
      try live.push(sensor: .gyroscope, stampsNs: Data(count: 7), values: Data(count: 24))
    }
  }

  @Test func noRouteGivesNaNOrBreaksWhateverItIsGiven() throws {
    for number in [0, -0.0, Double.nan, .infinity, 1e300, -1, 1e-300] {
      let inputs = ["gyradius_m": number, "line_length_m": number, "spacing_m": number]
      do {
        let outputs = try evaluateRoute(name: "yaw_period", inputs: inputs)
        #expect(outputs.values.allSatisfy { $0.isFinite })
      } catch is GyradiusError {}
    }
  }

  private func isBadArgument<Value>(_ words: String, _ act: () async throws -> Value) async throws {
    let error = try await thrown(act)
    guard case .BadArgument(let text, _) = error else {
      Issue.record(error)
      return
    }
    #expect(text.contains(words))
  }
}
