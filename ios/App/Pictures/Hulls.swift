import SwiftUI

extension Pen {
  /// A hull from the side, bow to the right, its deck at `y`.
  func hullFromTheSide(_ y: Double) {
    shape { path in
      path.move(to: at(0.08, y))
      path.addLine(to: at(0.94, y - 0.015))
      path.addQuadCurve(to: at(0.68, y + 0.13), control: at(0.88, y + 0.11))
      path.addLine(to: at(0.24, y + 0.12))
      path.addQuadCurve(to: at(0.08, y), control: at(0.11, y + 0.1))
      path.closeSubpath()
    }
  }

  /// A hull from ahead, its deck at `y`.
  func hullFromAhead(_ y: Double) {
    shape { path in
      path.move(to: at(0.2, y))
      path.addLine(to: at(0.8, y))
      path.addQuadCurve(to: at(0.5, y + 0.22), control: at(0.78, y + 0.18))
      path.addQuadCurve(to: at(0.2, y), control: at(0.22, y + 0.18))
      path.closeSubpath()
    }
  }

  /// A hull from above, bow upwards.
  func hullFromAbove(top: Double, bottom: Double, halfBeam: Double = 0.16) {
    let middle = top + 0.55 * (bottom - top)
    shape { path in
      path.move(to: at(0.5, top))
      path.addCurve(
        to: at(0.5 + halfBeam, middle), control1: at(0.5 + 0.7 * halfBeam, top + 0.1),
        control2: at(0.5 + halfBeam, middle - 0.1))
      path.addQuadCurve(to: at(0.5 + 0.7 * halfBeam, bottom), control: at(0.5 + halfBeam, bottom - 0.1))
      path.addLine(to: at(0.5 - 0.7 * halfBeam, bottom))
      path.addQuadCurve(to: at(0.5 - halfBeam, middle), control: at(0.5 - halfBeam, bottom - 0.1))
      path.addCurve(
        to: at(0.5, top), control1: at(0.5 - halfBeam, middle - 0.1), control2: at(0.5 - 0.7 * halfBeam, top + 0.1))
      path.closeSubpath()
    }
  }

  /// What the lines are made fast to.
  func beam(from left: Double, to right: Double) {
    outline([at(left, 0.03), at(right, 0.03), at(right, 0.06), at(left, 0.06)], fill: .primary)
  }

  /// Two lines with their knots.
  func twoLines(left: Double, right: Double, top: Double, bottom: Double) {
    for x in [left, right] {
      line(at(x, top), at(x, bottom))
      dot(at(x, top))
      dot(at(x, bottom))
    }
  }

  /// A hull from the side on its lines, one behind the other.
  func hungFromTheSide() {
    line(at(0.5, 0.06), at(0.5, 0.56))
    hullFromTheSide(0.56)
    dot(at(0.5, 0.56), .primary, radius: 0.02)
  }

  /// An arc with heads at both ends, from an angle clockwise from the right.
  func turn(around x: Double, _ y: Double, radius: Double, fromDeg: Double) {
    let (fromRad, toRad) = (fromDeg * .pi / 180, (fromDeg + 35) * .pi / 180)
    let ends = [fromRad, toRad].map { at(x + radius * cos($0), y + radius * sin($0)) }
    shape(.accentColor, fill: nil) { path in
      path.addArc(
        center: at(x, y), radius: radius, startAngle: .radians(fromRad), endAngle: .radians(toRad), clockwise: false)
    }
    head(ends[0], alongRad: fromRad - .pi / 2)
    head(ends[1], alongRad: toRad + .pi / 2)
  }
}
