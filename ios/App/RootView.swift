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
    .onChange(of: scenePhase) { _, phase in Task { await app.procedure.follow(presence(phase)) } }
  }

  private func begin(_ task: ProcedureTask, limits: [String]) {
    Task {
      await app.measure(task, limits: limits)
      path = []
    }
  }

  /// What iOS may add to its phases has the screen at least.
  private func presence(_ phase: ScenePhase) -> Presence {
    switch phase {
    case .active: .active
    case .background: .background
    default: .inactive
    }
  }
}
