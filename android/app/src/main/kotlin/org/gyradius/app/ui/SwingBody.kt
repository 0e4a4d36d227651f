package org.gyradius.app.ui

import androidx.compose.material3.LinearProgressIndicator
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.unit.dp
import kotlin.math.ceil
import org.gyradius.GapList
import org.gyradius.Judgement
import org.gyradius.LiveEstimate
import org.gyradius.PlannedSwing
import org.gyradius.Recommend
import org.gyradius.RecordingView
import org.gyradius.Sensor
import org.gyradius.SensorGap
import org.gyradius.SensorState
import org.gyradius.SideMotion
import org.gyradius.SwingState
import org.gyradius.TimeLeft
import org.gyradius.app.R
import org.gyradius.app.run.Trace

/** What to set going, before the recording. */
@Composable
fun ReadyBody(swing: PlannedSwing) {
    Motions(swing.excited)
    Large(stringResource(R.string.hold_aside), stringResource(R.string.degrees_whole, swing.amplitudeDeg))
    Figure(stringResource(R.string.runs_for), stringResource(R.string.seconds, swing.durationS))
}

/** The swing as it goes: first what is read from metres away. */
@Composable
fun RecordingBody(recording: RecordingView) {
    val left = recording.leftS
    if (left != null) {
        // Rounded as the instruction above it is.
        Large(stringResource(R.string.to_go), stringResource(R.string.seconds, ceil(left)))
    } else {
        Large(stringResource(R.string.recorded), stringResource(R.string.seconds, recording.recordedS))
    }
    recording.advice.forEach { Advice(spoken(it)) }
    recording.live?.swing?.let { PeriodFigure(it) }
}

/** The rest of what is known of the swing, for whoever stands beside it. */
@Composable
fun RecordingDetails(recording: RecordingView, trace: List<Trace.Point>) {
    if (trace.isNotEmpty()) TracePlot(trace)
    val amplitudeDeg = recording.amplitudeDeg
    if (amplitudeDeg != null) {
        val wanted = recording.wantedDeg?.let { stringResource(R.string.degrees_of, amplitudeDeg, it) }
        Figure(stringResource(R.string.amplitude), wanted ?: stringResource(R.string.degrees, amplitudeDeg))
    }
    recording.live?.swing?.let { swing ->
        TimeLeftLine(swing.timeLeft)
        SideMotions(swing.lines)
    }
    recording.live?.let { Rates(it) }
}

@Composable
private fun PeriodFigure(swing: SwingState) {
    val (value, u) = withUncertainty(swing.periodS, swing.periodUS)
    Figure(stringResource(R.string.period), stringResource(R.string.seconds_u, value, u))
}

@Composable
private fun TimeLeftLine(left: TimeLeft) {
    val words = when (left) {
        is TimeLeft.Reached -> stringResource(R.string.certain_enough)
        is TimeLeft.Seconds -> stringResource(R.string.certain_in, left.v1)
        is TimeLeft.OutOfReach -> stringResource(R.string.certain_never)
    }
    Text(words, style = MaterialTheme.typography.titleMedium)
}

/** Motions that nobody asked for, each with a bar of its size. */
@Composable
private fun SideMotions(all: List<SideMotion>) {
    val lines = all.filter { it.share >= LEAST_SHARE }
    SectionHead(stringResource(R.string.unwanted))
    if (lines.isEmpty()) Text(stringResource(R.string.unwanted_none), style = MaterialTheme.typography.titleMedium)
    for (one in lines) {
        val words = stringResource(R.string.unwanted_one, stringResource(wordOf(one.kind)), 100 * one.share, one.periodS)
        Text(asShown(words), style = MaterialTheme.typography.titleMedium)
        val share = one.share.toFloat().coerceIn(0f, 1f)
        LinearProgressIndicator({ share }, Modifier.fillMaxWidth().height(8.dp).clearAndSetSemantics {})
    }
}

/** What the sensors really do. */
@Composable
private fun Rates(live: LiveEstimate) {
    SectionHead(stringResource(R.string.sensors))
    live.sensors.forEach { RateLine(it) }
    Gaps(live.gaps)
}

@Composable
private fun RateLine(one: SensorState) {
    val name = sensorName(one.sensor)
    val rate = one.rateHz ?: return Text(stringResource(R.string.no_samples, name), style = MaterialTheme.typography.titleMedium)
    val words = if (one.gaps == 0uL) {
        stringResource(R.string.rate_no_gaps, name, rate)
    } else {
        stringResource(R.string.rate_gaps, name, rate, one.gaps.toInt(), one.longestGapS)
    }
    Text(words, style = MaterialTheme.typography.titleMedium)
}

/** Every time without samples, for whoever asks. */
@Composable
private fun Gaps(gaps: GapList) {
    if (gaps.listed.isEmpty()) return
    Fold(R.string.gaps) {
        Text(stringResource(R.string.gaps_say), style = MaterialTheme.typography.bodyLarge)
        gaps.listed.forEach { GapLine(it) }
        if (gaps.more > 0uL) Text(stringResource(R.string.gaps_more, gaps.more.toInt()), style = MaterialTheme.typography.bodyLarge)
    }
}

@Composable
private fun GapLine(gap: SensorGap) {
    val words = stringResource(R.string.gap_one, gap.fromS, sensorName(gap.sensor), gap.lengthS)
    Text(words, style = MaterialTheme.typography.titleMedium)
}

@Composable
private fun sensorName(sensor: Sensor): String =
    stringResource(if (sensor == Sensor.GYROSCOPE) R.string.gyroscope else R.string.accelerometer)

/** Whether the recording is good. */
@Composable
fun JudgementBody(judgement: Judgement) {
    if (judgement.recommend == Recommend.ACCEPT) {
        Advice(stringResource(R.string.recommend_accept), Tone.INFO)
    } else {
        Advice(stringResource(R.string.recommend_repeat), Tone.WRONG)
    }
    judgement.reasons.forEach { Advice(spoken(it)) }
    judgement.swing?.let { PeriodFigure(it) }
    judgement.incline?.let {
        val (value, u) = withUncertainty(it.angleDeg, it.uDeg)
        Figure(stringResource(R.string.tilt), stringResource(R.string.degrees_u, value, u))
    }
}

/** What else there is to know of it. */
@Composable
fun JudgementDetails(judgement: Judgement) {
    judgement.notes.forEach { Text(spoken(it), style = MaterialTheme.typography.bodyLarge) }
    judgement.swing?.let { SideMotions(it.lines) }
    Gaps(judgement.gaps)
}

/** What is less would read as 0 %. */
private const val LEAST_SHARE = 0.005
