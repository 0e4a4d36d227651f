package org.gyradius.app.ui

import androidx.annotation.StringRes
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.material3.LinearProgressIndicator
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import kotlin.math.abs
import org.gyradius.CauseResult
import org.gyradius.ComparedSwing
import org.gyradius.Critique
import org.gyradius.NextSwing
import org.gyradius.app.R

/** What the simulation gets wrong, why, what mending it gains, and the swing that would tell more. */
@Composable
fun CritiqueBody(critique: Critique, compared: List<ComparedSwing>) {
    SectionHead(stringResource(R.string.criticism))
    Advice(stringResource(statusOf(critique.verdict.status)), toneOf(critique.verdict.status))
    Text(spoken(critique.verdict.message), style = MaterialTheme.typography.bodyLarge)
    critique.warnings.forEach { Advice(spoken(it)) }
    Residuals(critique)
    if (critique.causes.isNotEmpty()) Fold(R.string.causes, isOpenAtFirst = true) { critique.causes.take(MOST_CAUSES).forEach { Cause(it) } }
    compared.forEach { Compared(it) }
    critique.verdict.nextSwing?.let { Next(it) }
    if (critique.discrepancies.isNotEmpty()) {
        Fold(R.string.discrepancies) { critique.discrepancies.forEach { Text(spoken(it.message), style = MaterialTheme.typography.bodyLarge) } }
    }
}

/** Residual over noise: 1 is all that noise leaves. */
@Composable
private fun Residuals(critique: Critique) {
    val before = critique.baseline.heldoutRmsOverNoise ?: critique.baseline.rmsOverNoise
    val after = critique.extended.heldoutRmsOverNoise ?: critique.extended.rmsOverNoise
    before?.let { Figure(stringResource(R.string.residual_before), stringResource(R.string.times_noise, it)) }
    after?.let { Figure(stringResource(R.string.residual_after), stringResource(R.string.times_noise, it)) }
    critique.gain.kYawShiftM?.takeIf { abs(it) >= LEAST_SHIFT_M }?.let {
        Figure(stringResource(R.string.k_yaw_shift), stringResource(R.string.metres_shift, it))
    }
}

@Composable
private fun Cause(one: CauseResult) {
    Stack(Modifier.semantics(mergeDescendants = true) {}) {
        Text(stringResource(R.string.cause_probability, causeName(one.id), 100 * one.probability), style = MaterialTheme.typography.titleMedium)
        val share = one.probability.toFloat()
        LinearProgressIndicator({ share }, Modifier.fillMaxWidth().height(8.dp).clearAndSetSemantics {})
        Text(spoken(one.message), style = MaterialTheme.typography.bodyLarge)
    }
}

@Composable
private fun Compared(one: ComparedSwing) {
    SectionHead(stringResource(R.string.compared_swing, idName(one.swing)))
    Text(spoken(one.channel), style = MaterialTheme.typography.bodyLarge)
    val drawn = listOf(
        Drawn(R.string.curve_measured, one.measured),
        Drawn(R.string.curve_base, one.base, isThin = true),
        Drawn(R.string.curve_extended, one.extended, isThin = true),
    )
    CurvePlot(R.string.compared_says, drawn, one.unit, WINDOW_S)
}

@Composable
private fun Next(swing: NextSwing) {
    SectionHead(stringResource(R.string.next_swing))
    Motions(swing.excited)
    Text(spoken(swing.message), style = MaterialTheme.typography.bodyLarge)
}

/** A status of the criticism in plain words; one that is not known yet reads as unexplained. */
@StringRes
internal fun statusOf(status: String): Int = when (status) {
    "adequate" -> R.string.status_adequate
    "explained" -> R.string.status_explained
    "ambiguous" -> R.string.status_ambiguous
    else -> R.string.status_unexplained
}

internal fun toneOf(status: String): Tone = when (status) {
    "adequate", "explained" -> Tone.INFO
    "ambiguous" -> Tone.CAUTION
    else -> Tone.WRONG
}

/** What is less shows as nothing. */
private const val LEAST_SHIFT_M = 0.00005

/** Causes further down are hardly probable. */
private const val MOST_CAUSES = 5

/** So much of a swing is drawn at once, s: some periods. */
private const val WINDOW_S = 20.0
