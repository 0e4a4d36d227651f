import GyradiusKit
import Observation

/// What the phone's sensors give while a procedure listens to them.
@MainActor @Observable
public final class RecorderModel {
  /// A moment of the live trace: s since its first sample, and the rates about x, y and z, rad/s.
  public struct Point: Identifiable, Sendable {
    public let id: Int
    public let atS: Double
    public let rateRadS: [Double]
  }

  /// One in so many samples is drawn: a screen has no room for more.
  private static let thin = 4
  private static let shownS = 12.0

  /// The last seconds of the gyroscope, thinned.
  public private(set) var trace: [Point] = []
  /// Streams that have stopped.
  public private(set) var silent: Set<Channel> = []
  /// The sensors that are listened to.
  public private(set) var sensors: [PhoneSensor] = []
  private var firstNs: Int64?
  private var drawn = 0

  public init() {}

  func begin(_ sensors: [PhoneSensor]) {
    (trace, silent, firstNs, drawn) = ([], [], nil, 0)
    self.sensors = sensors
  }

  func see(_ look: Look) {
    if silent != look.silent { silent = look.silent }
    for batch in look.found where batch.channel == .gyroscope { draw(batch) }
  }

  func draw(_ samples: Samples) {
    let first = firstNs ?? samples.stampsNs[0]
    firstNs = first
    let points = stride(from: 0, to: samples.stampsNs.count, by: Self.thin).map { at in
      drawn += 1
      let rates = Array(samples.values[3 * at..<3 * at + 3])
      return Point(id: drawn, atS: Double(samples.stampsNs[at] - first) / 1e9, rateRadS: rates)
    }
    let untilS = points.last?.atS ?? 0
    trace = (trace + points).filter { $0.atS > untilS - Self.shownS }
  }
}
