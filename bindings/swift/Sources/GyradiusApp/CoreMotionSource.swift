// Macs have the framework, and no such sensors.
#if canImport(CoreMotion) && !os(macOS)
  import CoreMotion
  import GyradiusKit

  /// The phone's own sensors. The gyroscope is read raw, not from the device motion, whose bias iOS moves while a hull swings.
  public final class CoreMotionSource: MotionSource, @unchecked Sendable {
    /// One manager for an app: two slow each other down. It is told what to do by one procedure at a time.
    private struct Shared: @unchecked Sendable {
      let manager = CMMotionManager()
    }

    private static let shared = Shared()
    private static var manager: CMMotionManager { shared.manager }
    /// As many samples per second as iPhones give.
    private static let intervalS = 0.01

    private let gyroscope = CoreMotionGatherer(.gyroscope)
    private let accelerometer = CoreMotionGatherer(.accelerometer)
    /// Its own, so that a busy screen never holds up a sample.
    private let queue = OperationQueue()

    public init() {
      queue.maxConcurrentOperationCount = 1
      queue.qualityOfService = .userInteractive
    }

    public var sensors: [PhoneSensor] {
      [
        Self.manager.isGyroAvailable ? PhoneSensor(channel: .gyroscope, name: "Core Motion", fullScale: nil) : nil,
        Self.manager.isAccelerometerAvailable
          ? PhoneSensor(channel: .accelerometer, name: "Core Motion", fullScale: nil) : nil,
      ].compactMap { $0 }
    }

    public func open() {
      let (manager, gyroscope, accelerometer) = (Self.manager, gyroscope, accelerometer)
      manager.gyroUpdateInterval = Self.intervalS
      manager.accelerometerUpdateInterval = Self.intervalS
      manager.startGyroUpdates(to: queue) { data, _ in
        guard let data else { return }
        let rate = data.rotationRate
        gyroscope.add(timestampS: data.timestamp, x: rate.x, y: rate.y, z: rate.z)
      }
      manager.startAccelerometerUpdates(to: queue) { data, _ in
        guard let data else { return }
        let force = data.acceleration
        accelerometer.add(timestampS: data.timestamp, x: force.x, y: force.y, z: force.z)
      }
    }

    public func take() throws -> [Samples] {
      try [gyroscope.take(), accelerometer.take()].compactMap { $0 }
    }

    public func close() {
      Self.manager.stopGyroUpdates()
      Self.manager.stopAccelerometerUpdates()
      queue.waitUntilAllOperationsAreFinished()
    }
  }
#endif
