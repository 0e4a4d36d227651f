import SwiftUI

/// A spirit level seen from above, bow upwards: the bubble moves to the side that is high.
struct Bubble: View {
  let bowUpDeg: Double
  let starboardDownDeg: Double

  private let radius = 0.07
  /// So far out the picture's rim stands.
  private let mostDeg = 3.0
  /// The bubble says "level" up to here.
  private let levelDeg = 0.2

  var body: some View {
    Sketch(Words.sketchBubble, heights: 1) { pen in
      rings(pen)
      pen.dot(place, tiltDeg < levelDeg ? .green : .orange, radius: radius)
    }
    .frame(maxWidth: 300)
  }

  private var tiltDeg: Double { hypot(bowUpDeg, starboardDownDeg) }

  private var place: CGPoint {
    let scale = (0.5 - radius) / mostDeg / max(1, tiltDeg / mostDeg)
    return at(0.5 - starboardDownDeg * scale, 0.5 - bowUpDeg * scale)
  }

  private func rings(_ pen: Pen) {
    pen.dot(at(0.5, 0.5), Color(uiColor: .secondarySystemBackground), radius: 0.5)
    for ring in [1 / mostDeg * (0.5 - radius), 2 / mostDeg * (0.5 - radius), radius + 0.02] {
      pen.shape(.secondary, fill: nil) { path in
        path.addEllipse(in: CGRect(x: 0.5 - ring, y: 0.5 - ring, width: 2 * ring, height: 2 * ring))
      }
    }
    pen.line(at(0.5, 0), at(0.5, 1), .secondary)
    pen.line(at(0, 0.5), at(1, 0.5), .secondary)
  }
}
