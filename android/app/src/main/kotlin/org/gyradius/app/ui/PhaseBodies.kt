package org.gyradius.app.ui

import androidx.compose.material3.LinearProgressIndicator
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.res.stringResource
import org.gyradius.Judgement
import org.gyradius.NamedQuantity
import org.gyradius.Recommend
import org.gyradius.RecordingView
import org.gyradius.RestView
import org.gyradius.ResultView
import org.gyradius.SideMotion
import org.gyradius.SideMotionKind
import org.gyradius.SwingState
import org.gyradius.Tilt
import org.gyradius.app.R
import org.gyradius.app.run.Trace
import org.gyradius.number

/** The hull's tilt, live. */
@Composable
fun TiltBody(tilt: Tilt) {
    tilt.bowUpDeg?.let { Figure(stringResource(R.string.bow_up), stringResource(R.string.degrees, it)) }
    tilt.starboardDownDeg?.let { Figure(stringResource(R.string.starboard_down), stringResource(R.string.degrees, it)) }
    if (tilt.bowUpDeg == null) {
        tilt.angleDeg?.let { Figure(stringResource(R.string.tilt), stringResource(R.string.degrees, it)) }
    }
}

/** How long the hull has been still. */
@Composable
fun RestBody(rest: RestView) {
    Figure(stringResource(R.string.still), stringResource(R.string.of_seconds, rest.stillS, rest.wantedS))
    LinearProgressIndicator({ (rest.stillS / rest.wantedS).toFloat().coerceIn(0f, 1f) })
}

/** The swing as it goes. */
@Composable
fun RecordingBody(recording: RecordingView, trace: List<Trace.Point>) {
    recording.advice.forEach { Advice(it.english) }
    if (trace.isNotEmpty()) TracePlot(trace)
    val left = recording.leftS?.let { stringResource(R.string.seconds, it) } ?: stringResource(R.string.waiting)
    Figure(stringResource(R.string.to_go), left)
    recording.amplitudeDeg?.let { Figure(stringResource(R.string.amplitude), stringResource(R.string.degrees, it)) }
    recording.live?.swing?.let { SwingBody(it) }
}

/** Period and unwanted motions. */
@Composable
private fun SwingBody(swing: SwingState) {
    val (value, u) = withUncertainty(swing.periodS, swing.periodUS)
    Figure(stringResource(R.string.period), stringResource(R.string.seconds_u, value, u))
    val others = swing.lines.map { sideMotion(it) }.ifEmpty { listOf(stringResource(R.string.unwanted_none)) }
    Text(stringResource(R.string.unwanted), style = MaterialTheme.typography.labelLarge)
    others.forEach { Text(it, style = MaterialTheme.typography.titleLarge) }
}

@Composable
private fun sideMotion(one: SideMotion): String {
    val kind = when (one.kind) {
        SideMotionKind.SWAY -> R.string.kind_sway
        SideMotionKind.OTHER_TURN -> R.string.kind_other_turn
        SideMotionKind.SAME_TURN -> R.string.kind_same_turn
    }
    return stringResource(R.string.unwanted_one, stringResource(kind), 100 * one.share, one.periodS)
}

/** Whether the recording is good. */
@Composable
fun JudgementBody(judgement: Judgement) {
    val isGood = judgement.recommend == Recommend.ACCEPT
    val verdict = if (isGood) R.string.recommend_accept else R.string.recommend_repeat
    Text(stringResource(verdict), style = MaterialTheme.typography.headlineLarge)
    judgement.reasons.forEach { Advice(it.english) }
    judgement.notes.forEach { Text(it.english, style = MaterialTheme.typography.bodyLarge) }
    judgement.swing?.let { SwingBody(it) }
}

/** Each quantity that is one number, with its uncertainty. */
@Composable
fun ResultBody(result: ResultView) {
    for (one in result.quantities) QuantityLine(one)
    result.warnings.forEach { Advice(it) }
}

@Composable
private fun QuantityLine(one: NamedQuantity) {
    val value = one.quantity.value.number ?: return
    val u = one.quantity.u.number ?: return
    val (shown, uncertainty) = withUncertainty(value, u)
    val (name, unit) = nameAndUnit(one.name)
    Figure(name, stringResource(R.string.quantity_u, shown, uncertainty, unit))
}

/** `k_yaw_m` is read as "k yaw" in m. */
internal fun nameAndUnit(name: String): Pair<String, String> {
    val endings = listOf("_kg_m2" to "kg m²", "_m_s2" to "m/s²", "_deg" to "°", "_kg" to "kg", "_m" to "m", "_s" to "s")
    val (ending, unit) = endings.firstOrNull { name.endsWith(it.first) } ?: ("" to "")
    return name.removeSuffix(ending).replace('_', ' ') to unit
}
