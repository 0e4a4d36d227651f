import Foundation

/// Samples of one sensor in the order they came.
public struct Samples: Sendable, Equatable {
  public let channel: Channel
  /// Stamps, ns of the phone's clock.
  public let stampsNs: [Int64]
  /// x, y, z of each sample in a row: three times as many; rad/s or m/s² of specific force, phone axes.
  public let values: [Double]

  public init(channel: Channel, stampsNs: [Int64], values: [Double]) {
    self.channel = channel
    self.stampsNs = stampsNs
    self.values = values
  }
}

extension SampleBatch {
  /// The same in one row of numbers.
  public var samples: Samples {
    Samples(channel: channel, stampsNs: stampsNs, values: values.flatMap { [$0.x, $0.y, $0.z] })
  }
}

/// Numbers as the library takes and gives them: little-endian, as every processor that Swift runs on has them in memory.
extension Data {
  /// A block of floats.
  public init(block numbers: [Double]) {
    self = numbers.withUnsafeBytes { Data($0) }
  }

  /// A block of stamps, ns.
  public init(block stampsNs: [Int64]) {
    self = stampsNs.withUnsafeBytes { Data($0) }
  }

  /// The floats of a block that the library gave.
  public var doubles: [Double] { numbers() }

  /// The stamps of a block that the library gave, ns.
  public var stamps: [Int64] { numbers() }

  private func numbers<Number>() -> [Number] {
    withUnsafeBytes { bytes in
      // A block may begin anywhere in memory, so a number at a time is read from wherever it lies.
      stride(from: 0, to: bytes.count, by: MemoryLayout<Number>.size).map {
        bytes.loadUnaligned(fromByteOffset: $0, as: Number.self)
      }
    }
  }
}
