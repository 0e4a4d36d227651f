package org.gyradius.app.ui

import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.res.stringResource
import org.gyradius.Claim
import org.gyradius.InertiaResult
import org.gyradius.NamedQuantity
import org.gyradius.NamedRoutes
import org.gyradius.QuantityValue
import org.gyradius.ResultView
import org.gyradius.SwingResult
import org.gyradius.app.R
import org.gyradius.number
import org.gyradius.unitOf

/** Each quantity that is one number, with its uncertainty, the gyradii first. */
@Composable
fun ResultSummary(result: ResultView) {
    Quantities(result.quantities)
    result.warnings.forEach { Advice(spoken(it)) }
}

/** The same of any result. */
@Composable
fun Quantities(quantities: List<NamedQuantity>) {
    quantities.inOrder { it.name }.forEach { QuantityLine(it) }
}

@Composable
private fun QuantityLine(one: NamedQuantity) {
    val value = one.quantity.value.number ?: return
    val u = one.quantity.u.number ?: return
    val (shown, uncertainty) = withUncertainty(value, u)
    Figure(quantityName(one.name), inUnit(R.string.quantity_u, shown, uncertainty, unitOf(one.name)))
}

/** What stands behind the result: folded away until somebody asks. */
@Composable
fun ResultDetails(result: InertiaResult) {
    Fold(R.string.intervals) { result.quantities.forEach { IntervalLine(it) } }
    Fold(R.string.consistency) { result.consistency.forEach { ClaimLine(it) } }
    Fold(R.string.budget) { result.budget.forEach { Budget(it) } }
    Fold(R.string.routes) { result.alternatives.forEach { Routes(it) } }
    // A bare recording has nothing but its periods.
    val hasFigures = result.quantities.any { it.quantity.value.number != null }
    Fold(R.string.swings, isOpenAtFirst = !hasFigures) { result.swings.forEach { SwingLine(it) } }
}

@Composable
private fun IntervalLine(one: NamedQuantity) {
    val between = one.quantity.interval95 ?: return
    val u = one.quantity.u.number ?: return
    val (low, high) = withUncertainty(between.low, u).first to withUncertainty(between.high, u).first
    Figure(quantityName(one.name), inUnit(R.string.from_to, low, high, unitOf(one.name)))
}

@Composable
private fun ClaimLine(one: Claim) {
    if (one.flagged) Advice(spoken(one.message)) else Text(spoken(one.message), style = MaterialTheme.typography.bodyLarge)
}

@Composable
private fun Routes(one: NamedRoutes) {
    Text(quantityName(one.name), style = MaterialTheme.typography.titleMedium)
    for (route in one.routes) {
        val (value, u) = withUncertainty(route.value, route.u)
        val figure = inUnit(R.string.quantity_u, value, u, unitOf(one.name))
        Text("${routeName(route.method)}: $figure", style = MaterialTheme.typography.bodyLarge)
    }
}

@Composable
private fun SwingLine(one: SwingResult) {
    Text(idName(one.id), style = MaterialTheme.typography.titleMedium)
    for (mode in one.modes) {
        val (value, u) = withUncertainty(mode.periodS, mode.periodSeS)
        Text("${stringResource(wordOf(mode.mode))}: ${stringResource(R.string.seconds_u, value, u)}", style = MaterialTheme.typography.bodyLarge)
    }
    one.warnings.forEach { Text(spoken(it), style = MaterialTheme.typography.bodyLarge) }
}

/** The three numbers of a quantity, where it has them. */
internal fun List<NamedQuantity>.three(name: String): List<Double>? =
    (firstOrNull { it.name == name }?.quantity?.value as? QuantityValue.Vector)?.values?.takeIf { it.size == 3 }

/** As the report has them: the gyradii first. */
internal fun <T> List<T>.inOrder(name: (T) -> String): List<T> =
    sortedBy { one -> HEADLINES.indexOf(name(one)).let { if (it < 0) HEADLINES.size else it } }

/** The order of the report. */
private val HEADLINES = listOf("k_yaw_m", "k_pitch_m", "k_roll_m", "cm_depth_m", "psi_deg")
