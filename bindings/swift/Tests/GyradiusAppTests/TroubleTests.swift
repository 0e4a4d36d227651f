import Foundation
import GyradiusKit
import Testing

@testable import GyradiusApp

/// What goes wrong in the middle of a recording, and what is left of it.
@MainActor @Suite struct TroubleTests {
  @Test func anAppThatIsSentToTheBackgroundLosesOnlyThatTimeAndSaysSo() async throws {
    let park = try Park()
    try await park.record()
    try await park.rest(seconds: 10)
    await park.model.pauseLooking()
    // On the disk before the app is held: what iOS then does to it costs nothing more.
    #expect(try park.recorded(.gyroscope) >= 950)
    #expect(try park.state.phase == .record)
    park.source.letGoBy(seconds: 8)
    try await park.rest(seconds: 10)
    await park.model.handle(.stopRecording)
    let judgement = try #require(park.state.judgement)
    #expect(judgement.recommend == .repeat)
    #expect(judgement.reasons.contains { $0.key == "reason_gaps" }, "\(judgement.reasons.map(\.key))")
    #expect(try park.recorded(.gyroscope) == 2000)
    #expect(try park.recorded(.accelerometer) == 2000)
    #expect(judgement.gaps.listed.map(\.sensor) == [.gyroscope, .accelerometer])
    let times = judgement.gaps.listed.map { ($0.fromS, $0.lengthS) }
    #expect(times.allSatisfy { abs($0 - 10) < 0.02 && abs($1 - 8) < 0.02 }, "\(times)")
  }

  @Test func aLockOfTheScreenLosesOnlyItsTimeAndTheModelThenLooksAgain() async throws {
    let park = try await Self.recordingByItself(seconds: 30)
    try await park.waits(untilRecordedS: 10)
    await park.model.follow(.inactive)
    await park.model.follow(.background)
    let beforeS = try #require(park.state.recording).recordedS
    // On the disk before the app is held, but for the half second that the recorder gathers.
    #expect(try Double(park.recorded(.gyroscope)) >= Double(Park.rateHz) * (beforeS - 0.51))
    try await Task.sleep(for: .milliseconds(300))
    #expect(try #require(park.state.recording).recordedS == beforeS)
    park.isHeldBack(seconds: 8)
    await park.model.follow(.inactive)
    await park.model.follow(.active)
    try await park.waits(untilRecordedS: 29.9)
    await park.model.handle(.stopRecording)
    let judgement = try #require(park.state.judgement)
    #expect(judgement.gaps.listed.map(\.sensor) == [.gyroscope, .accelerometer])
    #expect(judgement.gaps.listed.allSatisfy { abs($0.fromS - beforeS) < 0.02 && abs($0.lengthS - 8) < 0.02 })
    for channel in [Channel.gyroscope, .accelerometer] {
      let recorded = try park.recorded(channel)
      #expect(abs(recorded - 22 * Park.rateHz) <= 1)
    }
    #expect(try !park.take().marks().contains { $0.key.hasPrefix("sensor stopped") })
  }

  @Test func aCallThatIsNotTakenLosesNoSample() async throws {
    // Its banner makes the app inactive; refused, the app is active again.
    let park = try await Self.recordingByItself(seconds: 30)
    try await park.waits(untilRecordedS: 10)
    await park.model.follow(.inactive)
    try await park.waits(untilRecordedS: 20)
    await park.model.follow(.active)
    try await park.waits(untilRecordedS: 29.9)
    await park.model.handle(.stopRecording)
    #expect(try #require(park.state.judgement).gaps == GapList(listed: [], more: 0))
    for channel in [Channel.gyroscope, .accelerometer] {
      let recorded = try park.recorded(channel)
      #expect(recorded == 30 * Park.rateHz)
    }
  }

  @Test func aCallThatIsTakenCostsItsTimeAndNoMore() async throws {
    let park = try await Self.recordingByItself(seconds: 30)
    try await park.waits(untilRecordedS: 10)
    await park.model.follow(.inactive)
    try await park.waits(untilRecordedS: 14)
    await park.model.follow(.background)
    park.isHeldBack(seconds: 5)
    await park.model.follow(.active)
    try await park.waits(untilRecordedS: 29.9)
    await park.model.handle(.stopRecording)
    let lengths = try #require(park.state.judgement).gaps.listed.map(\.lengthS)
    #expect(lengths.count == 2 && lengths.allSatisfy { abs($0 - 5) < 0.02 }, "\(lengths)")
    for channel in [Channel.gyroscope, .accelerometer] {
      let recorded = try park.recorded(channel)
      #expect(abs(recorded - 25 * Park.rateHz) <= 1)
    }
  }

  /// A recording that the model brings in by its own looking, two seconds at a time, while the hull hangs still.
  private static func recordingByItself(seconds: Double) async throws -> Park {
    let park = try Park()
    try await park.record()
    try park.hangsStill(seconds: seconds)
    park.model.pace = 20
    await park.model.follow(.active)
    return park
  }

