package org.gyradius.app.ui

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.aspectRatio
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.text.TextAutoSize
import androidx.compose.material3.CircularProgressIndicator
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.em
import androidx.compose.ui.unit.sp
import kotlin.math.abs
import kotlin.math.hypot
import org.gyradius.RestReading
import org.gyradius.RestView
import org.gyradius.SensorRest
import org.gyradius.Tilt
import org.gyradius.app.R

/** The hull's tilt, live: a bubble where the direction is known, and figures to be read from afar. */
@Composable
fun LevelBody(tilt: Tilt) {
    val (bowUpDeg, starboardDownDeg) = tilt.bowUpDeg to tilt.starboardDownDeg
    if (bowUpDeg != null && starboardDownDeg != null) Bubble(bowUpDeg, starboardDownDeg)
    TiltFigures(tilt)
}

/** The tilt in figures alone. */
@Composable
fun TiltFigures(tilt: Tilt) {
    val bowUpDeg = tilt.bowUpDeg
    if (bowUpDeg != null) {
        Large(stringResource(if (bowUpDeg < 0) R.string.bow_down else R.string.bow_up), degrees(bowUpDeg))
    }
    tilt.starboardDownDeg?.let {
        Large(stringResource(if (it < 0) R.string.port_down else R.string.starboard_down), degrees(it))
    }
    if (bowUpDeg == null) tilt.angleDeg?.let { Large(stringResource(R.string.tilt), degrees(it)) }
}

/** The size of an angle; the words beside it say which way. */
@Composable
private fun degrees(angle: Double): String = stringResource(R.string.degrees, abs(angle))

/** A figure as large as fits, to be read from some metres away. */
@Composable
fun Large(label: String, value: String, modifier: Modifier = Modifier) {
    Column(modifier.fillMaxWidth().semantics(mergeDescendants = true) {}) {
        Text(label, style = MaterialTheme.typography.titleLarge)
        Text(
            value,
            Modifier.fillMaxWidth(),
            fontWeight = FontWeight.Bold,
            maxLines = 1,
            autoSize = TextAutoSize.StepBased(minFontSize = 24.sp, maxFontSize = 88.sp, stepSize = 2.sp),
            lineHeight = 1.1.em,
        )
    }
}

/** The bubble moves to the side that is high, as in a spirit level; bow upwards. */
@Composable
private fun Bubble(bowUpDeg: Double, starboardDownDeg: Double) {
    val says = stringResource(R.string.sketch_bubble)
    val scheme = MaterialTheme.colorScheme
    val isLevel = hypot(bowUpDeg, starboardDownDeg) < LEVEL_DEG
    Box(Modifier.fillMaxWidth(), Alignment.Center) {
        Canvas(Modifier.widthIn(max = 300.dp).fillMaxWidth().aspectRatio(1f).semantics { contentDescription = says }) {
            rings(scheme.outline, scheme.surfaceVariant)
            val at = bubbleAt(bowUpDeg, starboardDownDeg)
            drawCircle(if (isLevel) scheme.primary else scheme.tertiary, RADIUS * size.width, at)
        }
    }
}

private fun DrawScope.rings(ink: Color, ground: Color) {
    drawCircle(ground)
    val thin = Stroke(2.dp.toPx())
    for (deg in listOf(1.0, 2.0)) drawCircle(ink, (deg / MOST_DEG * (0.5f - RADIUS) * size.width).toFloat(), style = thin)
    drawCircle(ink, (RADIUS + 0.02f) * size.width, style = thin)
    drawLine(ink, Offset(size.width / 2, 0f), Offset(size.width / 2, size.height), 1.dp.toPx())
    drawLine(ink, Offset(0f, size.height / 2), Offset(size.width, size.height / 2), 1.dp.toPx())
}

private fun DrawScope.bubbleAt(bowUpDeg: Double, starboardDownDeg: Double): Offset {
    val scale = (0.5f - RADIUS) * size.width / MOST_DEG
    val far = (hypot(bowUpDeg, starboardDownDeg) / MOST_DEG).coerceAtLeast(1.0)
    val (left, up) = starboardDownDeg / far * scale to bowUpDeg / far * scale
    return center + Offset(-left.toFloat(), -up.toFloat())
}

/** How long the hull has been still, and what the sensors showed. */
@Composable
fun RestBody(rest: RestView) {
    Box(Modifier.fillMaxWidth(), Alignment.Center) {
        Box(Modifier.widthIn(max = 260.dp).fillMaxWidth(0.7f).aspectRatio(1f), Alignment.Center) {
            val share = (rest.stillS / rest.wantedS).toFloat().coerceIn(0f, 1f)
            CircularProgressIndicator({ share }, Modifier.fillMaxSize(), strokeWidth = 16.dp)
            StillFor(rest)
        }
    }
    rest.moving?.takeIf { rest.found == null }?.let {
        Figure(stringResource(R.string.moving), stringResource(R.string.moving_by, it.rateDegS, it.tiltDeg))
    }
    rest.found?.let { Sensors(it) }
}

@Composable
private fun StillFor(rest: RestView) {
    val all = stringResource(R.string.of_seconds, rest.stillS, rest.wantedS)
    Text(
        stringResource(R.string.seconds, rest.stillS),
        Modifier.padding(32.dp).semantics { contentDescription = all },
        fontWeight = FontWeight.Bold,
        textAlign = TextAlign.Center,
        maxLines = 1,
        autoSize = TextAutoSize.StepBased(24.sp, 72.sp, 2.sp),
    )
}

@Composable
private fun Sensors(found: RestReading) {
    RestRate(R.string.gyroscope, found.gyroscope)
    found.accelerometer?.let { RestRate(R.string.accelerometer, it) }
    found.gravityMS2?.let { Figure(stringResource(R.string.gravity), stringResource(R.string.m_s2, it)) }
}

@Composable
private fun RestRate(name: Int, rest: SensorRest) =
    Figure(stringResource(name), stringResource(R.string.rate_and_gaps, rest.rateHz, rest.gaps.toInt()))

/** The bubble's radius as a part of the picture's width. */
private const val RADIUS = 0.07f

/** So far out the picture's rim stands, degrees. */
private const val MOST_DEG = 3.0

/** The bubble says "level" up to here, degrees. */
private const val LEVEL_DEG = 0.2
