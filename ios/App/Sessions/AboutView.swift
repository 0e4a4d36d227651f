import GyradiusKit
import SwiftUI

/// What the app is, its versions, and how it tells what happens.
struct AboutView: View {
  @Environment(AppModel.self) private var app

  var body: some View {
    @Bindable var settings = app.settings
    Form {
      Section { Text(Words.aboutSays) }
      Section(Words.cues) {
        Toggle(Words.sound, isOn: $settings.isAloud)
        Toggle(Words.haptics, isOn: $settings.isFelt)
      }
      Section {
        LabeledContent(Words.versionApp, value: appVersion)
        LabeledContent(Words.versionLibrary, value: libraryVersion())
      }
      Section(Words.licences) { Text(Words.iosLicences) }
    }
    .navigationTitle(Words.about)
  }

  private var appVersion: String {
    Bundle.main.object(forInfoDictionaryKey: "CFBundleShortVersionString") as? String ?? ""
  }
}
