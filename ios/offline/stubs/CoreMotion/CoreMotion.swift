// STUB: what the app uses of Apple's CoreMotion, as we read its documentation. It checks names and types, and does nothing.
@_exported import Foundation

public struct CMRotationRate: Sendable {
  public var x, y, z: Double
}

public struct CMAcceleration: Sendable {
  public var x, y, z: Double
}

open class CMLogItem {
  open var timestamp: TimeInterval { fatalError() }
}

open class CMGyroData: CMLogItem {
  open var rotationRate: CMRotationRate { fatalError() }
}

open class CMAccelerometerData: CMLogItem {
  open var acceleration: CMAcceleration { fatalError() }
}

public typealias CMGyroHandler = @Sendable (CMGyroData?, (any Error)?) -> Void
public typealias CMAccelerometerHandler = @Sendable (CMAccelerometerData?, (any Error)?) -> Void

open class CMMotionManager {
  public init() {}
  open var isGyroAvailable: Bool { fatalError() }
  open var isAccelerometerAvailable: Bool { fatalError() }
  open var gyroUpdateInterval: TimeInterval = 0
  open var accelerometerUpdateInterval: TimeInterval = 0
  open func startGyroUpdates(to queue: OperationQueue, withHandler handler: @escaping CMGyroHandler) {}
  open func startAccelerometerUpdates(to queue: OperationQueue, withHandler handler: @escaping CMAccelerometerHandler) {
  }
  open func stopGyroUpdates() {}
  open func stopAccelerometerUpdates() {}
}
