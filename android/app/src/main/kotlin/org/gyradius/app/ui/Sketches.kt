package org.gyradius.app.ui

import androidx.annotation.StringRes
import androidx.compose.foundation.Canvas
import androidx.compose.foundation.layout.aspectRatio
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.widthIn
import androidx.compose.material3.MaterialTheme
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Matrix
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.PathEffect
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.StrokeJoin
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.role
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.drawText
import androidx.compose.ui.text.rememberTextMeasurer
import androidx.compose.ui.unit.dp
import kotlin.math.atan2
import kotlin.math.cos
import kotlin.math.sin

/** Draws in units of its width: x from 0 to 1 to the right, y from 0 downwards; layout, no science. */
class Pen(private val scope: DrawScope, val ink: Color, val accent: Color, val ground: Color, private val texts: TextMeasurer) {
    private val unit = scope.size.width
    private val thin = with(scope) { 2.dp.toPx() }

    private fun at(x: Float, y: Float) = Offset(x * unit, y * unit)

    /** A straight line. */
    fun line(x1: Float, y1: Float, x2: Float, y2: Float, colour: Color = ink, isDashed: Boolean = false) {
        val dashes = if (isDashed) PathEffect.dashPathEffect(floatArrayOf(4 * thin, 3 * thin)) else null
        scope.drawLine(colour, at(x1, y1), at(x2, y2), thin, StrokeCap.Round, dashes)
    }

    /** A smooth or straight outline, filled with the ground's colour. */
    fun shape(colour: Color = ink, fill: Color? = ground, isClosed: Boolean = true, draw: Path.() -> Unit) {
        val path = Path().apply(draw).apply { if (isClosed) close() }
        path.transform(Matrix().apply { scale(unit, unit) })
        fill?.let { scope.drawPath(path, it) }
        scope.drawPath(path, colour, style = Stroke(thin, cap = StrokeCap.Round, join = StrokeJoin.Round))
    }

    /** A dot: a knot, a suspension point. */
    fun dot(x: Float, y: Float, colour: Color = accent, radius: Float = 0.012f) =
        scope.drawCircle(colour, radius * unit, at(x, y))

    /** A dimension from end to end, with heads at both. */
    fun measure(x1: Float, y1: Float, x2: Float, y2: Float) {
        line(x1, y1, x2, y2, accent)
        head(x1, y1, atan2(y1 - y2, x1 - x2))
        head(x2, y2, atan2(y2 - y1, x2 - x1))
    }

    /** An arrow. */
    fun arrow(x1: Float, y1: Float, x2: Float, y2: Float) {
        line(x1, y1, x2, y2, accent)
        head(x2, y2, atan2(y2 - y1, x2 - x1))
    }

    /** The head of an arrow that points along an angle, rad. */
    fun head(x: Float, y: Float, along: Float) = shape(accent, accent) {
        moveTo(x, y)
        for (side in listOf(2.7f, -2.7f)) lineTo(x + HEAD * cos(along + side), y + HEAD * sin(along + side))
    }

    /** Words around a point, on the ground's colour so that no line runs through them; whole within the picture. */
    fun words(x: Float, y: Float, text: String, style: TextStyle, colour: Color = accent) {
        val laid = texts.measure(text, style.copy(color = colour))
        val room = (unit - laid.size.width).coerceAtLeast(0f)
        val left = (x * unit - laid.size.width / 2f).coerceIn(0f, room)
        val top = y * unit - laid.size.height / 2f
        val size = Size(laid.size.width.toFloat(), laid.size.height.toFloat())
        scope.drawRect(ground, Offset(left, top), size)
        scope.drawText(laid, topLeft = Offset(left, top))
    }

    private companion object {
        const val HEAD = 0.035f
    }
}

/** A sketch as high as [heights] of its width, which a screen reader describes in words. */
@Composable
fun Sketch(@StringRes says: Int, heights: Float, modifier: Modifier = Modifier, draw: Pen.() -> Unit) {
    val description = stringResource(says)
    val scheme = MaterialTheme.colorScheme
    val texts = rememberTextMeasurer()
    val look = modifier.widthIn(max = 480.dp).fillMaxWidth().aspectRatio(1 / heights)
    Canvas(look.semantics { contentDescription = description; role = Role.Image }) {
        Pen(this, scheme.onSurface, scheme.primary, scheme.surface, texts).draw()
    }
}

/** A hull from the side, bow to the right, its deck at [y]. */
internal fun Pen.hullFromTheSide(y: Float) = shape {
    moveTo(0.08f, y)
    lineTo(0.94f, y - 0.015f)
    quadraticTo(0.88f, y + 0.11f, 0.68f, y + 0.13f)
    lineTo(0.24f, y + 0.12f)
    quadraticTo(0.11f, y + 0.1f, 0.08f, y)
}

/** A hull from ahead, its deck at [y]. */
internal fun Pen.hullFromAhead(y: Float) = shape {
    moveTo(0.2f, y)
    lineTo(0.8f, y)
    quadraticTo(0.78f, y + 0.18f, 0.5f, y + 0.22f)
    quadraticTo(0.22f, y + 0.18f, 0.2f, y)
}

/** A hull from above, bow upwards, from [top] to [bottom]. */
internal fun Pen.hullFromAbove(top: Float, bottom: Float, halfBeam: Float = 0.16f) = shape {
    val middle = top + 0.55f * (bottom - top)
    moveTo(0.5f, top)
    cubicTo(0.5f + 0.7f * halfBeam, top + 0.1f, 0.5f + halfBeam, middle - 0.1f, 0.5f + halfBeam, middle)
    quadraticTo(0.5f + halfBeam, bottom - 0.1f, 0.5f + 0.7f * halfBeam, bottom)
    lineTo(0.5f - 0.7f * halfBeam, bottom)
    quadraticTo(0.5f - halfBeam, bottom - 0.1f, 0.5f - halfBeam, middle)
    cubicTo(0.5f - halfBeam, middle - 0.1f, 0.5f - 0.7f * halfBeam, top + 0.1f, 0.5f, top)
}
