import Foundation
import GyradiusKit
import Observation

/// What the operator likes; kept between two starts of the app.
@MainActor @Observable
public final class Settings {
  /// Whether cues are spoken.
  public var isAloud: Bool { didSet { defaults.set(isAloud, forKey: "isAloud") } }
  /// Whether cues are felt.
  public var isFelt: Bool { didSet { defaults.set(isFelt, forKey: "isFelt") } }
  /// Whether the phone lies flat with its top edge to the bow.
  public var isFlat: Bool { didSet { defaults.set(isFlat, forKey: "isFlat") } }

  private let defaults: UserDefaults

  public init(_ defaults: UserDefaults = .standard) {
    self.defaults = defaults
    defaults.register(defaults: ["isAloud": true, "isFelt": true, "isFlat": true])
    isAloud = defaults.bool(forKey: "isAloud")
    isFelt = defaults.bool(forKey: "isFelt")
    isFlat = defaults.bool(forKey: "isFlat")
  }

  /// How the phone lies.
  public var placement: Placement { isFlat ? .flatTopToBow : .anyWay }
}
