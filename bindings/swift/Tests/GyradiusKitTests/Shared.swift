import Foundation
import TestSupport
import Testing

@testable import GyradiusKit

/// What Python made of the same input (`tests/faces/write_results.py`).
enum Shared {
  static let atUtc = "2026-05-04T09:30:00Z"
  static let seed: UInt64 = 20_140_101

  /// A file of Python's; it is an error, not a skip, where there is none.
  static func python(_ name: String) -> URL { root.appending(path: "build/faces/\(name)") }

  static func bytes(_ name: String) throws -> Data { try Data(contentsOf: python(name)) }

  static func text(_ name: String) throws -> String { String(decoding: try bytes(name), as: UTF8.self) }

  static func texts(_ name: String) throws -> [String] {
    try JSONDecoder().decode([String].self, from: bytes(name))
  }

  static func session(_ name: String) -> URL { root.appending(path: "python/gyradius/sessions/\(name)") }

  static func rig() throws -> Rig {
    try Rig.read(path: root.appending(path: "python/gyradius/rigs/keelboat.toml").path)
  }
}

/// What the library throws.
func thrown<Value>(_ act: () async throws -> Value) async throws -> GyradiusError {
  var error: (any Error)?
  do {
    _ = try await act()
  } catch let found {
    error = found
  }
  return try #require(error as? GyradiusError)
}

/// The bits of numbers: a NaN equals itself, 0 is not −0.
func bits(_ numbers: [Double]) -> [UInt64] { numbers.map(\.bitPattern) }

extension PlanRequest {
  /// The usual request for another hull.
  static func usual(title: String = "boat", hull: RoughHull, wanted: [String]) -> PlanRequest {
    PlanRequest(title: title, hull: hull, wanted: wanted, means: usualMeans())
  }
}

extension RoughHull {
  /// A hull of which no more than this is known.
  init(massKg: Double, lengthM: Double, beamM: Double, boatType: String) {
    self.init(
      massKg: massKg, lengthM: lengthM, beamM: beamM, boatType: boatType,
      kYawM: nil, kPitchM: nil, kRollM: nil, cmDepthM: nil, psiDeg: nil
    )
  }
}
