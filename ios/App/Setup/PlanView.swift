import GyradiusApp
import GyradiusKit
import SwiftUI

/// What the planner advises: warnings first, then what to expect, then how to hang it.
struct PlanView: View {
  let plan: PlanResult

  var body: some View {
    ForEach(plan.warnings, id: \.self) { Advice(text: spoken($0)) }
    SectionHead(title: Words.expected)
    ForEach(plan.quantities, id: \.name) { Expected(one: $0) }
    Figure(label: Words.effort, value: Words.minutes(plan.effortS / 60))
    SectionHead(title: Words.howToHang)
    ForEach(plan.suspensions, id: \.self) { Hung(one: $0) }
    Fold(Words.periodsExpected) {
      ForEach(plan.predicted, id: \.id) { Periods(one: $0) }
    }
    Fold(Words.budget) {
      ForEach(plan.budget, id: \.name) { Budget(one: $0) }
    }
  }
}

private struct Expected: View {
  let one: NamedPrediction

  var body: some View {
    HStack {
      Figure(label: quantityName(one.name), value: shown)
      if let isReached = one.quantity.isReached { reached(isReached) }
    }
    .accessibilityElement(children: .combine)
  }

  private var shown: String { one.quantity.u.map { figure(one.name, one.quantity.value, $0) } ?? Words.notDetermined }

  @ViewBuilder private func reached(_ isReached: Bool) -> some View {
    if isReached {
      Image(systemName: "checkmark.circle.fill").foregroundStyle(.green).accessibilityLabel(Words.reached)
    } else {
      Text(Words.notReached).foregroundStyle(.red)
    }
  }
}

private struct Hung: View {
  let one: HangingAdvice

  var body: some View {
    Text(Words.framePoints(one.framePoints, one.swings.map(idName).joined(separator: ", "))).font(.headline)
    Text(spoken(one.message))
    FrameSketch(points: one.framePoints)
  }
}

private struct Periods: View {
  let one: PredictedSwing

  var body: some View {
    VStack(alignment: .leading) {
      Text(idName(one.id)).font(.headline)
      ForEach(modes, id: \.mode) { Text(Words.modePeriod($0.mode.word, $0.periodS)) }
      if let beat = one.beat { Text(beat.periodS.map(Words.beat) ?? Words.beatNone) }
    }
    .monospacedDigit()
    .accessibilityElement(children: .combine)
  }

  /// The slowest first: a map has no order of its own.
  private var modes: [(mode: ModeName, periodS: Double)] {
    one.periodsS.map { (mode: $0.key, periodS: $0.value) }.sorted { $0.periodS > $1.periodS }
  }
}

/// What an uncertainty comes from, the largest first.
struct Budget: View {
  let one: NamedBudget

  /// Contributions beyond these hardly count.
  private static let mostLines = 4

  var body: some View {
    Text(quantityName(one.name)).font(.headline)
    ForEach(one.lines.prefix(Self.mostLines), id: \.input) { line in
      LabeledContent(
        inputName(line.input), value: withUnit(Words.contribution(line.uContribution, unitOf(name: one.name))))
    }
  }
}
