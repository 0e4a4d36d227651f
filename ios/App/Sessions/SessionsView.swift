import GyradiusApp
import SwiftUI
import UniformTypeIdentifiers

/// Where the app begins: what can be done, and what was measured.
struct SessionsView: View {
  @Environment(AppModel.self) private var app
  @Binding var path: [Place]
  @State private var isChoosing = false

  var body: some View {
    List {
      Section { beginning }
      Section { sessions }
    }
    .navigationTitle(Words.sessions)
    .toolbar {
      Button(Words.about, systemImage: "info.circle") { path.append(.about) }
    }
    .safeAreaInset(edge: .bottom) { undoing }
    .task { await app.refresh() }
    .fileImporter(isPresented: $isChoosing, allowedContentTypes: [.item]) { chosen in
      if case .success(let file) = chosen { take(file) }
    }
  }

  @ViewBuilder private var beginning: some View {
    if let error = app.sessions.error ?? app.procedure.error { Advice(text: spoken(error)) }
    WideButton(title: Words.measure) { path.append(.setup) }
    if app.sessions.isPracticeLeft {
      WideButton(title: Words.practiceGoOn, isMain: false) { practise(afresh: false) }
    }
    WideButton(title: Words.practise, isMain: false) { practise(afresh: true) }
    WideButton(title: Words.sessionsImport, isMain: false) { isChoosing = true }
  }

  @ViewBuilder private var sessions: some View {
    if app.sessions.listed.isEmpty { Text(Words.sessionsNone) }
    ForEach(app.sessions.listed) { session in
      SessionRow(session: session, onOpen: open)
        .swipeActions {
          Button(Words.sessionDelete, role: .destructive) { app.sessions.delete(session) }
        }
    }
  }

  /// Offers to put back what was taken off the list.
  @ViewBuilder private var undoing: some View {
    if let gone = app.sessions.deleted {
      HStack {
        Text(Words.sessionDeleted(gone.shownTitle))
        Spacer()
        Button(Words.undo) { Task { await app.sessions.undo() } }
        Button(Words.close, systemImage: "xmark") { app.sessions.forget() }.labelStyle(.iconOnly)
      }
      .padding()
      .background(.regularMaterial)
    }
  }

  private func open(_ session: Listed) {
    guard let measurable = app.sessions.store.measurable(session.folder) else { return }
    path.append(.result(measurable))
  }

  private func practise(afresh: Bool) {
    Task { await app.practise(afresh: afresh) }
  }

  /// A file of another app may be read between these two calls alone.
  private func take(_ file: URL) {
    Task {
      let isLent = file.startAccessingSecurityScopedResource()
      await app.sessions.take(file)
      if isLent { file.stopAccessingSecurityScopedResource() }
    }
  }
}

extension Listed {
  var shownTitle: String { title.isEmpty ? Words.sessionUntitled : title }
}
