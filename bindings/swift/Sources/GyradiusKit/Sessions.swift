import Foundation

extension Session {
  /// Reads a session folder, a session's zip or a bare recording; `mapping` names the columns of a foreign CSV.
  public static func load(_ url: URL, mapping: [String] = []) async throws -> Session {
    try await aside { try load(path: url.path, mapping: mapping) }
  }

  /// Modes, inertia, uncertainty and consistency; each of the `limits` (`k_pitch_m>=1.100`) gets a verdict.
  public func measure(limits: [String] = [], onProgress: OnProgress? = nil) async throws -> Analysis {
    try await watched(onProgress) { try self.measureBlocking(limits: limits, listener: $0) }
  }

  /// What the simulation gets wrong, why, and what mending it gains: minutes.
  public func critique(onProgress: OnProgress? = nil) async throws -> Criticism {
    try await watched(onProgress) { try self.critiqueBlocking(listener: $0) }
  }

  /// The plan from what was measured so far.
  public func plan(request: PlanRequest = usualPlanRequest(), onProgress: OnProgress? = nil) async throws -> Plan {
    try await watched(onProgress) { try self.planBlocking(request: request, listener: $0) }
  }

  /// The plan of the swing that tells two causes of the criticism apart: minutes.
  public func planToTellApart(
    _ one: String,
    from other: String,
    request: PlanRequest = usualPlanRequest(),
    onProgress: OnProgress? = nil
  ) async throws -> Plan {
    try await watched(onProgress) {
      try self.planToTellApartBlocking(one: one, other: other, request: request, listener: $0)
    }
  }
}

extension Plan {
  /// The plan for a hull of which rough figures are known.
  public static func make(_ request: PlanRequest, onProgress: OnProgress? = nil) async throws -> Plan {
    try await watched(onProgress) { try makeBlocking(request: request, listener: $0) }
  }
}

extension Analysis {
  /// The report: one self-contained HTML file in a language.
  public func reportHtml(
    criticism: Criticism? = nil,
    measuredOn: String? = nil,
    language: Language = .english,
    onProgress: OnProgress? = nil
  ) async throws -> String {
    try await watched(onProgress) {
      try self.reportHtmlBlocking(criticism: criticism, measuredOn: measuredOn, language: language, listener: $0)
    }
  }
}

extension InertiaResult {
  /// A quantity of the result, e.g. `k_yaw_m`.
  public func quantity(_ name: String) -> QuantityResult? {
    quantities.first { $0.name == name }?.quantity
  }
}

extension QuantityValue {
  /// The number, where the quantity is one.
  public var number: Double? {
    if case .scalar(let value) = self { value } else { nil }
  }
}

extension PlanStep {
  /// The swing of a step that is one.
  public var swing: PlannedSwing? {
    if case .swing(let swing) = self { swing } else { nil }
  }

  /// The incline of a step that is one.
  public var incline: PlannedIncline? {
    if case .incline(let incline) = self { incline } else { nil }
  }
}
