import Foundation
import TestSupport
import Testing

@testable import GyradiusKit

/// Samples from several threads: none is lost, none is changed.
@Suite struct SensorsTests {
  private let folder: TemporaryFolder

  init() throws {
    folder = try TemporaryFolder()
  }

  /// A turn of 5 degrees with a period of 4 s, a phone's noise, and gravity on the accelerometer.
  private func swing(_ channel: Channel, seconds: Int, perBatch: Int) -> [Samples] {
    let omega = 2 * Double.pi / 4
    let values = (0..<100 * seconds).map { i in
      let turn = channel == .gyroscope ? 5 * Double.pi / 180 * omega * cos(omega * Double(i) / 100) : 9.81
      return (0..<3).map { axis in Double.random(in: -1e-3...1e-3) + (axis == 2 ? turn : 0) }
    }
    return stride(from: 0, to: values.count, by: perBatch).map { start in
      let rows = start..<min(start + perBatch, values.count)
      let stampsNs = rows.map { 10_000_000 * Int64($0) }
      return Samples(channel: channel, stampsNs: stampsNs, values: values[rows].flatMap { $0 })
    }
  }

  private func estimator() throws -> LiveEstimator {
    try LiveEstimator(wanted: 1e-3, gyroscopeFullScaleRadS: nil, accelerometerFullScaleMS2: nil)
  }

  @Test func theLiveEstimatorTakesBothSensorsFromThreadsOfTheirOwnWhileAThirdReads() async throws {
    let live = try estimator()
    let read = try await withThrowingTaskGroup(of: Int.self) { group in
      for channel in [Channel.gyroscope, .accelerometer] {
        let batches = swing(channel, seconds: 60, perBatch: 20)
        group.addTask {
          try await aside { try batches.forEach(live.push) }
          return 0
        }
      }
      group.addTask { try await aside { (0..<200).reduce(0) { sum, _ in sum + live.estimate().sensors.count } } }
      return try await group.reduce(0, +)
    }
    #expect(read == 400)
    #expect(live.estimate().sensors.map { $0.samples + $0.leftOut } == [6000, 6000])
    #expect(live.estimate().sensors.map(\.leftOut) == [0, 0])
  }

  @Test func estimatesStreamAndFindThePeriod() async throws {
    let (batches, sending) = AsyncStream.makeStream(of: Samples.self)
    swing(.gyroscope, seconds: 60, perBatch: 20).forEach { sending.yield($0) }
    sending.finish()
    var last: LiveEstimate?
    for try await estimate in try estimator().estimates(of: batches) { last = estimate }
    let swing = try #require(last?.swing)
    #expect(abs(swing.periodS - 4) < 5 * swing.periodUS)
    #expect(try abs(#require(swing.amplitudeDeg) - 5) < 0.1)
    let texts = try #require(last).advice.map { liveSentence(advice: $0) }
    #expect(texts.contains { $0.key == "live.sensor_absent" && $0.english.contains("accelerometer") })
  }

  @Test func aBatchThatIsRefusedEndsTheStreamWithItsError() async throws {
    let (batches, sending) = AsyncStream.makeStream(of: Samples.self)
    sending.yield(Samples(channel: .gyroscope, stampsNs: [0, 1], values: [0, 0, 0]))
    let error = try await thrown { for try await _ in try estimator().estimates(of: batches) {} }
    #expect(error.text.contains("as many values as stamps"))
  }

  @Test func halfAMegabyteOfStackIsEnoughForWhatComesWithEveryBatch() async throws {
    let live = try estimator()
    let both = [Channel.gyroscope, .accelerometer].flatMap { swing($0, seconds: 60, perBatch: 20) }
    let batches = both.sorted { $0.stampsNs[0] < $1.stampsNs[0] }
    try await withCheckedThrowingContinuation { continuation in
      let small = Thread { continuation.resume(with: Result { try batches.forEach(live.push) }) }
      // As much as iOS gives the threads of an app.
      small.stackSize = 512 << 10
      small.start()
    }
    #expect(try abs(#require(live.estimate().swing).periodS - 4) < 0.01)
  }

