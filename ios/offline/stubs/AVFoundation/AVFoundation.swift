// STUB: what the app uses of Apple's AVFoundation, as we read its documentation. It checks names and types, and does nothing.
import Foundation

open class AVAudioSession: @unchecked Sendable {
  public struct Category: Sendable {
    public static let playback = Category()
  }
  public struct CategoryOptions: OptionSet, Sendable {
    public let rawValue: UInt
    public init(rawValue: UInt) { self.rawValue = rawValue }
    public static let duckOthers = CategoryOptions(rawValue: 2)
  }
  open class func sharedInstance() -> AVAudioSession { fatalError() }
  open func setCategory(_ category: Category, options: CategoryOptions = []) throws {}
}

open class AVSpeechSynthesisVoice {
  public init?(language languageCode: String?) {}
}

open class AVSpeechUtterance {
  public init(string: String) {}
  open var voice: AVSpeechSynthesisVoice?
}

public enum AVSpeechBoundary: Int, Sendable { case immediate, word }

open class AVSpeechSynthesizer {
  public init() {}
  open func speak(_ utterance: AVSpeechUtterance) {}
  @discardableResult open func stopSpeaking(at boundary: AVSpeechBoundary) -> Bool { false }
}
