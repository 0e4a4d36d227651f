import Foundation
import GyradiusKit
import Observation

/// A session that was measured: its result and its report.
@MainActor @Observable
public final class ResultModel {
  public private(set) var title = ""
  /// Class limits that it is judged by.
  public private(set) var limits: [String] = []
  /// What was measured; its verdicts are those after the criticism, where one was made.
  public var result: InertiaResult? {
    guard let found = criticism.found, let analysis else { return measured }
    return analysis.judged(criticism: found)
  }
  private var measured: InertiaResult?
  public private(set) var recordings: [RecordingFigureData] = []
  /// How much of the measurement is done, 0 to 1; absent while nothing is done.
  public private(set) var share: Double?
  public private(set) var error: Failure?
  /// What the simulation gets wrong.
  public let criticism = CriticismModel()
  private var opened: Measurable?
  private var session: Session?
  private var analysis: Analysis?
  private var language = Language.english

  public init() {}

  /// Reads a session, measures it, and takes the criticism that was kept; channels have names in a language.
  public func open(_ found: Measurable, in language: Language = .english) async {
    (opened, title, limits) = (found, found.title, found.limits)
    (session, analysis, measured, recordings) = (nil, nil, nil, [])
    self.language = language
    await work {
      let session = try await Session.load(found.session)
      self.session = session
      criticism.begin(with: session, in: found.folder)
      try await measure(found.limits)
    }
  }

  /// Measures again, with verdicts on other limits, which are kept.
  public func judge(by limits: [String], keepingIn store: SessionStore) async {
    await work {
      try await measure(limits)
      if let opened { try store.keep(limits: limits, in: opened.folder) }
      self.limits = limits
    }
  }

  /// Writes the report in a language into a folder, with the criticism where there is one.
  public func report(into folder: URL, in language: Language = .english) async -> URL? {
    let file = folder.appending(path: "report.html")
    var written: URL?
    await work {
      guard let analysis else { return }
      let html = try await analysis.reportHtml(criticism: criticism.found, language: language)
      try html.write(to: file, atomically: true, encoding: .utf8)
      written = file
    }
    return written
  }

  private func measure(_ limits: [String]) async throws {
    guard let session else { return }
    let found = try await session.measure(limits: limits) { share, _ in
      Task { @MainActor in if self.share != nil { self.share = share } }
    }
    analysis = found
    (measured, recordings) = (found.result(), found.recordings(language: language))
  }

  private func work(_ what: () async throws -> Void) async {
    (share, error) = (0, nil)
    do {
      try await what()
    } catch is CancellationError {
    } catch {
      self.error = Failure(error)
    }
    share = nil
  }
}

/// What the simulation of a session gets wrong, why, and what mending it gains.
@MainActor @Observable
public final class CriticismModel {
  public private(set) var critique: Critique?
  /// Measured against simulated, by swing.
  public private(set) var compared: [ComparedSwing] = []
  public private(set) var share: Double?
  public private(set) var error: Failure?
  private(set) var found: Criticism?
  private var session: Session?
  /// Where it is kept.
  private var folder: URL?

  public init() {}

  /// Looks for what is missing: minutes. It stops with its task.
  public func criticise() async {
    guard let session else { return }
    (share, error) = (0, nil)
    do {
      let made = try await session.critique { share, _ in
        Task { @MainActor in if self.share != nil { self.share = share } }
      }
      show(made)
      if let folder { try made.keep(folder: folder.path) }
    } catch is CancellationError {
    } catch {
      self.error = Failure(error)
    }
    share = nil
  }

  func begin(with session: Session, in folder: URL) {
    (self.session, self.folder) = (session, folder)
    (critique, compared, found, error) = (nil, [], nil, nil)
    do {
      if let kept = try keptCriticism(folder: folder.path) { show(kept) }
    } catch {
      self.error = Failure(error)
    }
  }

  private func show(_ criticism: Criticism) {
    found = criticism
    (critique, compared) = (criticism.result(), criticism.compared())
  }
}
