import GyradiusKit

/// A hull that the library simulates, felt by a phone at 100 Hz as iPhones give: what the operator does to it becomes samples
/// of a source.
public struct SimulatedHull: Sendable {
  /// Time between two samples, ns.
  public static let intervalNs: Int64 = 10_000_000

  private let rig: Rig
  private let source: PlayedSource
  private let seed: UInt64

  public init(rig: Rig, source: PlayedSource, seed: UInt64) {
    self.rig = rig
    self.source = source
    self.seed = seed
  }

  /// It hangs still, as a swing hangs it.
  public func hangsStill(like swing: String, seconds: Double) throws {
    try play(swing, seconds: seconds, values: ["along_m": 0, "across_m": 0, "turn_rad": 0, "yaw_rad": 0])
  }

  /// It is held aside and let go.
  public func swings(_ swing: String, seconds: Double) throws {
    try play(swing, seconds: seconds, values: [:])
  }

  private func play(_ swing: String, seconds: Double, values: [String: Double]) throws {
    let (count, fromNs) = (Int64(seconds * 1e9) / Self.intervalNs, source.endNs + Self.intervalNs)
    let timesS = (0..<count).map { Double($0 * Self.intervalNs) / 1e9 }
    let simulation = try rig.simulate(swing: swing, values: values, atS: timesS, seed: seed)
    let stampsNs = simulation.tS().doubles.map { fromNs + Int64((1e9 * $0).rounded()) }
    let readings = simulation.readings().doubles
    for (channel, first) in [(Channel.gyroscope, 0), (.accelerometer, 3)] {
      let values = stampsNs.indices.flatMap { readings[6 * $0 + first..<6 * $0 + first + 3] }
      source.add(Samples(channel: channel, stampsNs: stampsNs, values: values))
    }
  }
}
