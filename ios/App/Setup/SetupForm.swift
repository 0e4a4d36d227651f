import GyradiusApp
import GyradiusKit
import SwiftUI

/// What is typed in before a plan is made.
struct SetupForm: View {
  @Bindable var setup: SetupModel

  var body: some View {
    TextField(Words.boatName, text: $setup.title).textFieldStyle(.roundedBorder).frame(minHeight: 44)
    NumberField(Words.boatMass, $setup.massKg)
    NumberField(Words.boatLength, $setup.lengthM)
    NumberField(Words.boatBeam, $setup.beamM)
    // A picker shows its own name in lists alone.
    LabeledContent(Words.type) {
      Picker(Words.type, selection: $setup.boatType) {
        ForEach(boatTypes(), id: \.self) { Text(boatTypeName($0)).tag($0) }
      }
    }
    Fold(Words.knownCloser) { known }
    Fold(Words.atHand) { room }
    Fold(Words.wanted) { wanted }
    Fold(Words.classLimits) { LimitsForm(limits: $setup.limits) }
    Fold(Words.finer) { finer }
  }

  @ViewBuilder private var known: some View {
    Text(Words.knownCloserSays)
    ForEach(SetupModel.knowable, id: \.self) { name in
      QuantityField(knownLabel(name), $setup.known[typed: name])
    }
  }

  @ViewBuilder private var room: some View {
    NumberField(Words.mostLineM, $setup.means.mostLineLengthM)
    NumberField(Words.leastLineM, $setup.means.leastLineLengthM)
    NumberField(Words.mostSpacingM, $setup.means.mostSpacingM)
    NumberField(Words.leastSpacingM, $setup.means.leastSpacingM)
    NumberField(Words.uLineM, $setup.means.uLineLengthM)
    NumberField(Words.uSpacingM, $setup.means.uSpacingM)
    NumberField(Words.uLevelDeg, $setup.means.uHullPitchDeg)
  }

  @ViewBuilder private var wanted: some View {
    Text(Words.wantedSays)
    ForEach(Array(zip(SetupModel.wantedUnits, SetupModel.knowable)), id: \.0.0) { wish, name in
      NumberField("\(quantityName(name)), \(wish.1)", $setup.wanted[wish.0])
    }
  }

  @ViewBuilder private var finer: some View {
    NumberField(Words.releaseDeg, $setup.means.amplitudeDeg)
    NumberField(Words.leastDurationS, $setup.means.leastDurationS)
    NumberField(Words.mostDurationS, $setup.means.mostDurationS)
    NumberField(Words.decayS, $setup.means.decayS)
    NumberField(Words.rateHz, $setup.means.rateHz)
    NumberField(Words.gyroNoise, $setup.means.gyroNoiseRadS)
    NumberField(Words.accNoise, $setup.means.accNoiseMS2)
    QuantityField(Words.gravityMS2, $setup.means.gravityMS2)
  }

  private func knownLabel(_ name: String) -> String { "\(quantityName(name)), \(unitOf(name: name))" }
}

/// Limits of the class, each a quantity, a side and a figure.
struct LimitsForm: View {
  @Binding var limits: [TypedLimit]

  var body: some View {
    Text(Words.classLimitsSays)
    ForEach($limits) { limit in
      LimitFields(limit: limit) { limits.removeAll { $0.id == limit.id } }
    }
    WideButton(title: Words.limitAdd, isMain: false) { limits.append(TypedLimit(quantity: "k_yaw_m")) }
  }
}

private struct LimitFields: View {
  @Binding var limit: TypedLimit
  let onRemove: @MainActor () -> Void

  var body: some View {
    Picker(Words.limit, selection: $limit.quantity) {
      ForEach(SetupModel.knowable, id: \.self) { Text(quantityName($0)).tag($0) }
    }
    Picker(Words.limit, selection: $limit.isLeast) {
      Text(Words.limitLeast).tag(true)
      Text(Words.limitMost).tag(false)
    }
    .pickerStyle(.segmented)
    NumberField("\(Words.limit), \(unitOf(name: limit.quantity))", $limit.value)
    Button(Words.limitRemove, role: .destructive, action: onRemove)
  }
}
