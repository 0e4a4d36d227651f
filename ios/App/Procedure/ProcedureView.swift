import GyradiusApp
import GyradiusKit
import SwiftUI
import UIKit

/// The procedure: what to do now, what is measured, what may be done. The screen stays on, for nobody touches it.
struct ProcedureView: View {
  @Environment(AppModel.self) private var app

  var body: some View {
    NavigationStack {
      if let state = app.procedure.state { page(state) }
    }
    .onAppear { UIApplication.shared.isIdleTimerDisabled = true }
    .onDisappear { UIApplication.shared.isIdleTimerDisabled = false }
  }

  private func page(_ state: ProcedureState) -> some View {
    ScrollView {
      VStack(alignment: .leading, spacing: 16) {
        StepProgress(state: state)
        if app.procedure.isPractice { PracticeBanner(procedure: app.procedure) }
        TwoColumns {
          NowView(state: state)
        } second: {
          ActionsView(state: state)
          DetailsView(state: state)
        }
      }
      .padding()
    }
    .navigationTitle(state.phase.title)
    .navigationDestination(for: Measurable.self) { ResultView(measurable: $0) }
    .toolbar {
      ToolbarItem(placement: .topBarLeading) {
        Button(Words.back, systemImage: "chevron.backward") { Task { await app.leave() } }.disabled(!app.mayLeave)
      }
      ToolbarItem(placement: .topBarTrailing) { SoundButton() }
      ToolbarItem(placement: .topBarTrailing) { HelpButton(text: state.phase.help) }
    }
  }
}

private struct StepProgress: View {
  let state: ProcedureState

  var body: some View {
    VStack(alignment: .leading) {
      ProgressView(value: state.progress.share)
      if let step = state.step { Text(words(step)).font(.headline) }
    }
    .accessibilityElement(children: .combine)
  }

  private func words(_ step: StepView) -> String {
    let take = step.take > 1 ? [Words.take(Int(step.take))] : []
    return ([Words.stepOf(Int(step.index) + 1, Int(step.count)), idName(step.id)] + take).joined(separator: " · ")
  }
}

/// Says that nothing of this is real, and lets simulated time go by faster.
private struct PracticeBanner: View {
  @Bindable var procedure: ProcedureModel

  /// Simulated seconds in a real one.
  private static let paces = [1, 10, 60]

  var body: some View {
    VStack(alignment: .leading) {
      Text(Words.practiceBanner)
      Picker(Words.practiceBanner, selection: $procedure.pace) {
        ForEach(Self.paces, id: \.self) { Text("\($0)×").tag($0) }
      }
      .pickerStyle(.segmented)
    }
    .padding()
    .background(Color.green.opacity(0.2), in: RoundedRectangle(cornerRadius: 12))
  }
}

private struct SoundButton: View {
  @Environment(AppModel.self) private var app

  var body: some View {
    let isAloud = app.settings.isAloud
    Button(isAloud ? Words.soundOff : Words.soundOn, systemImage: isAloud ? "speaker.wave.2" : "speaker.slash") {
      app.settings.isAloud.toggle()
    }
  }
}

/// What is to be done, and what is measured.
private struct NowView: View {
  @Environment(AppModel.self) private var app
  let state: ProcedureState

  var body: some View {
    Text(instruction).font(.title2).onChange(of: instruction) { announce() }
    if let error = app.procedure.error { Advice(text: spoken(error), tone: .wrong) }
    ForEach(Channel.all.filter(app.procedure.recorder.silent.contains), id: \.self) { channel in
      Advice(
        text: channel == .accelerometer ? Words.sensorStoppedAccelerometer : Words.sensorStoppedGyroscope, tone: .wrong)
    }
    ForEach(state.warnings, id: \.self) { Advice(text: spoken($0)) }
    PhaseView(state: state)
    if state.work != nil, !app.procedure.isWorkStuck { working }
  }

  /// At the end the library names the folder, which the list of sessions has.
  private var instruction: String { state.phase == .done ? Words.doneSays : spoken(state.instruction) }

  @ViewBuilder private var working: some View {
    if let share = app.procedure.workShare {
      ProgressView(value: share)
      Text(Words.percentDone(100 * share)).font(.title3)
    } else {
      ProgressView()
    }
  }

  /// While figures run, words that change with them would never end.
  private func announce() {
    guard ![.level, .rest, .record].contains(state.phase) else { return }
    UIAccessibility.post(notification: .announcement, argument: instruction)
  }
}
