import GyradiusApp
import GyradiusKit
import SwiftUI

/// A session: what it is, where it stands, its figures, and what can be done with it.
struct SessionRow: View {
  @Environment(AppModel.self) private var app
  let session: Listed
  let onOpen: (Listed) -> Void

  var body: some View {
    VStack(alignment: .leading, spacing: 6) {
      Text(session.shownTitle).font(.headline).accessibilityAddTraits(.isHeader)
      if let at = session.at { Text(at.formatted(date: .abbreviated, time: .shortened)).foregroundStyle(.secondary) }
      Text(standing)
      ForEach(headlines(session.figures), id: \.name) { one in
        if let value = one.quantity.value.number, let u = one.quantity.u.number {
          Text("\(quantityName(one.name)): \(figure(one.name, value, u))").monospacedDigit()
        }
      }
      HStack { actions }.buttonStyle(.bordered)
    }
  }

  @ViewBuilder private var actions: some View {
    if canBeOpened { Button(Words.sessionOpen) { onOpen(session) } }
    if session.phase != nil {
      Button(Words.sessionGoOn) { Task { await app.goOn(with: session) } }
    }
    if let measurable = app.sessions.store.measurable(session.folder) {
      ShareLink(item: SharedSession(measurable), preview: SharePreview(session.shownTitle)) {
        Text(Words.sessionShare)
      }
    }
  }

  private var canBeOpened: Bool { session.damage == nil && (session.phase == nil || !session.figures.isEmpty) }

  private var standing: String {
    session.damage.map(Words.sessionDamaged) ?? session.phase?.title ?? Words.sessionFromFile
  }
}
