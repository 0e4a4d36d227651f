package org.gyradius.app.ui

import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.res.stringResource
import org.gyradius.Verdict
import org.gyradius.app.R
import org.gyradius.unitOf

/** Limits of the class, each a quantity, a side and a figure. */
@Composable
fun Limits(limits: List<LimitTyped>, onLimits: (List<LimitTyped>) -> Unit) {
    Text(stringResource(R.string.class_limits_says), style = MaterialTheme.typography.bodyLarge)
    limits.forEachIndexed { at, one ->
        Limit(one, { onLimits(limits.toMutableList().apply { set(at, it) }) }, { onLimits(limits - one) })
    }
    WideButton(stringResource(R.string.limit_add), isMain = false) { onLimits(limits + LimitTyped(Goal.K_YAW, isLeast = true, "")) }
}

@Composable
private fun Limit(one: LimitTyped, onLimit: (LimitTyped) -> Unit, onRemove: () -> Unit) {
    Chips {
        for (goal in Goal.entries) Chip(quantityName(goal.measured), goal == one.goal) { onLimit(one.copy(goal = goal)) }
    }
    Chips {
        Chip(stringResource(R.string.limit_least), one.isLeast) { onLimit(one.copy(isLeast = true)) }
        Chip(stringResource(R.string.limit_most), !one.isLeast) { onLimit(one.copy(isLeast = false)) }
    }
    NumberField("${stringResource(R.string.limit)}, ${unitOf(one.goal.measured)}", one.value) { onLimit(one.copy(value = it)) }
    WideButton(stringResource(R.string.limit_remove), isMain = false, onClick = onRemove)
}

/** What is to be thought of one limit. */
@Composable
fun VerdictCard(one: Verdict) {
    val (words, tone) = when (one.verdict) {
        "pass" -> R.string.verdict_pass to Tone.INFO
        "fail" -> R.string.verdict_fail to Tone.WRONG
        else -> R.string.verdict_undecided to Tone.CAUTION
    }
    val sign = if (one.relation == ">=") "≥" else "≤"
    val unit = unitOf(one.quantity)
    Panel(tone) {
        Text(stringResource(words), style = MaterialTheme.typography.headlineSmall)
        Text(inUnit(R.string.limit_is, quantityName(one.quantity), sign, asTyped(one.limit), unit), style = MaterialTheme.typography.titleMedium)
        Text(stringResource(R.string.limit_probability, 100 * one.conformanceProbability), style = MaterialTheme.typography.bodyLarge)
    }
}
