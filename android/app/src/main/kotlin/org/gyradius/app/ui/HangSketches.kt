package org.gyradius.app.ui

import androidx.compose.material3.MaterialTheme
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.text.TextStyle
import org.gyradius.Orientation
import org.gyradius.Placement
import org.gyradius.Suspension
import org.gyradius.SuspensionKind
import org.gyradius.app.R

/** What to measure of the way that a hull hangs. */
@Composable
fun SuspensionSketch(kind: SuspensionKind, orientation: Orientation, modifier: Modifier = Modifier) = when {
    kind == SuspensionKind.COMPOUND -> CompoundSketch(modifier)
    orientation == Orientation.FORE_AND_AFT -> ForeAndAftSketch(modifier)
    else -> AthwartshipsSketch(modifier)
}

/** The same of a suspension of the library. */
@Composable
fun SuspensionSketch(hung: Suspension, modifier: Modifier = Modifier) = SuspensionSketch(hung.kind, hung.orientation, modifier)

@Composable
private fun AthwartshipsSketch(modifier: Modifier) {
    val (length, spacing) = stringResource(R.string.sketch_length) to stringResource(R.string.sketch_spacing)
    val style = MaterialTheme.typography.labelLarge
    Sketch(R.string.sketch_athwartships, 0.82f, modifier) {
        beam(0.12f, 0.88f)
        hullFromAhead(0.56f)
        twoLines(0.3f, 0.7f, 0.07f, 0.56f)
        measure(0.88f, 0.08f, 0.88f, 0.55f)
        words(0.84f, 0.3f, length, style)
        measure(0.31f, 0.47f, 0.69f, 0.47f)
        words(0.5f, 0.41f, spacing, style)
    }
}

@Composable
private fun ForeAndAftSketch(modifier: Modifier) {
    val (length, spacing) = stringResource(R.string.sketch_length) to stringResource(R.string.sketch_spacing)
    val style = MaterialTheme.typography.labelLarge
    Sketch(R.string.sketch_fore_and_aft, 0.72f, modifier) {
        beam(0.06f, 0.94f)
        hullFromTheSide(0.56f)
        twoLines(0.25f, 0.72f, 0.07f, 0.555f)
        measure(0.9f, 0.08f, 0.9f, 0.53f)
        words(0.86f, 0.3f, length, style)
        measure(0.26f, 0.47f, 0.71f, 0.47f)
        words(0.485f, 0.41f, spacing, style)
    }
}

/** Two inverted Vs: the hull turns about the line through their tips. */
@Composable
private fun CompoundSketch(modifier: Modifier) {
    val (height, axis) = stringResource(R.string.sketch_axis_height) to stringResource(R.string.sketch_axis)
    val style = MaterialTheme.typography.labelLarge
    Sketch(R.string.sketch_compound, 0.75f, modifier) {
        hullFromTheSide(0.58f)
        line(0.5f, 0.12f, 0.28f, 0.575f)
        line(0.5f, 0.12f, 0.72f, 0.57f)
        listOf(0.28f, 0.72f).forEach { dot(it, 0.573f) }
        dot(0.5f, 0.12f, radius = 0.02f)
        line(0.5f, 0.12f, 0.9f, 0.12f, accent, isDashed = true)
        line(0.72f, 0.572f, 0.9f, 0.572f, accent, isDashed = true)
        measure(0.87f, 0.13f, 0.87f, 0.56f)
        words(0.8f, 0.34f, height, style)
        words(0.5f, 0.05f, axis, style)
    }
}

/** The square frame on the hull with its lettered points, bow upwards. */
@Composable
fun FrameSketch(points: String?, modifier: Modifier = Modifier) {
    val bow = stringResource(R.string.bow)
    val style = MaterialTheme.typography.titleMedium
    Sketch(R.string.sketch_frame, 1.05f, modifier) {
        hullFromAbove(0.1f, 0.98f, 0.2f)
        words(0.5f, 0.05f, bow, style, ink)
        shape(fill = null) { moveTo(0.26f, 0.32f); lineTo(0.74f, 0.32f); lineTo(0.74f, 0.8f); lineTo(0.26f, 0.8f) }
        val hung = points.orEmpty().split('-').filter { it.isNotEmpty() }
        val ends = FRAME.filter { it.letter in hung }
        if (ends.size == 2) line(ends[0].x, ends[0].y, ends[1].x, ends[1].y, accent, isDashed = true)
        for (one in FRAME) {
            dot(one.x, one.y, if (one in ends) accent else ink, if (one in ends) 0.022f else 0.012f)
            words(one.x + one.dx, one.y + one.dy, one.letter, style, if (one in ends) accent else ink)
        }
    }
}

/** How the phone lies, with its axes. */
@Composable
fun PlacementSketch(placement: Placement, modifier: Modifier = Modifier) {
    val bow = stringResource(R.string.bow)
    val style = MaterialTheme.typography.titleMedium
    val says = if (placement == Placement.FLAT_TOP_TO_BOW) R.string.sketch_flat else R.string.sketch_any_way
    Sketch(says, 0.95f, modifier) {
        hullFromAbove(0.1f, 0.9f, 0.3f)
        words(0.5f, 0.05f, bow, style, ink)
        if (placement == Placement.FLAT_TOP_TO_BOW) flatPhone(style) else twistedPhone(style)
    }
}

private fun Pen.flatPhone(style: TextStyle) {
    shape(accent) { moveTo(0.41f, 0.4f); lineTo(0.59f, 0.4f); lineTo(0.59f, 0.74f); lineTo(0.41f, 0.74f) }
    line(0.47f, 0.43f, 0.53f, 0.43f, accent)
    arrow(0.5f, 0.58f, 0.5f, 0.26f)
    arrow(0.5f, 0.58f, 0.72f, 0.58f)
    words(0.55f, 0.29f, "y", style)
    words(0.73f, 0.64f, "x", style)
    dot(0.5f, 0.58f)
    words(0.46f, 0.64f, "z", style)
}

private fun Pen.twistedPhone(style: TextStyle) {
    shape(accent) { moveTo(0.48f, 0.36f); lineTo(0.68f, 0.46f); lineTo(0.52f, 0.76f); lineTo(0.32f, 0.66f) }
    words(0.5f, 0.57f, "?", style)
}

private fun Pen.beam(from: Float, to: Float) = shape(fill = ink) {
    moveTo(from, 0.03f); lineTo(to, 0.03f); lineTo(to, 0.06f); lineTo(from, 0.06f)
}

private fun Pen.twoLines(left: Float, right: Float, top: Float, bottom: Float) {
    for (x in listOf(left, right)) {
        line(x, top, x, bottom)
        dot(x, top)
        dot(x, bottom)
    }
}

/** A point of the frame, and where its letter stands beside it. */
private class FramePoint(val letter: String, val x: Float, val y: Float, val dx: Float, val dy: Float)

/** Clockwise from the forward corner at starboard; A, H and G are the forward side. */
private val FRAME = listOf(
    FramePoint("A", 0.74f, 0.32f, 0.06f, 0f),
    FramePoint("B", 0.74f, 0.56f, 0.06f, 0f),
    FramePoint("C", 0.74f, 0.8f, 0.06f, 0f),
    FramePoint("D", 0.5f, 0.8f, 0.05f, 0.06f),
    FramePoint("E", 0.26f, 0.8f, -0.06f, 0f),
    FramePoint("F", 0.26f, 0.56f, -0.06f, 0f),
    FramePoint("G", 0.26f, 0.32f, -0.06f, 0f),
    FramePoint("H", 0.5f, 0.32f, 0.05f, -0.06f),
)
