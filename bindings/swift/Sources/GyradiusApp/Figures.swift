import Foundation

/// A figure and its uncertainty as text, the uncertainty with two digits and the figure as many places: layout only.
public func withUncertainty(_ value: Double, _ u: Double, locale: Locale = .current) -> (value: String, u: String) {
  guard u.isFinite, u > 0 else { return (plain(value, 4, locale), "–") }
  // Of 0.0996, too, two digits are shown: 0.10.
  let places = (0...12).first { (u * pow(10, Double($0))).rounded() >= 10 } ?? 12
  return (plain(value, places, locale), plain(u, places, locale))
}

/// `k_yaw_m` is read as "k yaw" in m.
public func nameAndUnit(_ name: String) -> (name: String, unit: String) {
  let endings = [
    ("_kg_m2", "kg m²"), ("_m_s2", "m/s²"), ("_deg", "°"), ("_kg", "kg"), ("_m", "m"), ("_s", "s"),
  ]
  let (ending, unit) = endings.first { name.hasSuffix($0.0) } ?? ("", "")
  return (String(name.dropLast(ending.count).map { $0 == "_" ? " " : $0 }), unit)
}

private func plain(_ value: Double, _ places: Int, _ locale: Locale) -> String {
  value.formatted(.number.precision(.fractionLength(places)).locale(locale))
}
