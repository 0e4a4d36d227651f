import GyradiusKit
import SwiftUI

/// The principal axes, as long as their gyradii, and the ellipsoid through their ends: bow to the right, seen a little from above.
struct Ellipsoid: View {
  private let gyradiiM: [Double]
  private let psiDeg: Double

  /// Nothing, where the result has no principal gyradii.
  init?(_ quantities: [NamedQuantity]) {
    let values = quantities.first { $0.name == "principal_gyradii_m" }?.quantity.value
    guard case .vector(let gyradiiM) = values, gyradiiM.count == 3 else { return nil }
    self.gyradiiM = gyradiiM
    psiDeg = quantities.first { $0.name == "psi_deg" }?.quantity.value.number ?? 0
  }

  var body: some View {
    SectionHead(title: Words.ellipsoid)
    Sketch(Words.sketchEllipsoid, heights: 0.8) { pen in
      let scale = 0.36 / (gyradiiM.max() ?? 1)
      let axes = principalAxes
      for (one, other) in [(0, 1), (1, 2), (0, 2)] { ring(pen, axes[one], axes[other], scale) }
      for (axis, name) in zip(axes, [Words.motionRoll, Words.motionPitch, Words.motionYaw]) {
        let end = axis.seen(scale)
        pen.line(at(1 - end.x, 0.8 - end.y), end, .accentColor)
        pen.dot(end)
        pen.words(at(0.5 + 1.18 * (end.x - 0.5), 0.4 + 1.18 * (end.y - 0.4)), name)
      }
      pen.words(at(0.93, 0.74), "\(Words.bow) →", .primary)
    }
    Text(Words.ellipsoidSays)
  }

  /// A point in hull axes: x to the bow, y to port, z up.
  private struct HullPoint {
    let x, y, z: Double

    /// Where it stands in the picture: a parallel projection from starboard, ahead of the beam and above.
    func seen(_ scale: Double) -> CGPoint {
      let (turnRad, riseRad) = (Double.pi / 6, Double.pi / 8)
      let right = x * cos(turnRad) + y * sin(turnRad)
      let away = -x * sin(turnRad) + y * cos(turnRad)
      let up = z * cos(riseRad) + away * sin(riseRad)
      return at(0.5 + scale * right, 0.4 - scale * up)
    }
  }

  /// Roll, pitch and yaw axis; psi is bow up.
  private var principalAxes: [HullPoint] {
    let psiRad = psiDeg * .pi / 180
    return [
      HullPoint(x: gyradiiM[0] * cos(psiRad), y: 0, z: gyradiiM[0] * sin(psiRad)),
      HullPoint(x: 0, y: gyradiiM[1], z: 0),
      HullPoint(x: -gyradiiM[2] * sin(psiRad), y: 0, z: gyradiiM[2] * cos(psiRad)),
    ]
  }

  private func ring(_ pen: Pen, _ one: HullPoint, _ other: HullPoint, _ scale: Double) {
    let steps = 72
    let points = (0..<steps).map { step in
      let angleRad = 2 * Double.pi * Double(step) / Double(steps)
      let (c, s) = (cos(angleRad), sin(angleRad))
      return HullPoint(x: c * one.x + s * other.x, y: c * one.y + s * other.y, z: c * one.z + s * other.z).seen(scale)
    }
    pen.outline(points, fill: nil)
  }
}
