import GyradiusApp
import GyradiusKit

/// A sentence of the library as the screen shows it.
func spoken(_ sentence: Sentence) -> String {
  asShown(sentenceIn(sentence: sentence, language: libraryLanguage))
}

/// A warning of the plan.
func spoken(_ warning: PlanWarning) -> String {
  asShown(warningIn(warning: warning, language: libraryLanguage))
}

/// The language of the app's own words, so that a screen never mixes two.
var libraryLanguage: Language { Words.libraryLanguage == "GERMAN" ? .german : .english }

/// What went wrong.
func spoken(_ failure: Failure) -> String {
  switch failure {
  case .diskFull: Words.diskFull
  case .told(let text): text
  }
}

/// A quantity by the library's name for it, in words.
func quantityName(_ name: String) -> String { quantityIn(name: name, language: libraryLanguage) }

/// A step or a swing by its id, in words where the library has them.
func idName(_ id: String) -> String { idIn(id: id, language: libraryLanguage) }

/// An input of a budget by its label, in words.
func inputName(_ label: String) -> String { inputIn(label: label, language: libraryLanguage) }

/// A single route to a quantity, in words.
func routeName(_ method: String) -> String { routeIn(method: method, language: libraryLanguage) }

/// A cause of what the simulation gets wrong, in words.
func causeName(_ id: String) -> String { causeIn(id: id, language: libraryLanguage) }

/// A figure with its uncertainty and its unit, as a sentence's end.
func figure(_ name: String, _ value: Double, _ u: Double) -> String {
  let shown = withUncertainty(value, u)
  return withUnit(Words.quantityU(shown.value, shown.u, unitOf(name: name)))
}

/// A type of boat by the library's name for it; a name without a word stands as it is.
func boatTypeName(_ name: String) -> String {
  switch name {
  case "keelboat": Words.typeKeelboat
  case "dinghy": Words.typeDinghy
  case "model_keelboat": Words.typeModelKeelboat
  case "uniform_bar": Words.typeUniformBar
  default: name
  }
}

extension Excitation {
  /// What to set going.
  var word: String {
    switch self {
    case .yaw: Words.motionYaw
    case .sway: Words.motionSway
    case .surge: Words.motionSurge
    case .pitch: Words.motionPitch
    case .roll: Words.motionRoll
    }
  }

  /// How to set it going.
  var howTo: String {
    switch self {
    case .yaw: Words.howYaw
    case .sway: Words.howSway
    case .surge: Words.howSurge
    case .pitch: Words.howPitch
    case .roll: Words.howRoll
    }
  }
}

extension ModeName {
  var word: String {
    switch self {
    case .yaw: Words.modeYaw
    case .sway: Words.modeSway
    case .pitchInPhase: Words.modePitchInPhase
    case .pitchOutOfPhase: Words.modePitchOutOfPhase
    case .rollInPhase: Words.modeRollInPhase
    case .rollOutOfPhase: Words.modeRollOutOfPhase
    case .compound: Words.modeCompound
    case .other: Words.modeOther
    }
  }
}

extension Sensor {
  /// One of those that a recording listens to.
  var word: String { self == .gyroscope ? Words.gyroscope : Words.accelerometer }
}

extension SideMotionKind {
  var word: String {
    switch self {
    case .sway: Words.kindSway
    case .otherTurn: Words.kindOtherTurn
    case .sameTurn: Words.kindSameTurn
    }
  }
}

extension ProcedurePhase {
  var title: String {
    switch self {
    case .start: Words.phaseStart
    case .level: Words.phaseLevel
    case .rest: Words.phaseRest
    case .hang: Words.phaseHang
    case .ready: Words.phaseReady
    case .record: Words.phaseRecord
    case .interrupted: Words.phaseInterrupted
    case .judge: Words.phaseJudge
    case .measure: Words.phaseMeasure
    case .failed: Words.phaseFailed
    case .critique: Words.phaseCritique
    case .suggest: Words.phaseSuggest
    case .done: Words.phaseDone
    }
  }

  var help: String {
    switch self {
    case .start: Words.helpStart
    case .level: Words.helpLevel
    case .rest: Words.helpRest
    case .hang: Words.helpHang
    case .ready: Words.helpReady
    case .record: Words.helpRecord
    case .interrupted: Words.helpInterrupted
    case .judge: Words.helpJudge
    case .measure, .critique: Words.helpWork
    case .failed: Words.helpFailed
    case .suggest: Words.helpSuggest
    case .done: Words.helpResult
    }
  }
}
