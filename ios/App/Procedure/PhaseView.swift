import GyradiusApp
import GyradiusKit
import SwiftUI

/// The picture and the figures of a phase.
struct PhaseView: View {
  let state: ProcedureState

  var body: some View {
    switch state.phase {
    case .level: if let tilt = state.tilt { LevelView(tilt: tilt) }
    case .hang: if let hanging = state.step?.hanging { SuspensionSketch(hanging) }
    case .ready: if let swing = state.step?.planned.swing { ReadyView(swing: swing) }
    case .suggest: if let swing = state.suggestion?.swing { SuggestedView(swing: swing) }
    default: EmptyView()
    }
    if let rest = state.rest { RestBody(rest: rest) }
    if let recording = state.recording { RecordingBody(recording: recording) }
    if let judgement = state.judgement { JudgementBody(judgement: judgement) }
    if let result = state.result {
      Quantities(quantities: result.quantities)
      ForEach(result.warnings, id: \.self) { Advice(text: spoken($0)) }
    }
  }
}

/// What need not be seen from afar.
struct DetailsView: View {
  @Environment(AppModel.self) private var app
  let state: ProcedureState

  var body: some View {
    if let recording = state.recording { RecordingDetails(recording: recording, trace: app.procedure.recorder.trace) }
    if let judgement = state.judgement { JudgementDetails(judgement: judgement) }
    if state.phase == .hang, let tilt = state.tilt { TiltFigures(tilt: tilt) }
    if let critique = state.critique {
      SectionHead(title: Words.criticism)
      CritiqueStatus(status: critique.status, message: critique.message)
    }
    if state.result != nil, let measurable = app.measurable {
      NavigationLink(Words.wholeResult, value: measurable).frame(minHeight: 44)
    }
  }
}

private struct SuggestedView: View {
  let swing: PlannedSwing

  var body: some View {
    SuspensionSketch(swing.suspension)
    Motions(excited: swing.excited)
  }
}

/// What to set going, before the recording.
private struct ReadyView: View {
  let swing: PlannedSwing

  var body: some View {
    Motions(excited: swing.excited)
    LargeFigure(label: Words.holdAside, value: Words.degreesWhole(swing.amplitudeDeg))
    Figure(label: Words.runsFor, value: Words.seconds(swing.durationS))
  }
}

/// The hull's tilt, live: a bubble where the direction is known, and figures to be read from afar.
private struct LevelView: View {
  let tilt: Tilt

  var body: some View {
    if let bowUpDeg = tilt.bowUpDeg, let starboardDownDeg = tilt.starboardDownDeg {
      Bubble(bowUpDeg: bowUpDeg, starboardDownDeg: starboardDownDeg).frame(maxWidth: .infinity)
    }
    TiltFigures(tilt: tilt)
  }
}

private struct TiltFigures: View {
  let tilt: Tilt

  var body: some View {
    if let bowUpDeg = tilt.bowUpDeg {
      LargeFigure(label: bowUpDeg < 0 ? Words.bowDown : Words.bowUp, value: Words.degrees(abs(bowUpDeg)))
    } else if let angleDeg = tilt.angleDeg {
      LargeFigure(label: Words.tilt, value: Words.degrees(abs(angleDeg)))
    }
    if let starboardDownDeg = tilt.starboardDownDeg {
      LargeFigure(
        label: starboardDownDeg < 0 ? Words.portDown : Words.starboardDown, value: Words.degrees(abs(starboardDownDeg)))
    }
  }
}

/// How long the hull has been still, and what the sensors showed.
private struct RestBody: View {
  let rest: RestView

  var body: some View {
    ZStack {
      Circle().stroke(Color.secondary.opacity(0.3), lineWidth: 16)
      Circle()
        .trim(from: 0, to: min(1, rest.stillS / rest.wantedS))
        .stroke(Color.accentColor, style: StrokeStyle(lineWidth: 16, lineCap: .round))
        .rotationEffect(.degrees(-90))
      Text(Words.seconds(rest.stillS)).font(.largeTitle.weight(.bold)).monospacedDigit()
    }
    .frame(width: 220, height: 220)
    .frame(maxWidth: .infinity)
    .padding()
    .accessibilityElement()
    .accessibilityLabel(Words.ofSeconds(rest.stillS, rest.wantedS))
    if let found = rest.found {
      sensors(found)
    } else if let moving = rest.moving {
      Figure(label: Words.moving, value: Words.movingBy(moving.rateDegS, moving.tiltDeg))
    }
  }

  @ViewBuilder private func sensors(_ found: RestReading) -> some View {
    rate(Words.gyroscope, found.gyroscope)
    if let accelerometer = found.accelerometer { rate(Words.accelerometer, accelerometer) }
    if let gravityMS2 = found.gravityMS2 { Figure(label: Words.gravity, value: Words.mS2(gravityMS2)) }
  }

  private func rate(_ name: String, _ sensor: SensorRest) -> some View {
    Figure(label: name, value: Words.rateAndGaps(sensor.rateHz, Int(sensor.gaps)))
  }
}
