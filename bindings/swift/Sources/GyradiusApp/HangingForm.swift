import GyradiusKit

/// What a step wants measured of the hanging hull, as it stands in its fields.
public struct HangingForm: Equatable, Sendable {
  /// What can be measured; the name says the unit.
  public enum Dimension: Sendable {
    case lineLengthM, spacingM, topSpacingM, hullPitchDeg, pointsMovedM, axisHeightM, massKg, armM, depthM
  }

  /// One dimension, and what is typed in of it.
  public struct Entry: Identifiable, Equatable, Sendable {
    public let id: Dimension
    public var typed: TypedQuantity
  }

  public var entries: [Entry]

  /// What is planned stands in the fields; of an incline the plan has no uncertainties.
  public init(_ step: StepView) {
    entries = step.planned.incline.map(Self.inclined) ?? step.hanging.map(Self.hung) ?? []
  }

  /// What was measured, once every field is filled.
  public var measured: MeasuredDimensions? {
    let read = entries.compactMap { entry in entry.typed.quantity.map { (entry.id, $0) } }
    return read.count == entries.count ? Self.dimensions(Dictionary(uniqueKeysWithValues: read)) : nil
  }

  private static func inclined(_ incline: PlannedIncline) -> [Entry] {
    let planned: [(Dimension, Double)] = [(.massKg, incline.massKg), (.armM, incline.armM), (.depthM, incline.depthM)]
    return planned.map { Entry(id: $0, typed: TypedQuantity(value: $1)) }
  }

  private static func hung(_ hanging: Suspension) -> [Entry] {
    let planned: [(Dimension, Quantity?)] = [
      (.lineLengthM, hanging.lineLengthM), (.spacingM, hanging.spacingM), (.topSpacingM, hanging.topSpacingM),
      (.hullPitchDeg, hanging.hullPitchDeg), (.pointsMovedM, hanging.pointsMovedM),
      (.axisHeightM, hanging.axisHeightM),
    ]
    return planned.compactMap { dimension, quantity in
      quantity.map { Entry(id: dimension, typed: TypedQuantity($0)) }
    }
  }

  private static func dimensions(_ read: [Dimension: Quantity]) -> MeasuredDimensions {
    MeasuredDimensions(
      lineLengthM: read[.lineLengthM],
      spacingM: read[.spacingM],
      topSpacingM: read[.topSpacingM],
      hullPitchDeg: read[.hullPitchDeg],
      pointsMovedM: read[.pointsMovedM],
      axisHeightM: read[.axisHeightM],
      massKg: read[.massKg],
      armM: read[.armM],
      depthM: read[.depthM]
    )
  }
}
