import GyradiusApp
import GyradiusKit
import SwiftUI

/// What the simulation gets wrong; where nobody has looked for it, the offer to look.
struct CriticisedView: View {
  let criticism: CriticismModel

  var body: some View {
    if let error = criticism.error { Advice(text: spoken(error), tone: .wrong) }
    SectionHead(title: Words.criticism)
    if let critique = criticism.critique {
      CritiqueBody(critique: critique, compared: criticism.compared)
    } else if let share = criticism.share {
      ProgressView(value: share)
      Text(Words.percentDone(100 * share))
    } else {
      Text(Words.criticiseSays)
      WideButton(title: Words.criticise, isMain: false) { Task { await criticism.criticise() } }
    }
  }
}

/// A status of the criticism in plain words; one that is not known yet reads as unexplained.
struct CritiqueStatus: View {
  let status: String
  let message: Sentence

  var body: some View {
    switch status {
    case "adequate": Advice(text: Words.statusAdequate, tone: .info)
    case "explained": Advice(text: Words.statusExplained, tone: .info)
    case "ambiguous": Advice(text: Words.statusAmbiguous)
    default: Advice(text: Words.statusUnexplained, tone: .wrong)
    }
    Text(spoken(message))
  }
}

private struct CritiqueBody: View {
  let critique: Critique
  let compared: [ComparedSwing]

  /// Causes further down are hardly probable.
  private static let mostCauses = 5
  /// What is less shows as nothing.
  private static let leastShiftM = 0.00005

  var body: some View {
    CritiqueStatus(status: critique.verdict.status, message: critique.verdict.message)
    ForEach(critique.warnings, id: \.self) { Advice(text: spoken($0)) }
    residuals
    if !critique.causes.isEmpty {
      Fold(Words.causes, isOpenAtFirst: true) {
        ForEach(critique.causes.prefix(Self.mostCauses), id: \.id) { CauseView(one: $0) }
      }
    }
    ForEach(compared, id: \.self) { ComparedView(one: $0) }
    if let next = critique.verdict.nextSwing {
      SectionHead(title: Words.nextSwing)
      Motions(excited: next.excited)
      Text(spoken(next.message))
    }
    if !critique.discrepancies.isEmpty {
      Fold(Words.discrepancies) { ForEach(critique.discrepancies, id: \.self) { Text(spoken($0.message)) } }
    }
  }

  /// Residual over noise: 1 is all that noise leaves.
  @ViewBuilder private var residuals: some View {
    if let before = critique.baseline.heldoutRmsOverNoise ?? critique.baseline.rmsOverNoise {
      Figure(label: Words.residualBefore, value: Words.timesNoise(before))
    }
    if let after = critique.extended.heldoutRmsOverNoise ?? critique.extended.rmsOverNoise {
      Figure(label: Words.residualAfter, value: Words.timesNoise(after))
    }
    if let shiftM = critique.gain.kYawShiftM, abs(shiftM) >= Self.leastShiftM {
      Figure(label: Words.kYawShift, value: Words.metresShift(shiftM))
    }
  }
}

private struct CauseView: View {
  let one: CauseResult

  var body: some View {
    VStack(alignment: .leading) {
      Text(Words.causeProbability(causeName(one.id), 100 * one.probability)).font(.headline)
      ProgressView(value: one.probability).accessibilityHidden(true)
      Text(spoken(one.message))
    }
    .accessibilityElement(children: .combine)
  }
}

private struct ComparedView: View {
  let one: ComparedSwing

  /// So much of a swing is drawn at once, s: some periods.
  private static let windowS = 20.0

  var body: some View {
    SectionHead(title: Words.comparedSwing(idName(one.swing)))
    Text(spoken(one.channel))
    CurvePlot(
      says: Words.comparedSays, unit: one.unit,
      drawn: [
        .init(name: Words.curveMeasured, curve: one.measured),
        .init(name: Words.curveBase, curve: one.base, isThin: true),
        .init(name: Words.curveExtended, curve: one.extended, isThin: true),
      ], windowS: Self.windowS)
  }
}
