import GyradiusKit

/// What an operator is told who does not look at the phone.
public enum Cue: String, CaseIterable, Sendable {
  case releaseNow, recording, touched, good, `repeat`, done

  /// So long the hull is held before it is let go, s: the procedure's own words.
  private static let quietS = 3.0

  /// Which cue a change of state deserves, if any.
  public static func of(_ before: ProcedureState, _ now: ProcedureState) -> Cue? {
    if now.phase == .record { return ofRecording(before, now) }
    if now.phase == before.phase { return before.rest?.found == nil && now.rest?.found != nil ? .good : nil }
    switch now.phase {
    case .judge: return now.judgement?.recommend == .repeat ? .repeat : .good
    case .done: return .done
    default: return nil
    }
  }

  private static func ofRecording(_ before: ProcedureState, _ now: ProcedureState) -> Cue? {
    if now.touches > before.touches { return .touched }
    if now.isSwinging { return before.isSwinging ? nil : .recording }
    guard now.step?.planned.swing != nil else { return before.phase == .record ? nil : .recording }
    return now.isToBeReleased && !before.isToBeReleased ? .releaseNow : nil
  }

  fileprivate static func isQuiet(for seconds: Double) -> Bool { seconds >= quietS }
}

extension ProcedureState {
  fileprivate var isSwinging: Bool { phase == .record && recording?.swingingS != nil }

  fileprivate var isToBeReleased: Bool { phase == .record && Cue.isQuiet(for: recording?.recordedS ?? 0) }

  fileprivate var touches: Int {
    let advice = recording?.live?.advice ?? []
    return advice.count { if case .touched = $0 { true } else { false } }
  }
}
