import GyradiusApp
import GyradiusKit
import SwiftUI

/// The swing as it goes: first what is read from metres away.
struct RecordingBody: View {
  let recording: RecordingView

  var body: some View {
    if let leftS = recording.leftS {
      LargeFigure(label: Words.toGo, value: Words.seconds(leftS.rounded(.up)))
    } else {
      LargeFigure(label: Words.recorded, value: Words.seconds(recording.recordedS))
    }
    ForEach(recording.advice, id: \.self) { Advice(text: spoken($0)) }
    if let swing = recording.live?.swing { PeriodFigure(swing: swing) }
  }
}

/// The rest of what is known of the swing, for whoever stands beside it.
struct RecordingDetails: View {
  let recording: RecordingView
  let trace: [RecorderModel.Point]

  var body: some View {
    if !trace.isEmpty { TracePlot(points: trace) }
    if let amplitudeDeg = recording.amplitudeDeg {
      let wanted = recording.wantedDeg.map { Words.degreesOf(amplitudeDeg, $0) }
      Figure(label: Words.amplitude, value: wanted ?? Words.degrees(amplitudeDeg))
    }
    if let swing = recording.live?.swing {
      Text(words(of: swing.timeLeft)).font(.headline)
      SideMotions(lines: swing.lines)
    }
    if let live = recording.live {
      SectionHead(title: Words.sensors)
      ForEach(live.sensors, id: \.sensor) { Text(words(of: $0)).monospacedDigit() }
      GapsView(gaps: live.gaps)
    }
  }

  private func words(of left: TimeLeft) -> String {
    switch left {
    case .reached: Words.certainEnough
    case .seconds(let seconds): Words.certainIn(seconds)
    case .outOfReach: Words.certainNever
    }
  }

  /// What a sensor really does.
  private func words(of one: SensorState) -> String {
    guard let rateHz = one.rateHz else { return Words.noSamples(one.sensor.word) }
    return one.gaps == 0
      ? Words.rateNoGaps(one.sensor.word, rateHz)
      : Words.rateGaps(one.sensor.word, rateHz, Int(one.gaps), one.longestGapS)
  }
}

/// Whether the recording is good.
struct JudgementBody: View {
  let judgement: Judgement

  var body: some View {
    if judgement.recommend == .accept {
      Advice(text: Words.recommendAccept, tone: .info)
    } else {
      Advice(text: Words.recommendRepeat, tone: .wrong)
    }
    ForEach(judgement.reasons, id: \.self) { Advice(text: spoken($0)) }
    if let swing = judgement.swing { PeriodFigure(swing: swing) }
    if let incline = judgement.incline {
      let shown = withUncertainty(incline.angleDeg, incline.uDeg)
      Figure(label: Words.tilt, value: Words.degreesU(shown.value, shown.u))
    }
  }
}

/// What else there is to know of it.
struct JudgementDetails: View {
  let judgement: Judgement

  var body: some View {
    ForEach(judgement.notes, id: \.self) { Text(spoken($0)) }
    if let swing = judgement.swing { SideMotions(lines: swing.lines) }
    GapsView(gaps: judgement.gaps)
  }
}

/// Every time without samples, for whoever asks.
private struct GapsView: View {
  let gaps: GapList

  var body: some View {
    if !gaps.listed.isEmpty {
      Fold(Words.gaps) {
        Text(Words.gapsSay)
        ForEach(gaps.listed, id: \.self) { gap in
          Text(Words.gapOne(gap.fromS, gap.sensor.word, gap.lengthS)).monospacedDigit()
        }
        if gaps.more > 0 { Text(Words.gapsMore(Int(gaps.more))) }
      }
    }
  }
}

private struct PeriodFigure: View {
  let swing: SwingState

  var body: some View {
    let shown = withUncertainty(swing.periodS, swing.periodUS)
    Figure(label: Words.period, value: Words.secondsU(shown.value, shown.u))
  }
}

/// Motions that nobody asked for, each with a bar of its size.
private struct SideMotions: View {
  let lines: [SideMotion]

  /// What is less would read as 0 %.
  private static let leastShare = 0.005

  var body: some View {
    let seen = lines.filter { $0.share >= Self.leastShare }
    SectionHead(title: Words.unwanted)
    if seen.isEmpty { Text(Words.unwantedNone) }
    ForEach(seen, id: \.self) { one in
      Text(asShown(Words.unwantedOne(one.kind.word, 100 * one.share, one.periodS))).monospacedDigit()
      ProgressView(value: min(1, max(0, one.share))).accessibilityHidden(true)
    }
  }
}
