import Foundation

/// Told the share that is done, 0 to 1, and what is being done; called on threads of the library. What it throws stops the
/// work, and is thrown when it has stopped.
public typealias OnProgress = @Sendable (_ share: Double, _ doing: String) throws -> Void

/// Long work as it goes.
public enum Working<Value: Sendable>: Sendable {
  /// It goes on: the share that is done, 0 to 1, and what is being done.
  case going(share: Double, doing: String)
  /// It is done, and this came of it.
  case done(Value)
}

/// Long work as a stream: `working { try await session.critique(onProgress: $0) }`. The work stops
/// when whoever reads is cancelled, or drops the stream.
public func working<Value>(
  _ work: @escaping @Sendable (@escaping OnProgress) async throws -> Value
) -> AsyncThrowingStream<Working<Value>, any Error> {
  AsyncThrowingStream { continuation in
    let task = Task {
      do {
        let value = try await work { share, doing in continuation.yield(.going(share: share, doing: doing)) }
        continuation.yield(.done(value))
        continuation.finish()
      } catch {
        continuation.finish(throwing: error)
      }
    }
    continuation.onTermination = { _ in task.cancel() }
  }
}

/// Runs blocking work of the library on a thread that may wait, not on one of Swift's own few. When the task is cancelled,
/// the work is told to stop, and a `CancellationError` is thrown once it has.
func watched<Value: Sendable>(
  _ onProgress: OnProgress?,
  _ work: @escaping @Sendable (any ProgressListener) throws -> Value
) async throws -> Value {
  let watch = Watch(onProgress)
  return try await withTaskCancellationHandler {
    try await aside { try watch.outcome(of: work) }
  } onCancel: {
    watch.stop(CancellationError())
  }
}

/// Runs what keeps its thread (reading files, say) where that may be.
func aside<Value: Sendable>(_ work: @escaping @Sendable () throws -> Value) async throws -> Value {
  try await withCheckedThrowingContinuation { continuation in
    DispatchQueue.global(qos: .userInitiated).async {
      continuation.resume(with: Result(catching: work))
    }
  }
}

/// Watches one piece of work. `stopped` is set from any thread and read from the work's: a lock stands before it.
private final class Watch: ProgressListener, @unchecked Sendable {
  private let onProgress: OnProgress?
  private let lock = NSLock()
  private var stopped: (any Error)?

  init(_ onProgress: OnProgress?) {
    self.onProgress = onProgress
  }

  /// The first reason to stop is the one that is thrown.
  func stop(_ reason: any Error) {
    lock.withLock { stopped = stopped ?? reason }
  }

  func onProgress(share: Double, doing: String) -> Bool {
    guard reason == nil else { return false }
    do {
      try onProgress?(share, doing)
    } catch {
      stop(error)
    }
    return reason == nil
  }

  func outcome<Value>(of work: (any ProgressListener) throws -> Value) throws -> Value {
    do {
      return try work(self)
    } catch GyradiusError.Cancelled(let text) {
      throw reason ?? GyradiusError.Cancelled(text: text)
    }
  }

  private var reason: (any Error)? { lock.withLock { stopped } }
}
