package org.gyradius.app.ui

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.material3.Icon
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.res.painterResource
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import org.gyradius.BudgetLine
import org.gyradius.HangingAdvice
import org.gyradius.NamedBudget
import org.gyradius.NamedPrediction
import org.gyradius.PlanResult
import org.gyradius.PredictedSwing
import org.gyradius.app.R
import org.gyradius.unitOf

/** What the planner advises: warnings first, then what to expect, then how to hang it. */
@Composable
fun PlanCards(plan: PlanResult) {
    plan.warnings.forEach { Advice(spoken(it)) }
    SectionHead(stringResource(R.string.expected))
    plan.quantities.inOrder { it.name }.forEach { Expected(it) }
    Figure(stringResource(R.string.effort), stringResource(R.string.minutes, plan.effortS / SECONDS_PER_MINUTE))
    SectionHead(stringResource(R.string.how_to_hang))
    plan.suspensions.forEach { Hung(it) }
    Fold(R.string.periods_expected) { plan.predicted.forEach { Periods(it) } }
    Fold(R.string.budget) { plan.budget.forEach { Budget(it) } }
}

@Composable
private fun Expected(one: NamedPrediction) {
    val predicted = one.quantity
    val unit = unitOf(one.name)
    val figure = predicted.u?.let { u ->
        val (value, uncertainty) = withUncertainty(predicted.value, u)
        inUnit(R.string.quantity_u, value, uncertainty, unit)
    } ?: stringResource(R.string.not_determined)
    Row(Modifier.fillMaxWidth().semantics(mergeDescendants = true) {}, verticalAlignment = Alignment.CenterVertically) {
        Figure(quantityName(one.name), figure, Modifier.weight(1f))
        predicted.isReached?.let { Reached(it) }
    }
}

@Composable
private fun Reached(isReached: Boolean) {
    val scheme = MaterialTheme.colorScheme
    if (isReached) {
        Icon(painterResource(R.drawable.ic_done), stringResource(R.string.reached), tint = scheme.primary)
    } else {
        Text(stringResource(R.string.not_reached), color = scheme.error, style = MaterialTheme.typography.titleMedium)
    }
}

@Composable
private fun Hung(one: HangingAdvice) {
    Panel(Tone.INFO) {
        val points = stringResource(R.string.frame_points, one.framePoints, one.swings.map { idName(it) }.joinToString())
        Text(points, style = MaterialTheme.typography.titleMedium)
        Text(spoken(one.message), style = MaterialTheme.typography.bodyLarge)
    }
    FrameSketch(one.framePoints)
}

@Composable
private fun Periods(one: PredictedSwing) {
    Stack(Modifier.semantics(mergeDescendants = true) {}) {
        Text(idName(one.id), style = MaterialTheme.typography.titleMedium)
        for ((mode, periodS) in one.periodsS.toSortedMap()) {
            Text(stringResource(R.string.mode_period, stringResource(wordOf(mode)), periodS), style = MaterialTheme.typography.bodyLarge)
        }
        val beat = one.beat ?: return@Stack
        val words = beat.periodS?.let { stringResource(R.string.beat, it) } ?: stringResource(R.string.beat_none)
        Text(words, style = MaterialTheme.typography.bodyLarge)
    }
}

/** What an uncertainty comes from, the largest first. */
@Composable
fun Budget(one: NamedBudget) {
    Text(quantityName(one.name), style = MaterialTheme.typography.titleMedium)
    one.lines.take(MOST_LINES).forEach { Contribution(it, unitOf(one.name)) }
}

@Composable
private fun Contribution(line: BudgetLine, unit: String) {
    Row(Modifier.fillMaxWidth().semantics(mergeDescendants = true) {}, Arrangement.spacedBy(16.dp)) {
        Text(inputName(line.input), Modifier.weight(1f), style = MaterialTheme.typography.bodyLarge)
        Text(inUnit(R.string.contribution, line.uContribution, unit), style = MaterialTheme.typography.bodyLarge)
    }
}

private const val SECONDS_PER_MINUTE = 60.0

/** Contributions beyond these hardly count. */
private const val MOST_LINES = 4
