import Foundation
import TestSupport
import Testing

@testable import GyradiusKit

/// The vectors of `tests/vectors`, as every language runs them; and every output against Python's, bit by bit.
@Suite struct VectorsTests {
  @Test func everyFileIsKnownAndWhole() throws {
    let routes = try JSONDecoder().decode([Named].self, from: Shared.bytes("routes.json"))
    #expect(Set(routes.map(\.name)) == Set(VectorFile.all.keys))
    #expect(try routesJson() == Shared.text("routes.json"))
    for (name, file) in VectorFile.all {
      #expect(file.algorithm == name)
      #expect(file.tests.count == file.numberOfTests, "\(name)")
    }
    #expect(Set(Case.all.map(\.vector.id)).count == Case.all.count)
    #expect(Case.all.count > 200)
    #expect(Set(pythons.keys) == Set(Case.all.map(\.vector.id)))
  }

  @Test(arguments: Case.all)
  func vector(_ one: Case) async throws {
    if one.vector.result == "valid" { try holds(one) } else { try await isRefused(one) }
  }

  private func holds(_ one: Case) throws {
    let found = try evaluateRoute(name: one.algorithm, inputs: one.vector.inputs)
    for (name, text) in try #require(one.vector.expected) {
      let expected = try #require(Double(text))
      let tolerance = try #require(one.vector.tolerance?[name])
      let value = try #require(found[name])
      // Written so that a NaN fails.
      let allowed = (tolerance.abs ?? 0) + (tolerance.rel ?? 0) * abs(expected)
      #expect(abs(value - expected) <= allowed, "\(name)")
    }
  }

  private func isRefused(_ one: Case) async throws {
    let error = try await thrown { try evaluateRoute(name: one.algorithm, inputs: one.vector.inputs) }
    switch (one.vector.error, error) {
    case ("argument", .BadArgument), ("no_result", .NoResult): break
    default: Issue.record("refused with \(error), not as \(one.vector.error ?? "nothing")")
    }
  }

  /// Two faces of one core: the same bits, or the same sentence that refuses.
  @Test(arguments: Case.all)
  func bitsOfPython(_ one: Case) async throws {
    let python = try #require(pythons[one.vector.id])
    guard let outputs = python.outputs else {
      let error = try await thrown { try evaluateRoute(name: one.algorithm, inputs: one.vector.inputs) }
      #expect(error.text == python.text)
      return
    }
    let found = try evaluateRoute(name: one.algorithm, inputs: one.vector.inputs)
    #expect(try found.mapValues(\.bitPattern) == outputs.mapValues { try #require(UInt64($0, radix: 16)) })
  }
}

private let pythons = try! JSONDecoder().decode([String: PythonOutcome].self, from: Shared.bytes("vectors.json"))

private struct Named: Decodable {
  let name: String
}

private struct PythonOutcome: Decodable {
  let outputs: [String: String]?
  let text: String?
}

/// A file of vectors.
private struct VectorFile: Decodable {
  let algorithm: String
  let numberOfTests: Int
  let tests: [Vector]

  enum CodingKeys: String, CodingKey {
    case algorithm, tests
    case numberOfTests = "number_of_tests"
  }

  static let all: [String: VectorFile] = {
    let folder = root.appending(path: "tests/vectors")
    let files = try! names(in: folder).filter { $0.hasSuffix(".json") && $0 != "schema.json" }
    let read = files.map { file in
      let bytes = try! Data(contentsOf: folder.appending(path: file))
      return (String(file.dropLast(".json".count)), try! JSONDecoder().decode(VectorFile.self, from: bytes))
    }
    return Dictionary(uniqueKeysWithValues: read)
  }()
}

struct Vector: Decodable {
  let id: String
  let inputs: [String: Double]
  let result: String
  let error: String?
  let expected: [String: String]?
  let tolerance: [String: Tolerance]?
}

struct Tolerance: Decodable {
  let rel: Double?
  let abs: Double?
}

/// A vector and the route that it is of.
struct Case: CustomTestStringConvertible {
  let algorithm: String
  let vector: Vector

  var testDescription: String { vector.id }

  static let all = VectorFile.all.sorted { $0.key < $1.key }.flatMap { name, file in
    file.tests.map { Case(algorithm: name, vector: $0) }
  }
}
