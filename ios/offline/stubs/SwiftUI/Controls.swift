// STUB: what the app uses of Apple's SwiftUI (controls and drawing), as we read its documentation. It checks names and types, and does nothing.
import CoreTransferable
import UIKit

public struct Text: Primitive {
  public init<S: StringProtocol>(_ content: S) {}
  public func font(_ font: Font?) -> Text { self }
  public func foregroundStyle<S: ShapeStyle>(_ style: S) -> Text { self }
  public func monospacedDigit() -> Text { self }
}
public struct Image: Primitive {
  public init(systemName: String) {}
}
public struct Label<Title: View, Icon: View>: Primitive {
  public init<S: StringProtocol>(_ title: S, systemImage name: String) where Title == Text, Icon == Image {}
}
public struct ButtonRole: Sendable {
  public static let destructive = ButtonRole()
}
public struct Button<Content: View>: Primitive {
  public init(action: @escaping @MainActor () -> Void, @ViewBuilder label: () -> Content) {}
  public init<S: StringProtocol>(_ title: S, action: @escaping @MainActor () -> Void) where Content == Text {}
  public init<S: StringProtocol>(
    _ title: S, role: ButtonRole?, action: @escaping @MainActor () -> Void
  ) where Content == Text {}
  public init<S: StringProtocol>(
    _ title: S, systemImage: String, action: @escaping @MainActor () -> Void
  ) where Content == Label<Text, Image> {}
}
public struct Toggle<Content: View>: Primitive {
  public init<S: StringProtocol>(_ title: S, isOn: Binding<Bool>) where Content == Text {}
}
public struct TextField<Content: View>: Primitive {
  public init<S: StringProtocol>(_ title: S, text: Binding<String>) where Content == Text {}
}
public struct Picker<Content: View, Selection: Hashable, Choices: View>: Primitive {
  public init<S: StringProtocol>(
    _ title: S, selection: Binding<Selection>, @ViewBuilder content: () -> Choices
  ) where Content == Text {}
}
public struct ProgressView<Content: View, Current: View>: Primitive {
  public init() where Content == EmptyView, Current == EmptyView {}
  public init<V: BinaryFloatingPoint>(value: V?, total: V = 1.0) where Content == EmptyView, Current == EmptyView {}
}
public struct LabeledContent<Content: View, Value: View>: Primitive {
  public init<S1: StringProtocol, S2: StringProtocol>(_ title: S1, value: S2) where Content == Text, Value == Text {}
  public init<S: StringProtocol>(_ title: S, @ViewBuilder content: () -> Value) where Content == Text {}
}
public struct SharePreview<Picture, Icon> {
  public init<S: StringProtocol>(_ title: S) where Picture == Never, Icon == Never {}
}
public struct ShareLink<Data, Picture, Icon, Content: View>: Primitive {
  public init<I: Transferable>(
    item: I, preview: SharePreview<Picture, Icon>, @ViewBuilder label: () -> Content
  ) where Data == CollectionOfOne<I> {}
}

public protocol ShapeStyle: Sendable {}
public struct Color: ShapeStyle, Primitive, Hashable {
  nonisolated public init(uiColor: UIColor) {}
  nonisolated public static let primary = Color(uiColor: .systemBackground)
  nonisolated public static let secondary = primary
  nonisolated public static let accentColor = primary
  nonisolated public static let red = primary
  nonisolated public static let orange = primary
  nonisolated public static let green = primary
  nonisolated public func opacity(_ opacity: Double) -> Color { self }
}
extension ShapeStyle where Self == Color {
  nonisolated public static var red: Color { Color.red }
  public static var green: Color { Color.green }
}
public struct HierarchicalShapeStyle: ShapeStyle {}
extension ShapeStyle where Self == HierarchicalShapeStyle {
  public static var secondary: HierarchicalShapeStyle { fatalError() }
}
public struct Material: ShapeStyle {}
extension ShapeStyle where Self == Material {
  public static var regularMaterial: Material { fatalError() }
}

public struct Font: Hashable, Sendable {
  public enum TextStyle: Sendable { case largeTitle, title, title2, title3, headline, subheadline, body, callout }
  public enum Weight: Sendable { case semibold, bold }
  public static let largeTitle = Font()
  public static let title2 = Font()
  public static let title3 = Font()
  public static let headline = Font()
  public static let subheadline = Font()
  public static let callout = Font()
  public static func system(size: CGFloat, weight: Weight? = nil) -> Font { Font() }
  public func weight(_ weight: Weight) -> Font { self }
}

public struct Angle: Sendable {
  public static func radians(_ radians: Double) -> Angle { Angle() }
  public static func degrees(_ degrees: Double) -> Angle { Angle() }
}
public struct CGAffineTransform: Sendable {
  public init(scaleX sx: CGFloat, y sy: CGFloat) {}
}
public enum CGLineCap: Int, Sendable { case butt, round, square }
public enum CGLineJoin: Int, Sendable { case miter, round, bevel }
public struct StrokeStyle: Sendable {
  public init(
    lineWidth: CGFloat = 1, lineCap: CGLineCap = .butt, lineJoin: CGLineJoin = .miter, miterLimit: CGFloat = 10,
    dash: [CGFloat] = [], dashPhase: CGFloat = 0
  ) {}
}
public struct Path: Sendable {
  public init(_ callback: (inout Path) -> Void) {}
  public init(_ rect: CGRect) {}
  public init(ellipseIn rect: CGRect) {}
  public mutating func move(to end: CGPoint) {}
  public mutating func addLine(to end: CGPoint) {}
  public mutating func addLines(_ lines: [CGPoint]) {}
  public mutating func addQuadCurve(to end: CGPoint, control: CGPoint) {}
  public mutating func addCurve(to end: CGPoint, control1: CGPoint, control2: CGPoint) {}
  public mutating func addEllipse(in rect: CGRect) {}
  public mutating func addArc(
    center: CGPoint, radius: CGFloat, startAngle: Angle, endAngle: Angle, clockwise: Bool
  ) {}
  public mutating func closeSubpath() {}
  public func applying(_ transform: CGAffineTransform) -> Path { self }
}

public protocol Shape: Primitive, Sendable {}
public struct Circle: Shape {
  public init() {}
}
public struct RoundedRectangle: Shape {
  public init(cornerRadius: CGFloat) {}
}
extension Shape {
  public func trim(from startFraction: CGFloat = 0, to endFraction: CGFloat = 1) -> some Shape { self }
  public func stroke<S: ShapeStyle>(_ content: S, lineWidth: CGFloat = 1) -> some View { self }
  public func stroke<S: ShapeStyle>(_ content: S, style: StrokeStyle) -> some View { self }
}

public struct GraphicsContext {
  public struct Shading {
    public static func color(_ color: Color) -> Shading { Shading() }
  }
  public struct ResolvedText {
    public func measure(in size: CGSize) -> CGSize { size }
  }
  public func resolve(_ text: Text) -> ResolvedText { ResolvedText() }
  public func fill(_ path: Path, with shading: Shading) {}
  public func stroke(_ path: Path, with shading: Shading, style: StrokeStyle) {}
  public func draw(_ text: ResolvedText, in rect: CGRect) {}
}
public struct Canvas<Symbols: View>: Primitive {
  public init(renderer: @escaping (inout GraphicsContext, CGSize) -> Void) where Symbols == EmptyView {}
}
