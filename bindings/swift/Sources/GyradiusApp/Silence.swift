import GyradiusKit

/// Which streams have fallen silent.
struct Silence: Sendable {
  /// Looks in vain, of a tenth of a second each, after which a stream is silent: seen before a second is over.
  private static let looks = 8
  /// Of the same, after which they have stopped where nothing comes at all: three seconds.
  private static let looksOfAll = 30
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

  /// Takes what one look found; returns the streams that have certainly stopped: left behind by another's stamps, or all of
  /// them, where so many looks found nothing that the app cannot just have been held up.
  mutating func look(_ found: [Samples]) -> Set<Channel> {
    for batch in found { lastNs[batch.channel] = batch.stampsNs.last }
    let heard = Set(found.map(\.channel))
    lookedInVain = lookedInVain.reduce(into: [:]) { $0[$1.key] = heard.contains($1.key) ? 0 : $1.value + 1 }
    if lookedInVain.values.allSatisfy({ $0 >= Self.looksOfAll }) { return Set(lookedInVain.keys) }
    guard let newestNs = lastNs.values.max() else { return [] }
    behind = Set(lookedInVain.keys.filter { newestNs - (lastNs[$0] ?? newestNs) > Self.mostBehindNs })
    return behind
  }
}
