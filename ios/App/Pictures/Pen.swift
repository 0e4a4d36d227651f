import SwiftUI

/// Draws in units of its picture's width: x from 0 to 1 to the right, y from 0 downwards. Layout, no science.
@MainActor
struct Pen {
  let context: GraphicsContext
  let width: Double
  private let thinPt = 2.0
  private let headLength = 0.035

  /// A straight line.
  func line(_ from: CGPoint, _ to: CGPoint, _ colour: Color = .primary, isDashed: Bool = false) {
    let style = StrokeStyle(lineWidth: thinPt, lineCap: .round, dash: isDashed ? [4 * thinPt, 3 * thinPt] : [])
    let path = Path { path in
      path.move(to: scaled(from))
      path.addLine(to: scaled(to))
    }
    context.stroke(path, with: .color(colour), style: style)
  }

  /// An outline, filled with the ground's colour or another.
  func shape(_ colour: Color = .primary, fill: Color? = Color(uiColor: .systemBackground), _ draw: (inout Path) -> Void)
  {
    let path = Path(draw).applying(CGAffineTransform(scaleX: width, y: width))
    if let fill { context.fill(path, with: .color(fill)) }
    context.stroke(path, with: .color(colour), style: StrokeStyle(lineWidth: thinPt, lineCap: .round, lineJoin: .round))
  }

  /// Straight lines from point to point, closed.
  func outline(_ points: [CGPoint], _ colour: Color = .primary, fill: Color? = Color(uiColor: .systemBackground)) {
    shape(colour, fill: fill) { path in
      path.addLines(points)
      path.closeSubpath()
    }
  }

  /// A dot: a knot, a suspension point.
  func dot(_ at: CGPoint, _ colour: Color = .accentColor, radius: Double = 0.012) {
    let (centre, radiusPt) = (scaled(at), radius * width)
    let box = CGRect(x: centre.x - radiusPt, y: centre.y - radiusPt, width: 2 * radiusPt, height: 2 * radiusPt)
    context.fill(Path(ellipseIn: box), with: .color(colour))
  }

  /// A dimension from end to end, with heads at both.
  func measure(_ from: CGPoint, _ to: CGPoint) {
    arrow(from, to)
    head(from, alongRad: atan2(from.y - to.y, from.x - to.x))
  }

  /// An arrow.
  func arrow(_ from: CGPoint, _ to: CGPoint) {
    line(from, to, .accentColor)
    head(to, alongRad: atan2(to.y - from.y, to.x - from.x))
  }

  /// The head of an arrow that points along an angle.
  func head(_ at: CGPoint, alongRad: Double) {
    let sides = [2.7, -2.7].map {
      CGPoint(x: at.x + headLength * cos(alongRad + $0), y: at.y + headLength * sin(alongRad + $0))
    }
    outline([at] + sides, .accentColor, fill: .accentColor)
  }

  /// Words around a point, on the ground's colour so that no line runs through them; whole within the picture.
  func words(_ at: CGPoint, _ text: String, _ colour: Color = .accentColor) {
    let laid = context.resolve(Text(text).font(.callout).foregroundStyle(colour))
    let size = laid.measure(in: CGSize(width: width, height: width))
    let left = min(max(0, at.x * width - size.width / 2), max(0, width - size.width))
    let box = CGRect(x: left, y: at.y * width - size.height / 2, width: size.width, height: size.height)
    context.fill(Path(box), with: .color(Color(uiColor: .systemBackground)))
    context.draw(laid, in: box)
  }

  private func scaled(_ point: CGPoint) -> CGPoint { CGPoint(x: point.x * width, y: point.y * width) }
}

/// A sketch so many times as high as it is wide, which VoiceOver describes in words.
struct Sketch: View {
  let says: String
  let heights: Double
  let draw: @MainActor (Pen) -> Void

  init(_ says: String, heights: Double, draw: @escaping @MainActor (Pen) -> Void) {
    (self.says, self.heights, self.draw) = (says, heights, draw)
  }

  var body: some View {
    Canvas { context, size in draw(Pen(context: context, width: size.width)) }
      .aspectRatio(1 / heights, contentMode: .fit)
      .frame(maxWidth: 480)
      .accessibilityElement()
      .accessibilityLabel(says)
      .accessibilityAddTraits(.isImage)
  }
}

/// A point of a picture.
func at(_ x: Double, _ y: Double) -> CGPoint { CGPoint(x: x, y: y) }
