import Foundation

extension LiveEstimator {
  /// Takes samples of the gyroscope or the accelerometer; the bias of the gyroscope says nothing of the swing.
  public func push(_ samples: Samples) throws {
    guard let sensor = samples.channel.sensor else { return }
    try push(sensor: sensor, stampsNs: Data(block: samples.stampsNs), values: Data(block: samples.values))
  }

  /// The newest estimate, after each batch of samples: whoever reads slowly misses the older ones, and no sample is missed.
  public func estimates<Batches: AsyncSequence & Sendable>(
    of batches: Batches
  ) -> AsyncThrowingStream<LiveEstimate, any Error> where Batches.Element == Samples {
    AsyncThrowingStream(bufferingPolicy: .bufferingNewest(1)) { continuation in
      let task = Task {
        do {
          for try await samples in batches {
            try self.push(samples)
            continuation.yield(self.estimate())
          }
          continuation.finish()
        } catch {
          continuation.finish(throwing: error)
        }
      }
      continuation.onTermination = { _ in task.cancel() }
    }
  }
}

extension Channel {
  /// Every stream that a phone may give.
  public static let all: [Channel] = [.gyroscope, .accelerometer, .gyroscopeBias]

  /// The sensor whose readings these are.
  public var sensor: Sensor? {
    switch self {
    case .gyroscope: .gyroscope
    case .accelerometer: .accelerometer
    case .gyroscopeBias: nil
    }
  }
}

extension RecorderWriter {
  /// Takes samples of one stream in the order they came.
  @discardableResult
  public func push(_ samples: Samples) throws -> Written {
    try push(
      channel: samples.channel,
      stampsNs: Data(block: samples.stampsNs),
      values: Data(block: samples.values)
    )
  }
}

extension RecorderFile {
  /// Samples of every stream that has any, bit for bit as the phone gave them.
  public func samples() -> [Samples] {
    tracks().map { Samples(channel: $0.channel, stampsNs: $0.stampsNs.stamps, values: $0.values.doubles) }
  }
}

extension Procedure {
  /// Takes samples of one stream in the order they came.
  public func push(_ samples: Samples) throws {
    try push(
      channel: samples.channel,
      stampsNs: Data(block: samples.stampsNs),
      values: Data(block: samples.values)
    )
  }

  /// Does the work that is wanted, if there is any: seconds or minutes. Other calls go on meanwhile.
  public func work(onProgress: OnProgress? = nil) async throws {
    try await watched(onProgress) { try self.workBlocking(listener: $0) }
  }
}

extension Rehearsal {
  /// Does the work that is wanted, if there is any: seconds or minutes.
  public func work(onProgress: OnProgress? = nil) async throws {
    try await watched(onProgress) { try self.workBlocking(listener: $0) }
  }
}
