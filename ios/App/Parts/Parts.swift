import SwiftUI

/// How grave a message is.
enum Tone {
  case info, caution, wrong

  var colour: Color {
    switch self {
    case .info: .green
    case .caution: .orange
    case .wrong: .red
    }
  }

  var symbol: String {
    switch self {
    case .info: "checkmark.circle.fill"
    case .caution: "exclamationmark.triangle.fill"
    case .wrong: "xmark.octagon.fill"
    }
  }
}

/// What must be done or known now: large, with a picture of its tone, so that colour is not all that tells.
struct Advice: View {
  let text: String
  var tone = Tone.caution

  var body: some View {
    Label(text, systemImage: tone.symbol)
      .font(.title3)
      .frame(maxWidth: .infinity, alignment: .leading)
      .padding()
      .background(tone.colour.opacity(0.2), in: RoundedRectangle(cornerRadius: 12))
  }
}

/// A figure and what it is; read as one by VoiceOver.
struct Figure: View {
  let label: String
  let value: String

  var body: some View {
    VStack(alignment: .leading) {
      Text(label).font(.subheadline).foregroundStyle(.secondary)
      Text(value).font(.title2.weight(.semibold)).monospacedDigit()
    }
    .frame(maxWidth: .infinity, alignment: .leading)
    .accessibilityElement(children: .combine)
  }
}

/// A figure to be read from some metres away, as large as fits.
struct LargeFigure: View {
  let label: String
  let value: String
  @ScaledMetric(relativeTo: .largeTitle) private var sizePt = 72.0

  var body: some View {
    VStack(alignment: .leading) {
      Text(label).font(.title3)
      Text(value).font(.system(size: sizePt, weight: .bold)).monospacedDigit().minimumScaleFactor(0.3).lineLimit(1)
    }
    .frame(maxWidth: .infinity, alignment: .leading)
    .accessibilityElement(children: .combine)
  }
}

/// A button for wet hands: the whole width, and high.
struct WideButton: View {
  let title: String
  var isMain = true
  let action: @MainActor () -> Void

  var body: some View {
    if isMain {
      button.buttonStyle(.borderedProminent)
    } else {
      button.buttonStyle(.bordered)
    }
  }

  private var button: some View {
    Button(action: action) {
      Text(title).font(.title3).frame(maxWidth: .infinity, minHeight: 52)
    }
  }
}

/// The head of a part of a screen.
struct SectionHead: View {
  let title: String

  var body: some View {
    Text(title).font(.title2.weight(.semibold)).accessibilityAddTraits(.isHeader)
  }
}

/// A part that is folded away until it is asked for.
struct Fold<Content: View>: View {
  let title: String
  @State private var isOpen: Bool
  private let content: Content

  init(_ title: String, isOpenAtFirst: Bool = false, @ViewBuilder content: () -> Content) {
    self.title = title
    _isOpen = State(initialValue: isOpenAtFirst)
    self.content = content()
  }

  var body: some View {
    DisclosureGroup(isExpanded: $isOpen) {
      VStack(alignment: .leading, spacing: 12) { content }.padding(.vertical, 8)
    } label: {
      SectionHead(title: title).frame(minHeight: 44)
    }
  }
}

/// Two columns where there is room for both, else one below the other.
struct TwoColumns<First: View, Second: View>: View {
  @Environment(\.horizontalSizeClass) private var width
  private let first: First
  private let second: Second

  init(@ViewBuilder first: () -> First, @ViewBuilder second: () -> Second) {
    self.first = first()
    self.second = second()
  }

  var body: some View {
    if width == .regular {
      HStack(alignment: .top, spacing: 32) {
        column(first)
        column(second)
      }
    } else {
      column(first)
      column(second)
    }
  }

  private func column(_ content: some View) -> some View {
    VStack(alignment: .leading, spacing: 16) { content }.frame(maxWidth: .infinity, alignment: .leading)
  }
}

/// Explains the screen that it stands on.
struct HelpButton: View {
  let text: String
  @State private var isOpen = false

  var body: some View {
    Button(Words.help, systemImage: "questionmark.circle") { isOpen = true }
      .alert(Words.help, isPresented: $isOpen) {
        Button(Words.close) {}
      } message: {
        Text(text)
      }
  }
}
