import Charts
import GyradiusApp
import GyradiusKit
import SwiftUI

/// The three rates over the last seconds.
struct TracePlot: View {
  let points: [RecorderModel.Point]

  var body: some View {
    Chart {
      ForEach(Array(["x", "y", "z"].enumerated()), id: \.offset) { axis, name in
        ForEach(points) { point in
          LineMark(
            x: .value("s", point.atS), y: .value("rad/s", point.rateRadS[axis]), series: .value("", name)
          )
          .foregroundStyle(by: .value("", Words.rateAbout(name)))
        }
      }
    }
    .chartYScale(domain: -topRadS...topRadS)
    .frame(height: 180)
    .accessibilityLabel(Words.trace)
  }

  /// Noise at rest must not fill the plot.
  private var topRadS: Double { points.flatMap(\.rateRadS).map(abs).reduce(0.02, max) }
}

/// Curves over time: all of them, or the seconds that are scrolled to.
struct CurvePlot: View {
  /// A curve with its name in the legend.
  struct Drawn: Identifiable {
    let name: String
    let curve: Curve
    var isThin = false
    var id: String { name }
  }

  let says: String
  let unit: String
  let drawn: [Drawn]
  /// So much is shown at once, s; everything, where it is absent.
  var windowS: Double?

  var body: some View {
    if let windowS, windowS < spanS {
      chart.chartScrollableAxes(.horizontal).chartXVisibleDomain(length: windowS)
    } else {
      chart
    }
  }

  private var spanS: Double {
    guard let curve = drawn.first?.curve, let first = curve.x.first, let last = curve.x.last else { return 0 }
    return last - first
  }

  private var chart: some View {
    Chart {
      ForEach(drawn) { one in
        ForEach(Array(zip(one.curve.x, one.curve.y).enumerated()), id: \.offset) { _, point in
          LineMark(x: .value("s", point.0), y: .value(unit, point.1), series: .value("", one.name))
            .foregroundStyle(by: .value("", one.name))
            .lineStyle(StrokeStyle(lineWidth: one.isThin ? 1.5 : 3))
        }
      }
    }
    .chartXAxisLabel("s")
    .chartYAxisLabel(unit)
    .frame(height: 200)
    .accessibilityLabel(says)
  }
}
