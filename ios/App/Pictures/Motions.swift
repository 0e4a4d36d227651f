import GyradiusKit
import SwiftUI

/// The motions to set going, each with its picture and its name.
struct Motions: View {
  let excited: [Excitation]

  var body: some View {
    HStack(alignment: .top, spacing: 16) {
      ForEach(excited, id: \.self) { one in
        VStack {
          MotionPicture(excited: one).frame(maxWidth: 260)
          Text(one.word).font(.title2.weight(.bold))
          Text(one.howTo).multilineTextAlignment(.center)
        }
        .accessibilityElement(children: .combine)
      }
    }
    .frame(maxWidth: .infinity)
  }
}

private struct MotionPicture: View {
  let excited: Excitation

  var body: some View {
    switch excited {
    case .yaw: Sketch(Words.sketchYaw, heights: 1, draw: yaw)
    case .sway: Sketch(Words.sketchSway, heights: 1, draw: sway)
    case .surge: Sketch(Words.sketchSurge, heights: 1, draw: surge)
    case .pitch: Sketch(Words.sketchPitch, heights: 1, draw: pitch)
    case .roll: Sketch(Words.sketchRoll, heights: 1, draw: roll)
    }
  }

  private func fromAbove(_ pen: Pen) {
    pen.hullFromAbove(top: 0.08, bottom: 0.92, halfBeam: 0.17)
    for x in [0.36, 0.64] { pen.dot(at(x, 0.52), .primary, radius: 0.02) }
  }

  private func yaw(_ pen: Pen) {
    fromAbove(pen)
    pen.turn(around: 0.5, 0.5, radius: 0.38, fromDeg: -60)
    pen.turn(around: 0.5, 0.5, radius: 0.38, fromDeg: 120)
  }

  private func sway(_ pen: Pen) {
    fromAbove(pen)
    pen.arrow(at(0.72, 0.5), at(0.95, 0.5))
    pen.arrow(at(0.28, 0.5), at(0.05, 0.5))
  }

  private func surge(_ pen: Pen) {
    pen.hungFromTheSide()
    pen.arrow(at(0.6, 0.86), at(0.9, 0.86))
    pen.arrow(at(0.4, 0.86), at(0.1, 0.86))
  }

  private func pitch(_ pen: Pen) {
    pen.hungFromTheSide()
    pen.turn(around: 0.5, 0.64, radius: 0.38, fromDeg: 125)
    pen.turn(around: 0.5, 0.64, radius: 0.38, fromDeg: 20)
  }

  private func roll(_ pen: Pen) {
    pen.line(at(0.5, 0.06), at(0.5, 0.5))
    pen.hullFromAhead(0.5)
    pen.dot(at(0.5, 0.5), .primary, radius: 0.02)
    pen.turn(around: 0.5, 0.56, radius: 0.4, fromDeg: 130)
    pen.turn(around: 0.5, 0.56, radius: 0.4, fromDeg: 20)
  }
}
