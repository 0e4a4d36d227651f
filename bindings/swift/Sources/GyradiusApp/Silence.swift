import GyradiusKit

/// Which streams have fallen silent.
struct Silence: Sendable {
  /// Looks in vain, of a tenth of a second each, after which a stream is silent: seen before a second is over.
  private static let looks = 8
  /// Longer than a system holds samples back.
  private static let mostBehindNs: Int64 = 800_000_000

  private var lookedInVain: [Channel: Int]
  private var lastNs: [Channel: Int64] = [:]
  private var behind: Set<Channel> = []

  init(of channels: [Channel]) {
    lookedInVain = Dictionary(uniqueKeysWithValues: channels.map { ($0, 0) })
  }

  /// Streams that have given nothing for a while. Looks are counted, not time: while the phone gave the app no time at all, none
  /// was made.
  var silent: Set<Channel> { behind.union(lookedInVain.filter { $0.value >= Self.looks }.keys) }

  /// Takes what one look found; returns the streams that another's stamps have just left behind. Only that is certain: where
  /// nothing comes at all, the app itself may have been held up.
  mutating func look(_ found: [Samples]) -> Set<Channel> {
    for batch in found { lastNs[batch.channel] = batch.stampsNs.last }
    let heard = Set(found.map(\.channel))
    lookedInVain = lookedInVain.reduce(into: [:]) { $0[$1.key] = heard.contains($1.key) ? 0 : $1.value + 1 }
    let before = behind
    guard let newestNs = lastNs.values.max() else { return [] }
    behind = Set(lookedInVain.keys.filter { newestNs - (lastNs[$0] ?? newestNs) > Self.mostBehindNs })
    return behind.subtracting(before)
  }
}
