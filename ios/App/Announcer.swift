import AVFoundation
import GyradiusApp
import UIKit

/// The phone's voice and taps.
@MainActor
final class Announcer {
  private let voice = AVSpeechSynthesizer()
  private let taps = UINotificationFeedbackGenerator()

  /// Says a cue, and drops what it was still saying: only the newest counts.
  func say(_ cue: Cue) {
    // Heard with the ringer switched off too: the operator stands some metres away.
    try? AVAudioSession.sharedInstance().setCategory(.playback, options: .duckOthers)
    voice.stopSpeaking(at: .immediate)
    let utterance = AVSpeechUtterance(string: words(of: cue))
    utterance.voice = AVSpeechSynthesisVoice(language: Bundle.main.preferredLocalizations.first)
    voice.speak(utterance)
  }

  /// Lets a cue be felt. While the phone records it is taped to the hull and must not shake it: then nothing is felt.
  func tap(_ cue: Cue) {
    switch cue {
    case .releaseNow, .recording, .touched: return
    case .good, .done: taps.notificationOccurred(.success)
    case .repeat: taps.notificationOccurred(.warning)
    }
  }

  private func words(of cue: Cue) -> String {
    switch cue {
    case .releaseNow: Words.cueRelease
    case .recording: Words.cueRecording
    case .touched: Words.cueTouched
    case .good: Words.cueGood
    case .repeat: Words.cueRepeat
    case .done: Words.cueDone
    }
  }
}
