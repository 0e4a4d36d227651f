import Foundation
import GyradiusKit

/// Samples that are known beforehand, told as their time comes: a recording played again, or a simulated hull.
public final class PlayedSource: TimedSource, @unchecked Sendable {
  public let sensors: [PhoneSensor]
  private let lock = NSLock()
  private var tracks: [Track]
  private var nowNs: Int64
  private var isOpen = false
  private var muted: Set<Channel> = []

  /// Stamps begin at `nowNs` of the phone's clock.
  public init(channels: [Channel] = [.gyroscope, .accelerometer], name: String, nowNs: Int64 = 0) {
    sensors = channels.map { PhoneSensor(channel: $0, name: name, fullScale: nil) }
    tracks = channels.map { Track(channel: $0) }
    self.nowNs = nowNs
  }

  /// A recorder's file once more, with its own stamps.
  public static func replay(_ file: RecorderFile) -> PlayedSource {
    let samples = file.samples()
    let firstNs = samples.compactMap(\.stampsNs.first).min() ?? 0
    let source = PlayedSource(channels: samples.map(\.channel), name: file.header().phone, nowNs: firstNs)
    samples.forEach(source.add)
    return source
  }

  /// What is to come, after what is to come already.
  public func add(_ samples: Samples) {
    lock.withLock {
      guard let at = tracks.firstIndex(where: { $0.channel == samples.channel }) else { return }
      tracks[at].append(samples)
    }
  }

  /// Nothing more is to come of what was added: somebody holds the hull.
  public func cut() {
    lock.withLock { for at in tracks.indices { tracks[at].cut() } }
  }

  /// When what is to come has been told, ns.
  public var endNs: Int64 {
    lock.withLock { max(nowNs, tracks.compactMap(\.stampsNs.last).max() ?? nowNs) }
  }

  /// Sensors that give nothing from now on.
  public func mute(_ channels: Set<Channel>) {
    lock.withLock { muted = channels }
  }

  public func open() {
    lock.withLock { isOpen = true }
  }

  public func letGoBy(seconds: Double) {
    lock.withLock { nowNs += Int64((1e9 * seconds).rounded()) }
  }

  public func take() -> [Samples] {
    lock.withLock {
      tracks.indices.compactMap { at in
        let told = tracks[at].take(untilNs: nowNs)
        return isOpen && !muted.contains(tracks[at].channel) ? told : nil
      }
    }
  }

  public func close() {
    lock.withLock { isOpen = false }
  }
}

/// What one stream has yet to tell.
private struct Track {
  let channel: Channel
  private(set) var stampsNs: [Int64] = []
  private var values: [Double] = []
  private var told = 0

  init(channel: Channel) {
    self.channel = channel
  }

  mutating func append(_ samples: Samples) {
    stampsNs += samples.stampsNs
    values += samples.values
  }

  mutating func cut() {
    stampsNs.removeSubrange(told...)
    values.removeSubrange((3 * told)...)
  }

  /// What is older than a moment, and was not told yet.
  mutating func take(untilNs: Int64) -> Samples? {
    let from = told
    told = stampsNs[from...].firstIndex { $0 >= untilNs } ?? stampsNs.count
    guard from < told else { return nil }
    return Samples(channel: channel, stampsNs: Array(stampsNs[from..<told]), values: Array(values[3 * from..<3 * told]))
  }
}
