import GyradiusApp
import GyradiusKit
import SwiftUI

/// The boat as it is roughly known, what is at hand, and what the planner advises.
struct SetupView: View {
  let onBegin: (_ task: ProcedureTask, _ limits: [String]) -> Void
  @State private var setup: SetupModel

  init(usualLimits: [String], onBegin: @escaping (_ task: ProcedureTask, _ limits: [String]) -> Void) {
    self.onBegin = onBegin
    _setup = State(initialValue: SetupModel(usualLimits: usualLimits))
  }

  var body: some View {
    ScrollView {
      TwoColumns {
        SetupForm(setup: setup)
      } second: {
        advice
      }
      .padding()
    }
    .scrollDismissesKeyboard(.interactively)
    .navigationTitle(Words.boat)
    .toolbar { HelpButton(text: Words.helpSetup) }
  }

  @ViewBuilder private var advice: some View {
    WideButton(title: Words.plan, isMain: setup.task == nil) { Task { await setup.makePlan() } }
      .disabled(setup.isPlanning)
    if setup.isPlanning { ProgressView() }
    if let error = setup.error { Advice(text: spoken(error), tone: .wrong) }
    if let task = setup.task {
      WideButton(title: Words.toTheBoat) { onBegin(task, setup.limitTexts) }
    }
    if let plan = setup.plan { PlanView(plan: plan) } else { WhatToMeasure() }
  }
}

/// What will have to be measured, as pictures.
private struct WhatToMeasure: View {
  var body: some View {
    SectionHead(title: Words.whatToMeasure)
    Text(Words.whatToMeasureSays)
    SuspensionSketch(.bifilar, .athwartships)
    Fold(Words.otherWays) {
      SuspensionSketch(.bifilar, .foreAndAft)
      FrameSketch(points: nil)
      SuspensionSketch(.compound, .athwartships)
    }
  }
}
