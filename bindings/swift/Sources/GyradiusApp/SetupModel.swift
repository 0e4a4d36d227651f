import Foundation
import GyradiusKit
import Observation

/// A number with its uncertainty as it is typed in.
public struct TypedQuantity: Equatable, Sendable {
  public var value: Double?
  public var u: Double?

  public init(value: Double? = nil, u: Double? = nil) {
    (self.value, self.u) = (value, u)
  }

  public init(_ quantity: Quantity) {
    self.init(value: quantity.value, u: quantity.u)
  }

  /// The quantity, where both are there.
  public var quantity: Quantity? {
    guard let value, let u, u >= 0 else { return nil }
    return Quantity(value: value, u: u)
  }
}

extension [String: TypedQuantity] {
  /// What stands in the fields of a name: nothing, before anybody types.
  public subscript(typed name: String) -> TypedQuantity {
    get { self[name] ?? TypedQuantity() }
    set { self[name] = newValue }
  }
}

/// A class limit as it is typed in.
public struct TypedLimit: Identifiable, Equatable, Sendable {
  public let id: UUID
  /// `k_yaw_m` …
  public var quantity: String
  public var isLeast = true
  public var value: Double?

  public init(quantity: String) {
    id = UUID()
    self.quantity = quantity
  }

  /// What `text` has written; anything else is no limit that has fields.
  public init?(_ text: String) {
    let isLeast = text.contains(Self.least)
    let parts = text.components(separatedBy: isLeast ? Self.least : Self.most)
    guard parts.count == 2, SetupModel.knowable.contains(parts[0]), let value = Double(parts[1]) else { return nil }
    id = UUID()
    (quantity, self.isLeast, self.value) = (parts[0], isLeast, value)
  }

  private static let least = ">="
  private static let most = "<="

  /// As the library reads it, where there is a number.
  public var text: String? { value.map { "\(quantity)\(isLeast ? Self.least : Self.most)\($0)" } }
}

/// A boat that is known roughly becomes a plan.
@MainActor @Observable
public final class SetupModel {
  public var title = ""
  public var massKg: Double?
  public var lengthM: Double?
  public var beamM: Double?
  public var boatType: String
  public var known: [String: TypedQuantity] = [:]
  /// What is at hand, as the library has it at first.
  public var means = TypedMeans(usualMeans())
  /// Wanted uncertainties by quantity, in the unit of `wantedUnits`.
  public var wanted: [String: Double] = [:]
  public var limits: [TypedLimit] = []
  public private(set) var isPlanning = false
  public private(set) var plan: PlanResult?
  public private(set) var task: ProcedureTask?
  public private(set) var error: Failure?

  /// What may be known more closely, as the library names it.
  public nonisolated static let knowable = ["k_yaw_m", "k_pitch_m", "k_roll_m", "cm_depth_m", "psi_deg"]
  /// Quantities whose uncertainty can be wished for, and the unit of the wish.
  public static let wantedUnits = [
    ("k_yaw", "%"), ("k_pitch", "%"), ("k_roll", "%"), ("depth", "%"), ("psi", "°"),
  ]

  /// Class limits are offered as they were used last.
  public init(usualLimits: [String] = []) {
    boatType = boatTypes().first ?? ""
    limits = usualLimits.compactMap(TypedLimit.init(_:))
  }

  /// Asks the planner: seconds.
  public func makePlan() async {
    (isPlanning, plan, task, error) = (true, nil, nil, nil)
    defer { isPlanning = false }
    do {
      let made = try await Plan.make(request)
      (plan, task) = (made.result(), made.task())
    } catch {
      self.error = Failure(error)
    }
  }

  /// Class limits as the library reads them.
  public var limitTexts: [String] { limits.compactMap(\.text) }

  /// What is asked of the planner; where a field is empty, it keeps the library's default.
  public var request: PlanRequest {
    let usual = usualPlanRequest()
    let asked = Self.wantedUnits.compactMap { name, unit in wanted[name].map { "\(name)=\($0)\(unit)" } }
    return PlanRequest(
      title: title, hull: hull, wanted: asked.isEmpty ? usual.wanted : asked, means: means.means(else: usual.means)
    )
  }

  private var hull: RoughHull {
    RoughHull(
      massKg: massKg,
      lengthM: lengthM,
      beamM: beamM,
      boatType: boatType,
      kYawM: known["k_yaw_m"]?.quantity,
      kPitchM: known["k_pitch_m"]?.quantity,
      kRollM: known["k_roll_m"]?.quantity,
      cmDepthM: known["cm_depth_m"]?.quantity,
      psiDeg: known["psi_deg"]?.quantity
    )
  }
}
