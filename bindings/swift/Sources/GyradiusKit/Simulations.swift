import Foundation

extension Rig {
  /// Simulates a swing as its phone samples it, or at the times given, s; `values` replace numbers by name.
  public func simulate(
    swing: String,
    values: [String: Double] = [:],
    derivatives: [String] = [],
    atS times: [Double]? = nil,
    seed: UInt64? = nil
  ) throws -> Simulation {
    let numbers = values.map { NamedNumber(name: $0.key, value: $0.value) }
    guard let times else { return try simulate(swing: swing, values: numbers, derivatives: derivatives, seed: seed) }
    let block = Data(block: times)
    return try simulateAt(swing: swing, tS: block, values: numbers, derivatives: derivatives, seed: seed)
  }
}

extension Decomposition {
  /// The damped oscillations of channels that share one clock; times in s.
  public static func of(atS times: [Double], channels: [[Double]]) throws -> Decomposition {
    guard channels.allSatisfy({ $0.count == times.count }) else {
      let text = "argument `channels`: expected channels as long as the times"
      throw GyradiusError.BadArgument(text: text, name: "channels")
    }
    return try of(tS: Data(block: times), channels: Data(block: channels.flatMap { $0 }))
  }

  /// The fitted oscillations at any times, s: one array for each channel.
  public func evaluate(atS times: [Double]) throws -> [[Double]] {
    let flat = try evaluate(tS: Data(block: times)).doubles
    guard !times.isEmpty else { return [] }
    return stride(from: 0, to: flat.count, by: times.count).map { Array(flat[$0..<$0 + times.count]) }
  }
}
