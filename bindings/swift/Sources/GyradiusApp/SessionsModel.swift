import Foundation
import GyradiusKit
import Observation

/// The list of sessions and what can be done with them.
@MainActor @Observable
public final class SessionsModel {
  public private(set) var listed: [Listed] = []
  public private(set) var isPracticeLeft = false
  /// Taken off the list; its files are there until nobody can want them back.
  public private(set) var deleted: Listed?
  public private(set) var error: Failure?
  public let store: SessionStore

  public init(_ store: SessionStore) {
    self.store = store
  }

  /// Reads the folders anew.
  public func refresh() async {
    let store = store
    let (all, isLeft) = await Task.detached { (store.list(), store.isPracticeLeft) }.value
    listed = all.filter { $0.folder != deleted?.folder }
    isPracticeLeft = isLeft
  }

  /// Takes a session off the list. An earlier one that was taken off is removed for good.
  public func delete(_ session: Listed) {
    forget()
    deleted = session
    listed.removeAll { $0 == session }
  }

  /// Puts it back.
  public func undo() async {
    deleted = nil
    await refresh()
  }

  /// Nobody wanted it back: its files go.
  public func forget() {
    guard let gone = deleted else { return }
    deleted = nil
    attempt { try store.remove(gone.folder) }
  }

  /// Takes in a file that the operator chose.
  public func take(_ file: URL) async {
    let store = store
    error = nil
    do {
      _ = try await Task.detached { try store.take(file) }.value
    } catch {
      self.error = Failure(error)
    }
    await refresh()
  }

  /// A folder for a new session.
  public func create(title: String, limits: [String]) -> URL? {
    attempt { try store.create(title: title, limits: limits) }
  }

  /// The folder of a practice that begins.
  public func practiceAfresh() -> URL? {
    attempt { try store.practiceAfresh() }
  }

  @discardableResult
  private func attempt<Value>(_ what: () throws -> Value) -> Value? {
    error = nil
    do {
      return try what()
    } catch {
      self.error = Failure(error)
      return nil
    }
  }
}