  private let header = RecorderHeader(
    phone: "phone",
    sensors: [RecorderSensor(stream: .gyroscope, name: "LSM6DSO", fullScale: 17.45)],
    notes: [NamedText(name: "operator", text: "A")]
  )

  @Test func aRecorderThatThreeThreadsPushToLosesNothingAndKeepsEveryBit() async throws {
    let streams = Channel.all.map { swing($0, seconds: 30, perBatch: 7) }
    let writer = try RecorderWriter.create(path: folder.path("take.gyr"), header: header)
    try await withThrowingTaskGroup(of: Void.self) { group in
      for batches in streams {
        group.addTask { try await aside { for batch in batches { try writer.push(batch) } } }
      }
      try await group.waitForAll()
    }
    _ = try writer.mark(mark: RecorderMark(stampNs: 29_000_000_000, key: "release"))
    _ = try writer.end(stampNs: 30_000_000_000)
    guard case .BadArgument = try await thrown({ try writer.flush() }) else {
      Issue.record("a recording that has ended took something")
      return
    }
    let file = try RecorderFile.read(path: folder.path("take.gyr"))
    #expect(file.header() == header)
    #expect(file.damage() == [])
    #expect(file.marks().map(\.key) == ["release", "end"])
    #expect(file.samples().map(\.channel) == Channel.all)
    for (pushed, track) in zip(streams, file.samples()) {
      #expect(track.stampsNs == pushed.flatMap(\.stampsNs))
      #expect(bits(track.values) == bits(pushed.flatMap(\.values)))
    }
  }

  @Test func aRecordingThatWasCutOffSaysSoGoesOnAndBecomesATable() throws {
    let path = folder.path("cut.gyr")
    let batches = swing(.gyroscope, seconds: 4, perBatch: 50)
    var writer = try RecorderWriter.create(path: path, header: header)
    for batch in batches.prefix(4) { try writer.push(batch) }
    _ = try writer.flush()
    try (Data(contentsOf: URL(filePath: path)) + [1, 2, 3]).write(to: URL(filePath: path))
    #expect(try RecorderFile.read(path: path).damage().map(\.kind) == [.cutTail])
    writer = try RecorderWriter.resume(path: path)
    for batch in batches.dropFirst(4) { try writer.push(batch) }
    _ = try writer.end(stampNs: 4_000_000_000)
    let file = try RecorderFile.read(path: path)
    #expect(file.samples().map(\.stampsNs.count) == [400])
    #expect(file.damage().map(\.kind) == [.resumed])
    #expect(try convertRecorderFile(file: path, folder: folder.url.path, name: "cut") == file.damage().map(\.text))
    let table = try String(contentsOfFile: folder.path("cut.csv"), encoding: .utf8)
    #expect(table.split(separator: "\n").count == 401)
  }

  @Test func coreMotionIsTurnedIntoForcesAndStamps() async throws {
    // At rest, screen up, iOS gives -1 g along z; standard gravity is 9.80665 m/s² by definition.
    let forces = try forcesFromCoreMotion(accelerationsG: Data(block: [0, 0, -1, 0.5, -0.25, 0])).doubles
    #expect(forces == [0, 0, 9.80665, -4.903325, 2.4516625, 0])
    let stamps = try stampsFromCoreMotion(timestampsS: Data(block: [0, 0.01, 345_678.123456789])).stamps
    #expect(stamps == [0, 10_000_000, 345_678_123_456_789])
    let wrong = try await thrown { try stampsFromCoreMotion(timestampsS: Data(block: [Double.nan])) }
    #expect(wrong.text.contains("since the phone was switched on"))
  }

  @Test func blocksReadBackToTheSameBitsWhereverTheyLie() {
    let numbers = [0.1, -0.0, .nan, .leastNormalMagnitude, 1e300, -.infinity]
    #expect(bits(Data(block: numbers).doubles) == bits(numbers))
    #expect(bits((Data([7]) + Data(block: numbers)).dropFirst().doubles) == bits(numbers))
    #expect(Data(block: [Int64.min, -1, .max]).stamps == [.min, -1, .max])
    // 1.0 is 3ff0000000000000 (IEEE 754), its lowest byte first.
    #expect(Array(Data(block: [1.0])) == [0, 0, 0, 0, 0, 0, 0xf0, 0x3f])
  }
}
