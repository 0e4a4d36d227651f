package org.gyradius.app.ui

import androidx.annotation.StringRes
import androidx.compose.foundation.Canvas
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.background
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Slider
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableFloatStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.drawscope.clipRect
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import kotlin.math.abs
import org.gyradius.Curve
import org.gyradius.app.R

/** A curve with its name in the legend; [isThin] for what lies over another. */
class Drawn(@StringRes val name: Int, val curve: Curve, val isThin: Boolean = false)

/** Curves over time, s, on one scale: all of it, or the seconds that the slider points at. */
@Composable
fun CurvePlot(@StringRes says: Int, drawn: List<Drawn>, unit: String, windowS: Double? = null) {
    val scheme = MaterialTheme.colorScheme
    val colours = listOf(scheme.onSurface, scheme.error, scheme.primary)
    val firstS = drawn.first().curve.x.firstOrNull() ?: return
    val spanS = drawn.first().curve.x.last() - firstS
    var from by remember { mutableFloatStateOf(0f) }
    val shownS = windowS?.coerceAtMost(spanS) ?: spanS
    val fromS = firstS + from * (spanS - shownS)
    val description = stringResource(says)
    val top = drawn.maxOf { one -> one.curve.y.filter { it.isFinite() }.maxOfOrNull { abs(it) } ?: 0.0 }
    Canvas(Modifier.fillMaxWidth().height(180.dp).semantics { contentDescription = description }) {
        drawLine(scheme.outlineVariant, Offset(0f, size.height / 2), Offset(size.width, size.height / 2))
        clipRect {
            drawn.zip(colours).forEach { (one, colour) -> curve(one, colour, Frame(fromS, shownS, top, size)) }
        }
    }
    PlotScale(top, unit, fromS, fromS + shownS)
    Legend(drawn.map { stringResource(it.name) }.zip(colours))
    if (shownS < spanS) {
        val label = stringResource(R.string.plot_from)
        Slider(from, { from = it }, Modifier.semantics { contentDescription = label })
    }
}

/** How high and how wide a plot is. */
@Composable
internal fun PlotScale(top: Double, unit: String, fromS: Double, toS: Double) =
    Text(stringResource(R.string.plot_scale, top, unit, fromS, toS), style = MaterialTheme.typography.bodyMedium)

/** What part of the plane a picture shows. */
private class Frame(val fromS: Double, val spanS: Double, val top: Double, val size: Size) {
    fun at(xS: Double, y: Double) = Offset(
        ((xS - fromS) / spanS * size.width).toFloat(),
        (size.height / 2 * (1 - 0.95 * y / top)).toFloat(),
    )
}

/** A value that is not a number breaks the line. */
private fun DrawScope.curve(one: Drawn, colour: Color, frame: Frame) {
    val path = Path()
    var isDown = false
    for ((x, y) in one.curve.x.zip(one.curve.y)) {
        val at = frame.at(x, y)
        if (y.isFinite() && isDown) path.lineTo(at.x, at.y) else if (y.isFinite()) path.moveTo(at.x, at.y)
        isDown = y.isFinite()
    }
    drawPath(path, colour, style = Stroke((if (one.isThin) 1.5.dp else 3.dp).toPx()))
}

/** Which colour is which curve. */
@Composable
fun Legend(entries: List<Pair<String, Color>>) {
    FlowRow(horizontalArrangement = Arrangement.spacedBy(16.dp)) {
        for ((name, colour) in entries) {
            Row(verticalAlignment = Alignment.CenterVertically, horizontalArrangement = Arrangement.spacedBy(6.dp)) {
                Box(Modifier.size(20.dp, 4.dp).background(colour))
                Text(name, style = MaterialTheme.typography.bodyMedium)
            }
        }
    }
}
