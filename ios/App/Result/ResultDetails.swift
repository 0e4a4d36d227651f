import GyradiusApp
import GyradiusKit
import SwiftUI

/// Each quantity that is one number, with its uncertainty, the gyradii first.
struct Quantities: View {
  let quantities: [NamedQuantity]

  var body: some View {
    ForEach(headlines(quantities), id: \.name) { one in
      if let value = one.quantity.value.number, let u = one.quantity.u.number {
        Figure(label: quantityName(one.name), value: figure(one.name, value, u))
      }
    }
  }
}

/// What stands behind the result: folded away until somebody asks.
struct ResultDetails: View {
  let result: InertiaResult

  var body: some View {
    Fold(Words.intervals) {
      ForEach(headlines(result.quantities), id: \.name) { IntervalLine(one: $0) }
    }
    Fold(Words.consistency) {
      ForEach(result.consistency, id: \.self) { claim in
        if claim.flagged { Advice(text: spoken(claim.message)) } else { Text(spoken(claim.message)) }
      }
    }
    Fold(Words.budget) {
      ForEach(result.budget, id: \.name) { Budget(one: $0) }
    }
    Fold(Words.routes) {
      ForEach(result.alternatives, id: \.name) { Routes(one: $0) }
    }
    // A bare recording has nothing but its periods.
    Fold(Words.swings, isOpenAtFirst: headlines(result.quantities).isEmpty) {
      ForEach(result.swings, id: \.id) { SwingLines(one: $0) }
    }
  }
}

private struct IntervalLine: View {
  let one: NamedQuantity

  var body: some View {
    if let between = one.quantity.interval95, let u = one.quantity.u.number {
      let (low, high) = (withUncertainty(between.low, u).value, withUncertainty(between.high, u).value)
      Figure(label: quantityName(one.name), value: withUnit(Words.fromTo(low, high, unitOf(name: one.name))))
    }
  }
}

private struct Routes: View {
  let one: NamedRoutes

  var body: some View {
    Text(quantityName(one.name)).font(.headline)
    ForEach(one.routes, id: \.self) { route in
      Text("\(routeName(route.method)): \(figure(one.name, route.value, route.u))").monospacedDigit()
    }
  }
}

private struct SwingLines: View {
  let one: SwingResult

  var body: some View {
    Text(idName(one.id)).font(.headline)
    ForEach(one.modes, id: \.self) { mode in
      let period = withUncertainty(mode.periodS, mode.periodSeS)
      Text("\(mode.mode.word): \(Words.secondsU(period.value, period.u))").monospacedDigit()
    }
    ForEach(one.warnings, id: \.self) { Text(spoken($0)) }
  }
}
