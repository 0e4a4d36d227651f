package org.gyradius.app.ui

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.widthIn
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.unit.dp
import kotlin.math.cos
import kotlin.math.sin
import org.gyradius.Excitation
import org.gyradius.app.R

/** The motions to set going, each with its picture and its name. */
@Composable
fun Motions(excited: List<Excitation>) {
    Row(Modifier.fillMaxWidth(), Arrangement.spacedBy(16.dp, Alignment.CenterHorizontally)) {
        for (one in excited) {
            Column(Modifier.weight(1f, fill = false).widthIn(max = 260.dp).semantics(mergeDescendants = true) {}) {
                MotionPicture(one)
                Text(
                    stringResource(wordOf(one)),
                    Modifier.fillMaxWidth(),
                    style = MaterialTheme.typography.headlineSmall,
                    fontWeight = FontWeight.Bold,
                    textAlign = TextAlign.Center,
                )
                Text(stringResource(howTo(one)), Modifier.fillMaxWidth(), textAlign = TextAlign.Center)
            }
        }
    }
}

@Composable
private fun MotionPicture(excited: Excitation) = when (excited) {
    Excitation.YAW -> Sketch(R.string.sketch_yaw, 1f) {
        hullFromAbove(0.08f, 0.92f, 0.17f)
        turn(0.5f, 0.5f, 0.38f, -60f)
        turn(0.5f, 0.5f, 0.38f, 120f)
        listOf(0.36f, 0.64f).forEach { dot(it, 0.52f, ink, 0.02f) }
    }
    Excitation.SWAY -> Sketch(R.string.sketch_sway, 1f) {
        hullFromAbove(0.08f, 0.92f, 0.17f)
        arrow(0.72f, 0.5f, 0.95f, 0.5f)
        arrow(0.28f, 0.5f, 0.05f, 0.5f)
        listOf(0.36f, 0.64f).forEach { dot(it, 0.52f, ink, 0.02f) }
    }
    Excitation.SURGE -> Sketch(R.string.sketch_surge, 1f) {
        hungFromTheSide()
        arrow(0.6f, 0.86f, 0.9f, 0.86f)
        arrow(0.4f, 0.86f, 0.1f, 0.86f)
    }
    Excitation.PITCH -> Sketch(R.string.sketch_pitch, 1f) {
        hungFromTheSide()
        turn(0.5f, 0.64f, 0.38f, 125f)
        turn(0.5f, 0.64f, 0.38f, 20f)
    }
    Excitation.ROLL -> Sketch(R.string.sketch_roll, 1f) {
        line(0.5f, 0.06f, 0.5f, 0.5f)
        hullFromAhead(0.5f)
        dot(0.5f, 0.5f, ink, 0.02f)
        turn(0.5f, 0.56f, 0.4f, 130f)
        turn(0.5f, 0.56f, 0.4f, 20f)
    }
}

private fun Pen.hungFromTheSide() {
    line(0.5f, 0.06f, 0.5f, 0.56f)
    hullFromTheSide(0.56f)
    dot(0.5f, 0.56f, ink, 0.02f)
}

/** An arc of 45° with heads at both ends, from an angle in degrees, clockwise from the right. */
private fun Pen.turn(x: Float, y: Float, radius: Float, fromDeg: Float) {
    val (from, to) = radians(fromDeg) to radians(fromDeg + 35f)
    shape(accent, null, isClosed = false) {
        for (step in 0..16) {
            val angle = from + (to - from) * step / 16
            val (px, py) = x + radius * cos(angle) to y + radius * sin(angle)
            if (step == 0) moveTo(px, py) else lineTo(px, py)
        }
    }
    head(x + radius * cos(from), y + radius * sin(from), from - RIGHT)
    head(x + radius * cos(to), y + radius * sin(to), to + RIGHT)
}

private fun radians(degrees: Float): Float = Math.toRadians(degrees.toDouble()).toFloat()

private val RIGHT = radians(90f)
