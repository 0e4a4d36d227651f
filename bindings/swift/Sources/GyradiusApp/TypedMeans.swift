import GyradiusKit

/// What is at hand in the boat park, as it stands in its fields.
public struct TypedMeans: Equatable, Sendable {
  public var mostLineLengthM: Double?
  public var leastLineLengthM: Double?
  public var mostSpacingM: Double?
  public var leastSpacingM: Double?
  public var uLineLengthM: Double?
  public var uSpacingM: Double?
  public var uHullPitchDeg: Double?
  public var gravityMS2: TypedQuantity
  public var gyroNoiseRadS: Double?
  public var accNoiseMS2: Double?
  public var rateHz: Double?
  public var decayS: Double?
  public var amplitudeDeg: Double?
  public var leastDurationS: Double?
  public var mostDurationS: Double?

  public init(_ means: Means) {
    (mostLineLengthM, leastLineLengthM) = (means.mostLineLengthM, means.leastLineLengthM)
    (mostSpacingM, leastSpacingM) = (means.mostSpacingM, means.leastSpacingM)
    (uLineLengthM, uSpacingM, uHullPitchDeg) = (means.uLineLengthM, means.uSpacingM, means.uHullPitchDeg)
    gravityMS2 = TypedQuantity(means.gravityMS2)
    (gyroNoiseRadS, accNoiseMS2, rateHz) = (means.gyroNoiseRadS, means.accNoiseMS2, means.rateHz)
    (decayS, amplitudeDeg) = (means.decayS, means.amplitudeDeg)
    (leastDurationS, mostDurationS) = (means.leastDurationS, means.mostDurationS)
  }

  /// As the planner takes it; a field that is empty keeps what is usual.
  func means(else usual: Means) -> Means {
    Means(
      mostLineLengthM: mostLineLengthM ?? usual.mostLineLengthM,
      leastLineLengthM: leastLineLengthM ?? usual.leastLineLengthM,
      mostSpacingM: mostSpacingM ?? usual.mostSpacingM,
      leastSpacingM: leastSpacingM ?? usual.leastSpacingM,
      uLineLengthM: uLineLengthM ?? usual.uLineLengthM,
      uSpacingM: uSpacingM ?? usual.uSpacingM,
      uHullPitchDeg: uHullPitchDeg ?? usual.uHullPitchDeg,
      gravityMS2: gravityMS2.quantity ?? usual.gravityMS2,
      gyroNoiseRadS: gyroNoiseRadS ?? usual.gyroNoiseRadS,
      accNoiseMS2: accNoiseMS2 ?? usual.accNoiseMS2,
      rateHz: rateHz ?? usual.rateHz,
      decayS: decayS ?? usual.decayS,
      amplitudeDeg: amplitudeDeg ?? usual.amplitudeDeg,
      leastDurationS: leastDurationS ?? usual.leastDurationS,
      mostDurationS: mostDurationS ?? usual.mostDurationS
    )
  }
}