  @Test func aPauseThatTakesNoSampleAwayLosesNone() async throws {
    // A banner of a call: the app is inactive for a moment, and iOS goes on giving samples.
    let park = try Park()
    try await park.record()
    park.model.goOnLooking()
    await park.model.pauseLooking()
    try await park.rest(seconds: 10)
    await park.model.handle(.stopRecording)
    let reasons = try #require(park.state.judgement).reasons.map(\.key)
    #expect(!reasons.contains("reason_gaps"))
    #expect(try park.recorded(.gyroscope) == 1000)
  }

  @Test func anAppThatIsKilledInARecordingGoesOnWithIt() async throws {
    let park = try Park()
    try await park.record()
    try await park.rest(seconds: 10)
    // The disk as it is at that moment; what the app then does in closing is undone.
    let asKilled = park.folder.appendingPathExtension("killed")
    try FileManager.default.copyItem(at: park.folder, to: asKilled)
    await park.model.leave()
    #expect(!park.model.isListening)
    try FileManager.default.removeItem(at: park.folder)
    try FileManager.default.moveItem(at: asKilled, to: park.folder)
    await park.model.goOn(in: park.folder, source: park.source)
    #expect(try park.state.phase == .interrupted)
    await park.model.handle(.continue)
    try await park.rest(seconds: 5)
    await park.model.handle(.stopRecording)
    #expect(try park.state.phase == .judge)
    // Never more than half a second behind.
    #expect(try (1450...1500).contains(park.recorded(.gyroscope)))
    #expect(try park.take().damage().map(\.kind) == [.resumed])
  }

  @Test func aSensorThatStopsIsShownAndTheRecordingKnows() async throws {
    let park = try Park()
    try await park.record()
    try await park.rest(seconds: 5)
    #expect(park.model.recorder.silent == [])
    park.source.mute([.gyroscope])
    try await park.rest(seconds: 3)
    #expect(park.model.recorder.silent == [.gyroscope])
    park.source.mute([])
    try await park.rest(seconds: 2)
    #expect(park.model.recorder.silent == [])
    await park.model.handle(.stopRecording)
    #expect(try park.take().marks().map(\.key).contains("sensor stopped gyroscope"))
    #expect(try park.state.judgement?.recommend == .repeat)
    #expect(try park.recorded(.gyroscope) == 700)
    #expect(try park.recorded(.accelerometer) == 1000)
  }

  @Test func sensorsThatAllStopAreShown() async throws {
    let park = try Park()
    try await park.begin()
    park.source.mute([.gyroscope, .accelerometer])
    try await park.goOn(seconds: 1)
    #expect(park.model.recorder.silent == [.gyroscope, .accelerometer])
  }

  @Test func sensorsThatAllStopForGoodStandInTheRecording() async throws {
    let park = try Park()
    try await park.record()
    try await park.rest(seconds: 5)
    park.source.mute([.gyroscope, .accelerometer])
    try await park.goOn(seconds: 2)
    #expect(try !park.take().marks().map(\.key).contains("sensor stopped gyroscope"))
    try await park.goOn(seconds: 3)
    let told = try park.take().marks().map(\.key).filter { $0.hasPrefix("sensor stopped") }
    #expect(told.sorted() == ["sensor stopped accelerometer", "sensor stopped gyroscope"])
    // The app ends, and they never came back.
    await park.model.leave()
    await park.model.goOn(in: park.folder, source: park.source)
    await park.model.handle(.keep)
    let reasons = try #require(park.state.judgement).reasons.map(\.key)
    #expect(reasons.filter { $0 == "reason_silent" }.count == 2)
  }

  /// A disk of a few megabytes that is the test's alone; `tools/swift` mounts it.
  nonisolated private static let smallDisk = ProcessInfo.processInfo.environment["GYRADIUS_SMALL_DISK"]

  @Test(.enabled(if: smallDisk != nil, "it needs a small disk of its own"))
  func aFullDiskIsToldWhatWasRecordedStaysAndItGoesOnWhenThereIsRoom() async throws {
    let disk = URL(filePath: try #require(Self.smallDisk))
    let park = try Park(on: disk)
    try await park.record()
    try await park.rest(seconds: 10)
    let filler = disk.appending(path: "filler")
    try fill(filler)
    try await park.rest(seconds: 10)
    // Told once, and what to do.
    #expect(try park.state.phase == .interrupted)
    #expect(try park.state.warnings.map(\.key).filter { $0 != "warn_no_rest" } == ["warn_disk"])
    #expect(park.model.error == nil)
    // Nothing else begins there.
    let late = try Park(on: disk)
    try await late.open()
    #expect(late.model.error == .diskFull)
    try FileManager.default.removeItem(at: filler)
    await park.model.handle(.continue)
    #expect(try park.state.phase == .record)
    try await park.rest(seconds: 10)
    await park.model.handle(.stopRecording)
    #expect(try park.state.phase == .judge)
    // Those before the disk was full, and those after.
    #expect(try (1950...2600).contains(park.recorded(.gyroscope)))
    await park.model.leave()
    try FileManager.default.removeItem(at: park.folder)
  }

  private func fill(_ file: URL) throws {
    #expect(FileManager.default.createFile(atPath: file.path, contents: nil))
    let handle = try FileHandle(forWritingTo: file)
    for size in [1 << 16, 1 << 10] {
      while (try? handle.write(contentsOf: Data(count: size))) != nil {}
    }
    try handle.close()
  }
}
