import GyradiusApp
import GyradiusKit
import SwiftUI

/// The whole result of a session: figures, verdicts, criticism, report.
struct ResultView: View {
  let measurable: Measurable
  @State private var model = ResultModel()
  @State private var printer = ReportPrinter()

  var body: some View {
    ScrollView {
      VStack(alignment: .leading, spacing: 16) {
        if let error = model.error { Advice(text: spoken(error), tone: .wrong) }
        if let share = model.share { ProgressView(value: share) }
        if let result = model.result {
          TwoColumns {
            MeasuredView(model: model, result: result)
          } second: {
            CriticisedView(criticism: model.criticism)
            RecordingsView(recordings: model.recordings)
          }
        }
      }
      .padding()
    }
    .navigationTitle(measurable.title.isEmpty ? Words.sessionUntitled : measurable.title)
    .toolbar {
      if model.result != nil {
        ShareLink(item: SharedReport(model: model), preview: SharePreview(Words.report)) {
          Label(Words.reportShare, systemImage: "square.and.arrow.up")
        }
        Button(Words.reportPrint, systemImage: "printer") { Task { await print() } }
      }
      HelpButton(text: Words.helpResult)
    }
    .task { await model.open(measurable, in: libraryLanguage) }
  }

  private func print() async {
    let folder = FileManager.default.temporaryDirectory
    guard let report = await model.report(into: folder, in: libraryLanguage) else { return }
    printer.print(report)
  }
}

private struct MeasuredView: View {
  let model: ResultModel
  let result: InertiaResult
  @Environment(AppModel.self) private var app
  @State private var limits: [TypedLimit]

  init(model: ResultModel, result: InertiaResult) {
    (self.model, self.result) = (model, result)
    _limits = State(initialValue: model.limits.compactMap(TypedLimit.init(_:)))
  }

  var body: some View {
    ForEach(result.verdicts, id: \.self) { VerdictView(one: $0) }
    Quantities(quantities: result.quantities)
    ForEach(result.warnings, id: \.self) { Advice(text: spoken($0)) }
    Fold(Words.classLimits) {
      LimitsForm(limits: $limits)
      // Where the last one was taken away, too, there is something to judge anew.
      if !limits.isEmpty || !model.limits.isEmpty { WideButton(title: Words.limitJudge, action: judge) }
    }
    Ellipsoid(result.quantities)
    ResultDetails(result: result)
  }

  private func judge() {
    Task { await model.judge(by: limits.compactMap(\.text), keepingIn: app.sessions.store) }
  }
}

/// What is to be thought of one limit.
private struct VerdictView: View {
  let one: Verdict

  var body: some View {
    VStack(alignment: .leading) {
      Advice(text: words, tone: tone)
      Text(withUnit(Words.limitIs(quantityName(one.quantity), sign, asTyped(one.limit), unitOf(name: one.quantity))))
      Text(Words.limitProbability(100 * one.conformanceProbability))
    }
    .accessibilityElement(children: .combine)
  }

  private var sign: String { one.relation == ">=" ? "≥" : "≤" }

  private var words: String {
    switch one.verdict {
    case "pass": Words.verdictPass
    case "fail": Words.verdictFail
    default: Words.verdictUndecided
    }
  }

  private var tone: Tone {
    switch one.verdict {
    case "pass": .info
    case "fail": .wrong
    default: .caution
    }
  }
}

private struct RecordingsView: View {
  let recordings: [RecordingFigureData]

  var body: some View {
    if !recordings.isEmpty {
      Fold(Words.recordings) {
        ForEach(recordings, id: \.id) { recording in
          Text(idName(recording.id)).font(.headline)
          ForEach(recording.traces, id: \.label) { TraceView(trace: $0) }
        }
      }
    }
  }
}

/// A channel of a recording, closely where the library has it closely, and what the fit leaves.
private struct TraceView: View {
  let trace: Trace

  var body: some View {
    Text(trace.label)
    CurvePlot(
      says: Words.fitSays, unit: trace.unit,
      drawn: [
        .init(name: Words.curveMeasured, curve: trace.closeUp?.measured ?? trace.measured),
        .init(name: Words.curveFit, curve: trace.closeUp?.model ?? trace.model, isThin: true),
      ])
    CurvePlot(
      says: Words.residualSays, unit: trace.unit,
      drawn: [.init(name: Words.curveResidual, curve: trace.residual, isThin: true)])
  }
}
