package org.gyradius.app.ui

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.material3.MaterialTheme
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import kotlin.math.abs
import kotlin.math.max
import org.gyradius.app.R
import org.gyradius.app.run.Trace

/** The three rates over the last seconds, on one scale. */
@Composable
fun TracePlot(points: List<Trace.Point>) {
    val label = stringResource(R.string.trace)
    val scheme = MaterialTheme.colorScheme
    val colours = listOf(scheme.error, scheme.tertiary, scheme.primary)
    val curves: List<(Trace.Point) -> Float> = listOf({ it.x }, { it.y }, { it.z })
    val top = points.maxOfOrNull { max(abs(it.x), max(abs(it.y), abs(it.z))) }?.coerceAtLeast(LEAST_TOP) ?: return
    Stack {
        Canvas(Modifier.fillMaxWidth().height(160.dp).semantics { contentDescription = label }) {
            drawLine(scheme.outline, Offset(0f, size.height / 2), Offset(size.width, size.height / 2))
            for ((curve, colour) in curves.zip(colours)) {
                drawPath(pathOf(points, curve, top, size), colour, style = Stroke(3.dp.toPx()))
            }
        }
        PlotScale(top.toDouble(), "rad/s", points.first().atS, points.last().atS)
        Legend(listOf("x", "y", "z").map { stringResource(R.string.rate_about, it) }.zip(colours))
    }
}

private fun pathOf(points: List<Trace.Point>, rate: (Trace.Point) -> Float, top: Float, size: Size) = Path().apply {
    val from = points.first().atS
    val span = max(points.last().atS - from, LEAST_SPAN_S)
    points.forEachIndexed { at, point ->
        val x = ((point.atS - from) / span * size.width).toFloat()
        val y = size.height / 2 * (1f - 0.95f * rate(point) / top)
        if (at == 0) moveTo(x, y) else lineTo(x, y)
    }
}

/** Noise at rest must not fill the plot, rad/s. */
private const val LEAST_TOP = 0.02f
private const val LEAST_SPAN_S = 2.0
