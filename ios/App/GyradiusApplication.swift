import SwiftUI

@main
struct GyradiusApplication: App {
  @State private var app = AppModel()

  var body: some Scene {
    WindowGroup {
      RootView().environment(app)
    }
  }
}
