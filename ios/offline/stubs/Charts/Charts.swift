// STUB: what the app uses of Apple's Charts, as we read its documentation. It checks names and types, and does nothing.
import SwiftUI

public protocol Plottable {}
extension Double: Plottable {}
extension Int: Plottable {}
extension String: Plottable {}

public struct PlottableValue<Value: Plottable> {
  public static func value<S: StringProtocol>(_ label: S, _ value: Value) -> PlottableValue<Value> { fatalError() }
}

@MainActor @preconcurrency public protocol ChartContent {
  associatedtype Body: ChartContent
  @ChartContentBuilder var body: Body { get }
}
extension Never: ChartContent {}

@resultBuilder public struct ChartContentBuilder {
  public static func buildExpression<Content: ChartContent>(_ content: Content) -> Content { content }
  public static func buildBlock<Content: ChartContent>(_ content: Content) -> Content { content }
}

extension ForEach: ChartContent where Content: ChartContent {
  public var body: Never { fatalError() }
  public init(
    _ data: Data, @ChartContentBuilder content: @escaping (Data.Element) -> Content
  ) where Data.Element: Identifiable, ID == Data.Element.ID { fatalError() }
  public init(
    _ data: Data, id: KeyPath<Data.Element, ID>, @ChartContentBuilder content: @escaping (Data.Element) -> Content
  ) { fatalError() }
}

public struct LineMark: ChartContent {
  public init<X: Plottable, Y: Plottable, S: Plottable>(
    x: PlottableValue<X>, y: PlottableValue<Y>, series: PlottableValue<S>
  ) {}
  public var body: Never { fatalError() }
}

extension ChartContent {
  public func foregroundStyle<D: Plottable>(by value: PlottableValue<D>) -> some ChartContent { self }
  public func lineStyle(_ style: StrokeStyle) -> some ChartContent { self }
}

public struct Chart<Content: ChartContent>: View {
  public init(@ChartContentBuilder content: () -> Content) {}
  public var body: Never { fatalError() }
}

extension View {
  public func chartYScale<R>(domain: ClosedRange<R>) -> some View where R: Plottable & Comparable { self }
  public func chartXAxisLabel<S: StringProtocol>(_ label: S) -> some View { self }
  public func chartYAxisLabel<S: StringProtocol>(_ label: S) -> some View { self }
  public func chartScrollableAxes(_ axes: Axis.Set) -> some View { self }
  public func chartXVisibleDomain<P: Plottable & Numeric>(length: P) -> some View { self }
}
