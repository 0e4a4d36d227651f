import Foundation
import TestSupport
import Testing

@testable import GyradiusKit

/// Typed results beside their JSON: what an app shows.
@Suite struct ResultsTests {
  private let folder: TemporaryFolder

  init() throws {
    folder = try TemporaryFolder()
  }

  /// Measured once for all tests.
  private static let boatPark = Task {
    try await Session.load(Shared.session("boat-park")).measure(limits: ["k_yaw_m>=1.000"])
  }

  @Test func aMeasurementAsRecords() async throws {
    let result = try await Self.boatPark.value.result()
    #expect(result.format == "gyradius-measurement/1")
    #expect(result.swings.map(\.id) == ["yaw-sway", "surge-pitch", "roll", "bow-up", "bow-down"])
    let yaw = try #require(result.quantity("k_yaw_m"))
    let (interval, value) = (try #require(yaw.interval95), try #require(yaw.value.number))
    #expect((interval.low...interval.high).contains(value))
    #expect(result.quantities.map(\.name) == result.quantities.map(\.name).sorted())
    guard case .matrix(let rows) = result.quantity("inertia_kg_m2")?.value,
      case .vector(let principal) = result.quantity("principal_gyradii_m")?.value
    else {
      Issue.record("inertia is a matrix, its principal gyradii are a vector")
      return
    }
    #expect(rows.map(\.count) == [3, 3, 3] && principal.count == 3)
    #expect(result.verdicts.map(\.quantity) == ["k_yaw_m"])
    #expect(result.budget.first { $0.name == "k_yaw_m" }?.lines.allSatisfy { $0.uContribution >= 0 } == true)
    #expect(result.swings.last?.modes.first?.mode == .yaw)
  }

  @Test func picturesComeThinned() async throws {
    let analysis = try await Self.boatPark.value
    let recordings = analysis.recordings(language: .english)
    #expect(recordings.count == 5)
    for trace in recordings.flatMap(\.traces) {
      // A pause in the record adds a point to the 1200 of the core.
      #expect((100...1300).contains(trace.measured.x.count), "\(trace.label)")
      #expect(trace.measured.x.count == trace.measured.y.count)
    }
    #expect(recordings.allSatisfy { $0.spectrum?.amplitude.x.isEmpty == false })
    let figures = analysis.figures(criticism: nil, language: .english)
    #expect(figures.allSatisfy { $0.svg.hasPrefix("<svg") && !$0.title.isEmpty })
    let html = try await analysis.reportHtml(measuredOn: "4 May 2026")
    #expect(html.hasPrefix("<!DOCTYPE html>") && html.contains("4 May 2026"))
    let german = try await analysis.reportHtml(language: .german)
    #expect(german.contains("<html lang=\"de\">") && german.contains("Trägheitsradius Gieren"))
  }

  @Test func aCriticismThatWasKeptHeadsTheReport() async throws {
    let kept = root.appending(path: "core/crates/report/tests/it/report/critiques/ambiguous.json")
    let criticism = try Criticism.fromJson(text: String(contentsOf: kept, encoding: .utf8))
    #expect(criticism.result().verdict.status == "ambiguous")
    #expect(try #require(criticism.result().verdict.nextSwing).lineLengthM > 0)
    let analysis = try await Session.load(Shared.session("keelboat")).measure()
    #expect(try await analysis.reportHtml(criticism: criticism).contains("gyradius-critique"))
    #expect(try await !analysis.reportHtml().contains("gyradius-critique"))
  }

  @Test func aPlanTellsWhatToDo() async throws {
    let hull = RoughHull(massKg: 622, lengthM: 6.35, beamM: 1.73, boatType: try #require(boatTypes().first))
    let plan = try await Plan.make(.usual(hull: hull, wanted: ["k_yaw=0.5%"])).result()
    let swing = try #require(plan.steps.lazy.compactMap(\.swing).first)
    #expect(try #require(swing.suspension.lineLengthM).value <= plan.means.mostLineLengthM)
    #expect(try #require(plan.predicted.first?.periodsS[.yaw]) > 0)
    let yaw = try #require(plan.quantities.first { $0.name == "k_yaw_m" }).quantity
    let wantedU = try #require(yaw.wantedU)
    #expect(abs(wantedU - 0.005 * yaw.value) < 1e-12)
    #expect(try yaw.isReached == (#require(yaw.u) <= wantedU))
    let hung = try #require(plan.suspensions.first).message
    #expect(sentenceIn(sentence: hung, language: .german).hasPrefix("Waagerecht, zwei Leinen von "))
  }

  @Test func oscillationsOfAnyRecord() throws {
    // Period 2 s, no decay, the amplitude 1 beside rounding to 1e-3.
    let times = (0..<3000).map { 0.02 * Double($0) }
    let found = try Decomposition.of(atS: times, channels: [times.map { (1000 * cos(.pi * $0)).rounded() / 1000 }])
    let mode = try #require(found.oscillations().first)
    #expect(abs(mode.periodS - 2) < 1e-4)
    #expect(abs(mode.alphaPerS) < 1e-3)
    let again = try found.evaluate(atS: [2, 3])
    #expect(again.map(\.count) == [2])
    #expect(abs(again[0][0] - 1) < 0.01 && abs(again[0][1] + 1) < 0.01)
  }

  @Test func aSessionThatWasNeverSwung() async throws {
    let (session, truth) = (folder.url.appending(path: "session"), folder.path("truth.json"))
    try Shared.rig().write(folder: session.path, truthFile: truth, seed: 7, overwrite: .refuse)
    #expect(try String(contentsOfFile: truth, encoding: .utf8).contains("gyradius-truth/1"))
    let loaded = try await Session.load(session)
    #expect(try loaded.swingIds() == Shared.rig().swingIds())
    #expect(loaded.statedToml()?.contains("line_length") == true)
  }

  @Test func aResultIsToldInGerman() async throws {
    let result = try await Self.boatPark.value.result()
    let claim = try #require(result.consistency.first { $0.claim == "line_length" })
    #expect(claim.message.english == sentenceIn(sentence: claim.message, language: .english))
    #expect(sentenceIn(sentence: claim.message, language: .german).hasPrefix("Leinenlänge: angegeben "))
    #expect(result.warnings.map(\.english) == result.warnings.map { sentenceIn(sentence: $0, language: .english) })
    #expect(inputIn(label: "spacing", language: .german) == "Abstand der Leinen")
  }

  @Test func everyTextHasAKeyOfItsOwn() {
    let texts = GyradiusKit.texts(language: .english)
    #expect(texts.map(\.name) == GyradiusKit.texts(language: .german).map(\.name))
    #expect(Set(texts.map(\.name)).count == texts.count)
    #expect(texts.allSatisfy { !$0.name.isEmpty && !$0.text.isEmpty })
    #expect(
      ["", "live-", "plan-", "inertia-", "critique-"].allSatisfy { room in texts.contains { $0.name.hasPrefix(room) } })
    #expect(libraryVersion() == "0.1.0")
  }
}
