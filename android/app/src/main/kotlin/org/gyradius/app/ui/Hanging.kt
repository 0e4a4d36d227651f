package org.gyradius.app.ui

import androidx.annotation.StringRes
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.text.KeyboardOptions
import androidx.compose.material3.OutlinedTextField
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.saveable.rememberSaveable
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.text.input.KeyboardType
import androidx.compose.ui.unit.dp
import java.io.Serializable
import org.gyradius.MeasuredDimensions
import org.gyradius.Quantity
import org.gyradius.StepView
import org.gyradius.app.R
import org.gyradius.incline

/** What can be measured of a hanging hull. */
internal enum class Dimension(@StringRes val label: Int) {
    LINE_LENGTH(R.string.line_length_m),
    SPACING(R.string.spacing_m),
    TOP_SPACING(R.string.top_spacing_m),
    HULL_PITCH(R.string.hull_pitch_deg),
    POINTS_MOVED(R.string.points_moved_m),
    AXIS_HEIGHT(R.string.axis_height_m),
    MASS(R.string.weight_kg),
    ARM(R.string.arm_m),
    DEPTH(R.string.depth_m),
}

/** A figure and its uncertainty as they stand in their fields. */
internal data class Typed(val value: String, val u: String) : Serializable {
    /** As a quantity, where both can be read. */
    fun quantity(): Quantity? = numberIn(value)?.let { read -> numberIn(u)?.takeIf { it >= 0.0 }?.let { Quantity(read, it) } }
}

/** Everything that this step wants measured; it can be passed on once every field can be read. */
@Composable
internal fun Hanging(step: StepView, onMeasured: (MeasuredDimensions) -> Unit) {
    var typed by rememberSaveable(step.id) { mutableStateOf(HashMap(asked(step))) }
    for ((dimension, one) in typed.toSortedMap()) {
        QuantityFields(dimension.label, one) { typed = HashMap(typed + (dimension to it)) }
    }
    val read = typed.mapValues { it.value.quantity() }
    WideButton(stringResource(R.string.action_measured), isEnabled = read.values.all { it != null }) {
        onMeasured(measuredAs(read))
    }
}

/** A figure and its uncertainty beside each other, or below where large type leaves no room. */
@Composable
internal fun QuantityFields(@StringRes label: Int, typed: Typed, isNeeded: Boolean = true, onTyped: (Typed) -> Unit) {
    val value: @Composable (Modifier) -> Unit = { room ->
        NumberField(stringResource(label), typed.value, room, isNeeded) { onTyped(typed.copy(value = it)) }
    }
    val u: @Composable (Modifier) -> Unit = { room -> NumberField("±", typed.u, room, isNeeded) { onTyped(typed.copy(u = it)) } }
    if (LocalDensity.current.fontScale > LARGE_TYPE) {
        Stack { value(Modifier); u(Modifier) }
    } else {
        Row(Modifier.fillMaxWidth(), Arrangement.spacedBy(8.dp)) { value(Modifier.weight(2f)); u(Modifier.weight(1f)) }
    }
}

/** From here on the name of a field takes the whole width. */
private const val LARGE_TYPE = 1.3f

/** A field for a number; one that cannot be read is marked. */
@Composable
internal fun NumberField(label: String, text: String, modifier: Modifier = Modifier, isNeeded: Boolean = true, onText: (String) -> Unit) {
    OutlinedTextField(
        text,
        onText,
        modifier.fillMaxWidth(),
        label = { Text(label) },
        keyboardOptions = KeyboardOptions(keyboardType = KeyboardType.Decimal),
        isError = numberIn(text) == null && (isNeeded || text.isNotBlank()),
        singleLine = true,
    )
}

/** What a step wants measured, as it is planned; of an incline the plan has no uncertainties. */
internal fun asked(step: StepView): Map<Dimension, Typed> {
    step.planned.incline?.let {
        return mapOf(
            Dimension.MASS to Typed(asTyped(it.massKg), ""),
            Dimension.ARM to Typed(asTyped(it.armM), ""),
            Dimension.DEPTH to Typed(asTyped(it.depthM), ""),
        )
    }
    val hung = step.hanging ?: return emptyMap()
    return listOf(
        Dimension.LINE_LENGTH to hung.lineLengthM,
        Dimension.SPACING to hung.spacingM,
        Dimension.TOP_SPACING to hung.topSpacingM,
        Dimension.HULL_PITCH to hung.hullPitchDeg,
        Dimension.POINTS_MOVED to hung.pointsMovedM,
        Dimension.AXIS_HEIGHT to hung.axisHeightM,
    ).mapNotNull { (dimension, planned) -> planned?.let { dimension to Typed(asTyped(it.value), asTyped(it.u)) } }.toMap()
}

internal fun measuredAs(read: Map<Dimension, Quantity?>) = MeasuredDimensions(
    lineLengthM = read[Dimension.LINE_LENGTH],
    spacingM = read[Dimension.SPACING],
    topSpacingM = read[Dimension.TOP_SPACING],
    hullPitchDeg = read[Dimension.HULL_PITCH],
    pointsMovedM = read[Dimension.POINTS_MOVED],
    axisHeightM = read[Dimension.AXIS_HEIGHT],
    massKg = read[Dimension.MASS],
    armM = read[Dimension.ARM],
    depthM = read[Dimension.DEPTH],
)

/** Everything stays as planned. */
internal val nothingMeasured = measuredAs(emptyMap())

/** A number as people type it, with a comma or a point. */
internal fun numberIn(text: String): Double? = text.trim().replace(',', '.').toDoubleOrNull()?.takeIf { it.isFinite() }
