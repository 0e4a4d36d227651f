import Foundation
import GyradiusKit

/// A figure and its uncertainty as text, the uncertainty with two digits and the figure as many places: layout only.
public func withUncertainty(_ value: Double, _ u: Double, locale: Locale = .current) -> (value: String, u: String) {
  guard u.isFinite, u > 0 else { return (plain(value, 4, locale), "–") }
  // Of 0.0996, too, two digits are shown: 0.10.
  let places = (0...12).first { (u * pow(10, Double($0))).rounded() >= 10 } ?? 12
  return (plain(value, places, locale), plain(u, places, locale))
}

/// A sentence of the library as a screen shows it: with a capital at its head where that is a word, and no line that ends between
/// a figure and its unit.
public func asShown(_ sentence: String) -> String {
  sentence
    .replacing(/^[a-zäöü](?=[\p{L} ])/) { $0.output.uppercased() }
    .replacing(/(\d) (?=(?:s|min|mm|m|m\/s²|mrad\/s|rad\/s|Hz|kg|ppm|%)(?![\p{L}\d]))/) { "\($0.output.1)\u{A0}" }
}

/// A text that ends in a unit; the degree sign stands close to its figure.
public func withUnit(_ text: String) -> String { text.replacingOccurrences(of: "\u{A0}°", with: "°") }

/// A number as people type it, with a comma or a point.
public func number(in text: String) -> Double? {
  let plain = text.trimmingCharacters(in: .whitespaces).replacingOccurrences(of: ",", with: ".")
  return Double(plain).flatMap { $0.isFinite ? $0 : nil }
}

/// A figure as it stands in a field before anybody types: six digits, no exponent.
public func asTyped(_ value: Double, locale: Locale = .current) -> String {
  value.formatted(.number.precision(.significantDigits(1...6)).grouping(.never).locale(locale))
}

/// The quantities that are one number, the gyradii first, as the report has them.
public func headlines(_ quantities: [NamedQuantity]) -> [NamedQuantity] {
  let order = ["k_yaw_m", "k_pitch_m", "k_roll_m", "cm_depth_m", "psi_deg"]
  let numbers = quantities.filter { $0.quantity.value.number != nil && $0.quantity.u.number != nil }
  return order.flatMap { name in numbers.filter { $0.name == name } } + numbers.filter { !order.contains($0.name) }
}

/// With a minus sign as long as a plus, as the library writes it.
private func plain(_ value: Double, _ places: Int, _ locale: Locale) -> String {
  value.formatted(.number.precision(.fractionLength(places)).locale(locale)).replacingOccurrences(of: "-", with: "−")
}
