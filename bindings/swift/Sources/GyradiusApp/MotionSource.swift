import Foundation
import GyradiusKit

/// Where samples come from. They gather until they are taken, so that none is lost while the library is busy.
public protocol MotionSource: Sendable {
  /// The sensors behind it.
  var sensors: [PhoneSensor] { get }

  /// Begins to gather.
  func open()

  /// What came since the last call: a batch for each stream that has any, in the order the samples came.
  func take() throws -> [Samples]

  /// Gathers no more; what came before can still be taken.
  func close()
}

/// A source whose time goes by only as it is let.
public protocol TimedSource: MotionSource {
  /// Lets so much time go by, s.
  func letGoBy(seconds: Double)
}

/// What Core Motion gives of one stream, until it is taken: filled by one thread, emptied by another. One call to the library
/// for each sample would cost more than the sample does.
public final class CoreMotionGatherer: @unchecked Sendable {
  private let channel: Channel
  private let lock = NSLock()
  private var timestampsS: [Double] = []
  private var values: [Double] = []

  public init(_ channel: Channel) {
    self.channel = channel
  }

  /// Takes a reading as Core Motion has it: rad/s, or g with iOS's sign; seconds since the phone was switched on.
  public func add(timestampS: Double, x: Double, y: Double, z: Double) {
    lock.withLock {
      timestampsS.append(timestampS)
      values += [x, y, z]
    }
  }

  /// What has gathered, in the library's units and signs; the library turns it into them.
  public func take() throws -> Samples? {
    let (timestampsS, values) = lock.withLock {
      defer { (self.timestampsS, self.values) = ([], []) }
      return (self.timestampsS, self.values)
    }
    guard !timestampsS.isEmpty else { return nil }
    return Samples(
      channel: channel,
      stampsNs: try stampsFromCoreMotion(timestampsS: Data(block: timestampsS)).stamps,
      values: channel == .accelerometer
        ? try forcesFromCoreMotion(accelerationsG: Data(block: values)).doubles : values
    )
  }
}
