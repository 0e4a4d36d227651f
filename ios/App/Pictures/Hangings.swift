import GyradiusKit
import SwiftUI

/// What to measure of the way that a hull hangs.
struct SuspensionSketch: View {
  let kind: SuspensionKind
  let orientation: Orientation

  init(_ kind: SuspensionKind, _ orientation: Orientation) {
    (self.kind, self.orientation) = (kind, orientation)
  }

  init(_ hung: Suspension) {
    self.init(hung.kind, hung.orientation)
  }

  var body: some View {
    switch (kind, orientation) {
    case (.compound, _): compound
    case (_, .foreAndAft): foreAndAft
    case (_, .athwartships): athwartships
    }
  }

  private var athwartships: some View {
    Sketch(Words.sketchAthwartships, heights: 0.82) { pen in
      pen.beam(from: 0.12, to: 0.88)
      pen.hullFromAhead(0.56)
      pen.twoLines(left: 0.3, right: 0.7, top: 0.07, bottom: 0.56)
      pen.measure(at(0.88, 0.08), at(0.88, 0.55))
      pen.words(at(0.84, 0.3), Words.sketchLength)
      pen.measure(at(0.31, 0.47), at(0.69, 0.47))
      pen.words(at(0.5, 0.41), Words.sketchSpacing)
    }
  }

  private var foreAndAft: some View {
    Sketch(Words.sketchForeAndAft, heights: 0.72) { pen in
      pen.beam(from: 0.06, to: 0.94)
      pen.hullFromTheSide(0.56)
      pen.twoLines(left: 0.25, right: 0.72, top: 0.07, bottom: 0.555)
      pen.measure(at(0.9, 0.08), at(0.9, 0.53))
      pen.words(at(0.86, 0.3), Words.sketchLength)
      pen.measure(at(0.26, 0.47), at(0.71, 0.47))
      pen.words(at(0.485, 0.41), Words.sketchSpacing)
    }
  }

  /// Two inverted Vs: the hull turns about the line through their tips.
  private var compound: some View {
    Sketch(Words.sketchCompound, heights: 0.75) { pen in
      pen.hullFromTheSide(0.58)
      pen.line(at(0.5, 0.12), at(0.28, 0.575))
      pen.line(at(0.5, 0.12), at(0.72, 0.57))
      pen.dot(at(0.28, 0.573))
      pen.dot(at(0.72, 0.573))
      pen.dot(at(0.5, 0.12), radius: 0.02)
      pen.line(at(0.5, 0.12), at(0.9, 0.12), .accentColor, isDashed: true)
      pen.line(at(0.72, 0.572), at(0.9, 0.572), .accentColor, isDashed: true)
      pen.measure(at(0.87, 0.13), at(0.87, 0.56))
      pen.words(at(0.8, 0.34), Words.sketchAxisHeight)
      pen.words(at(0.5, 0.05), Words.sketchAxis)
    }
  }
}

/// The square frame on the hull with its lettered points, bow upwards; those that it hangs on stand out.
struct FrameSketch: View {
  /// `B-F`; absent where none is chosen yet.
  let points: String?

  /// A point of the frame, and where its letter stands beside it.
  private struct FramePoint {
    let letter: String
    let place: CGPoint
    let letterPlace: CGPoint

    init(_ letter: String, _ x: Double, _ y: Double, _ besideX: Double, _ besideY: Double) {
      (self.letter, place, letterPlace) = (letter, at(x, y), at(x + besideX, y + besideY))
    }
  }

  /// Clockwise from the forward corner at starboard; A, H and G are the forward side.
  private static let frame = [
    FramePoint("A", 0.74, 0.32, 0.06, 0), FramePoint("B", 0.74, 0.56, 0.06, 0), FramePoint("C", 0.74, 0.8, 0.06, 0),
    FramePoint("D", 0.5, 0.8, 0.05, 0.06), FramePoint("E", 0.26, 0.8, -0.06, 0),
    FramePoint("F", 0.26, 0.56, -0.06, 0), FramePoint("G", 0.26, 0.32, -0.06, 0),
    FramePoint("H", 0.5, 0.32, 0.05, -0.06),
  ]

  var body: some View {
    Sketch(Words.sketchFrame, heights: 1.05) { pen in
      pen.hullFromAbove(top: 0.1, bottom: 0.98, halfBeam: 0.2)
      pen.words(at(0.5, 0.05), Words.bow, .primary)
      pen.outline([at(0.26, 0.32), at(0.74, 0.32), at(0.74, 0.8), at(0.26, 0.8)], fill: nil)
      let hung = (points ?? "").split(separator: "-").map(String.init)
      let ends = Self.frame.filter { hung.contains($0.letter) }
      if ends.count == 2 { pen.line(ends[0].place, ends[1].place, .accentColor, isDashed: true) }
      for point in Self.frame {
        let isEnd = hung.contains(point.letter)
        pen.dot(point.place, isEnd ? .accentColor : .primary, radius: isEnd ? 0.022 : 0.012)
        pen.words(point.letterPlace, point.letter, isEnd ? .accentColor : .primary)
      }
    }
  }
}

/// How the phone lies, with its axes.
struct PlacementSketch: View {
  let isFlat: Bool

  var body: some View {
    Sketch(isFlat ? Words.sketchFlat : Words.sketchAnyWay, heights: 0.95) { pen in
      pen.hullFromAbove(top: 0.1, bottom: 0.9, halfBeam: 0.3)
      pen.words(at(0.5, 0.05), Words.bow, .primary)
      isFlat ? flatPhone(pen) : twistedPhone(pen)
    }
  }

  private func flatPhone(_ pen: Pen) {
    pen.outline([at(0.41, 0.4), at(0.59, 0.4), at(0.59, 0.74), at(0.41, 0.74)], .accentColor)
    pen.line(at(0.47, 0.43), at(0.53, 0.43), .accentColor)
    pen.arrow(at(0.5, 0.58), at(0.5, 0.26))
    pen.arrow(at(0.5, 0.58), at(0.72, 0.58))
    pen.words(at(0.55, 0.29), "y")
    pen.words(at(0.73, 0.64), "x")
    pen.dot(at(0.5, 0.58))
    pen.words(at(0.46, 0.64), "z")
  }

  private func twistedPhone(_ pen: Pen) {
    pen.outline([at(0.48, 0.36), at(0.68, 0.46), at(0.52, 0.76), at(0.32, 0.66)], .accentColor)
    pen.words(at(0.5, 0.57), "?")
  }
}
