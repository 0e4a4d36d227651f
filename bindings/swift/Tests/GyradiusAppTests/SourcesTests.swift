import Foundation
import GyradiusKit
import TestSupport
import Testing

@testable import GyradiusApp

/// Where samples come from.
@Suite struct SourcesTests {
  @Test func whatCoreMotionGivesIsTurnedAsItIsTaken() throws {
    // At rest, screen up, iOS gives -1 g along z; standard gravity is 9.80665 m/s² by definition.
    let accelerometer = CoreMotionGatherer(.accelerometer)
    accelerometer.add(timestampS: 345_678.12, x: 0, y: 0.5, z: -1)
    accelerometer.add(timestampS: 345_678.13, x: 1, y: 0, z: 0)
    let forces = try #require(try accelerometer.take())
    #expect(forces.stampsNs == [345_678_120_000_000, 345_678_130_000_000])
    #expect(forces.values == [0, -4.903325, 9.80665, -9.80665, 0, 0])
    #expect(try accelerometer.take() == nil)
    let gyroscope = CoreMotionGatherer(.gyroscope)
    gyroscope.add(timestampS: 1, x: 0.25, y: -0.5, z: 1)
    #expect(try gyroscope.take()?.values == [0.25, -0.5, 1])
  }

  @Test func aReplayGivesTheRecordingOnceMoreInItsOwnTime() throws {
    let folder = try TemporaryFolder()
    let path = folder.url.appending(path: "take.gyr").path
    let writer = try RecorderWriter.create(path: path, header: RecorderHeader(phone: "phone", sensors: [], notes: []))
    let recorded = [Channel.gyroscope, .accelerometer].map { channel in
      let stampsNs = (0..<300).map { 5_000_000_000 + 10_000_000 * Int64($0) }
      return Samples(channel: channel, stampsNs: stampsNs, values: (0..<900).map { Double($0) / 8 })
    }
    for batch in recorded { try writer.push(batch) }
    _ = try writer.end(stampNs: 8_000_000_000)
    let source = PlayedSource.replay(try RecorderFile.read(path: path))
    #expect(source.sensors.map(\.channel) == [.gyroscope, .accelerometer])
    source.open()
    #expect(source.take() == [])
    source.letGoBy(seconds: 1)
    #expect(source.take().map(\.stampsNs.count) == [100, 100])
    source.letGoBy(seconds: 10)
    let rest = source.take()
    #expect(rest.map(\.stampsNs) == recorded.map { Array($0.stampsNs[100...]) })
    #expect(rest.map(\.values) == recorded.map { Array($0.values[300...]) })
    #expect(source.take() == [])
  }

  @MainActor @Test func theGyroscopeIsDrawnThinnedAndOnlyItsLastSeconds() {
    let recorder = RecorderModel()
    let stampsNs = (0..<2000).map { 10_000_000 * Int64($0) }
    recorder.draw(Samples(channel: .gyroscope, stampsNs: stampsNs, values: (0..<6000).map { Double($0 % 3) }))
    #expect(recorder.trace.count == 300)
    #expect(recorder.trace.allSatisfy { $0.rateRadS == [0, 1, 2] })
    #expect(recorder.trace.last?.atS == 19.96)
  }
}
