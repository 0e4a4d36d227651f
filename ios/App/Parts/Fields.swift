import GyradiusApp
import SwiftUI

/// A field for a number, with its name before it. What cannot be read counts as nothing typed in.
struct NumberField: View {
  let label: String
  @Binding var value: Double?
  @State private var text: String

  init(_ label: String, _ value: Binding<Double?>) {
    self.label = label
    _value = value
    _text = State(initialValue: value.wrappedValue.map { asTyped($0) } ?? "")
  }

  var body: some View {
    LabeledContent(label) {
      TextField("–", text: $text)
        .keyboardType(.numbersAndPunctuation)
        .multilineTextAlignment(.trailing)
        .foregroundStyle(isUnreadable ? Color.red : Color.primary)
        .accessibilityLabel(label)
        .onChange(of: text) { value = number(in: text) }
    }
    .frame(minHeight: 44)
  }

  private var isUnreadable: Bool { !text.isEmpty && number(in: text) == nil }
}

/// A figure and its uncertainty beside each other.
struct QuantityField: View {
  let label: String
  @Binding var typed: TypedQuantity

  init(_ label: String, _ typed: Binding<TypedQuantity>) {
    self.label = label
    _typed = typed
  }

  var body: some View {
    NumberField(label, $typed.value)
    NumberField("±", $typed.u).accessibilityHint(label)
  }
}
