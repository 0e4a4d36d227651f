import GyradiusApp
import GyradiusKit
import SwiftUI

/// Where the operator can go from the list of sessions.
enum Place: Hashable {
  case setup
  case about
  case result(Measurable)
}

/// The list of sessions, what it leads to, and above it the procedure while one is under way.
struct RootView: View {
  @Environment(AppModel.self) private var app
  @Environment(\.scenePhase) private var scenePhase
  @State private var path: [Place] = []

  var body: some View {
    @Bindable var app = app
    NavigationStack(path: $path) {
      SessionsView(path: $path)
        .navigationDestination(for: Place.self) { place in
          switch place {
          case .setup: SetupView(usualLimits: app.sessions.store.usualLimits, onBegin: begin)
          case .about: AboutView()
          case .result(let measurable): ResultView(measurable: measurable)
          }
        }
    }
    .fullScreenCover(isPresented: $app.isUnderWay) { ProcedureView() }
    .onChange(of: scenePhase) { _, phase in follow(phase) }
  }

  private func begin(_ task: ProcedureTask, limits: [String]) {
    Task {
      await app.measure(task, limits: limits)
      path = []
    }
  }

  /// iOS gives an app that is not on the screen neither time nor samples.
  private func follow(_ phase: ScenePhase) {
    switch phase {
    case .active: if app.isUnderWay { app.procedure.goOnLooking() }
    case .background: Task { await app.procedure.pauseLooking() }
    default: break
    }
  }
}
