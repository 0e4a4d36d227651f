import GyradiusApp
import GyradiusKit
import SwiftUI

/// A button for everything that may be done now; what is typed in has its fields.
struct ActionsView: View {
  @Environment(AppModel.self) private var app
  let state: ProcedureState

  var body: some View {
    ForEach(state.actions, id: \.self) { action in
      switch action {
      case .begin: BeginView()
      case .measured: MeasuringView(state: state)
      case .startRecording: WideButton(title: Words.actionStartRecording) { Task { await app.procedure.record() } }
      case .work:
        if app.procedure.isWorkStuck { WideButton(title: Words.actionWorkAgain) { app.procedure.workAgain() } }
      case .reopen: ReopenView(steps: Int(state.progress.steps))
      case .setReference: plain(Words.actionSetReference, .setReference, action)
      case .accept: plain(Words.actionAccept, .accept, action)
      case .repeat: plain(Words.actionRepeat, .repeat, action)
      case .skip: plain(Words.actionSkip, .skip, action)
      case .stopRecording: plain(Words.actionStopRecording, .stopRecording, action)
      case .continue: plain(Words.actionContinue, .continue, action)
      case .keep: plain(Words.actionKeep, .keep, action)
      case .retry: plain(Words.actionRetry, .retry, action)
      }
    }
  }

  /// An action that needs nothing but a touch.
  private func plain(_ title: String, _ event: ProcedureEvent, _ action: ProcedureAction) -> some View {
    WideButton(title: title, isMain: action == advised) { Task { await app.procedure.handle(event) } }
  }

  /// The action that stands out; none while there is nothing to do but wait.
  private var advised: ProcedureAction? {
    if state.phase == .rest, state.rest?.found == nil { return nil }
    return state.judgement?.recommend == .repeat ? .repeat : state.actions.first
  }
}

/// How the phone lies, and the beginning; the simulated phone of practice lies as it does.
private struct BeginView: View {
  @Environment(AppModel.self) private var app

  var body: some View {
    let settings = app.settings
    if !app.procedure.isPractice {
      SectionHead(title: Words.placement)
      PlacementSketch(isFlat: settings.isFlat)
      Choice(title: Words.placementFlat, isChosen: settings.isFlat) { settings.isFlat = true }
      Choice(title: Words.placementAny, isChosen: !settings.isFlat) { settings.isFlat = false }
    }
    WideButton(title: Words.actionBegin) { Task { await begin() } }
  }

  private func begin() async {
    if app.procedure.isPractice {
      await app.procedure.byTheBook()
    } else {
      await app.procedure.start(phone: AppModel.phone, placement: app.settings.placement)
    }
  }
}

/// One of several; its whole line can be touched.
private struct Choice: View {
  let title: String
  let isChosen: Bool
  let onChoice: @MainActor () -> Void

  var body: some View {
    Button(action: onChoice) {
      Label(title, systemImage: isChosen ? "largecircle.fill.circle" : "circle")
        .multilineTextAlignment(.leading)
        .frame(maxWidth: .infinity, minHeight: 44, alignment: .leading)
    }
    .accessibilityAddTraits(isChosen ? .isSelected : [])
  }
}

/// What was measured of the hanging: asked for while it is hung, and open to mending afterwards. In practice the simulated
/// hull's tape tells.
private struct MeasuringView: View {
  @Environment(AppModel.self) private var app
  let state: ProcedureState

  var body: some View {
    if let step = state.step {
      // A new step has new fields.
      form(step).id(step.id)
    }
  }

  @ViewBuilder private func form(_ step: StepView) -> some View {
    if state.phase != .hang {
      Fold(Words.measuredAgain) { HangingView(step) }
    } else if app.procedure.isPractice {
      WideButton(title: Words.actionMeasured) { Task { await app.procedure.byTheBook() } }
    } else {
      HangingView(step)
    }
  }
}

/// Everything that a step wants measured; it can be passed on once every field can be read.
private struct HangingView: View {
  @Environment(AppModel.self) private var app
  @State private var form: HangingForm

  init(_ step: StepView) {
    _form = State(initialValue: HangingForm(step))
  }

  var body: some View {
    ForEach($form.entries) { entry in QuantityField(entry.id.label, entry.typed) }
    WideButton(title: Words.actionMeasured) {
      guard let measured = form.measured else { return }
      Task { await app.procedure.handle(.measured(measured)) }
    }
    .disabled(form.measured == nil)
  }
}

/// Every step by its number; one that is not done is refused in words.
private struct ReopenView: View {
  @Environment(AppModel.self) private var app
  let steps: Int

  var body: some View {
    Fold(Words.actionReopen) {
      ForEach(0..<steps, id: \.self) { at in
        WideButton(title: Words.stepOf(at + 1, steps), isMain: false) {
          Task { await app.procedure.handle(.reopen(step: UInt64(at))) }
        }
      }
    }
  }
}

extension HangingForm.Dimension {
  fileprivate var label: String {
    switch self {
    case .lineLengthM: Words.lineLengthM
    case .spacingM: Words.spacingM
    case .topSpacingM: Words.topSpacingM
    case .hullPitchDeg: Words.hullPitchDeg
    case .pointsMovedM: Words.pointsMovedM
    case .axisHeightM: Words.axisHeightM
    case .massKg: Words.weightKg
    case .armM: Words.armM
    case .depthM: Words.depthM
    }
  }
}
