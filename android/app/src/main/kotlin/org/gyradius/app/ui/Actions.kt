package org.gyradius.app.ui

import android.os.Build
import androidx.compose.foundation.text.KeyboardOptions
import androidx.compose.material3.OutlinedTextField
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.saveable.rememberSaveable
import androidx.compose.runtime.setValue
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.text.input.KeyboardType
import org.gyradius.MeasuredDimensions
import org.gyradius.PhoneInfo
import org.gyradius.Placement
import org.gyradius.ProcedureAction
import org.gyradius.ProcedureEvent
import org.gyradius.ProcedurePhase
import org.gyradius.Quantity
import org.gyradius.Recommend
import org.gyradius.Suspension
import org.gyradius.app.R
import org.gyradius.app.run.RunModel
import org.gyradius.app.run.Shown

/** A button for everything that may be done now; what is typed in has its fields. */
@Composable
fun Actions(shown: Shown, model: RunModel) {
    val state = shown.state ?: return
    val advised = if (state.judgement?.recommend == Recommend.REPEAT) ProcedureAction.REPEAT else state.actions.firstOrNull()
    for (action in state.actions) {
        val isMain = action == advised
        when (action) {
            ProcedureAction.BEGIN -> WideButton(stringResource(R.string.action_begin)) { begin(shown, model) }
            ProcedureAction.MEASURED -> if (state.phase == ProcedurePhase.HANG) Hanging(shown, model)
            ProcedureAction.START_RECORDING ->
                WideButton(stringResource(R.string.action_start_recording)) { model.record() }
            ProcedureAction.WORK ->
                if (shown.isWorkStuck) WideButton(stringResource(R.string.action_work_again), onClick = model::workAgain)
            else -> plain(action)?.let { (text, event) ->
                WideButton(stringResource(text), isMain) { model.handle(event) }
            }
        }
    }
}

private fun begin(shown: Shown, model: RunModel) {
    if (shown.isPractice) return model.byTheBook()
    model.start(PhoneInfo("${Build.MANUFACTURER} ${Build.MODEL}", model.sensors), Placement.FLAT_TOP_TO_BOW)
}

/** Actions that need nothing but a touch; opening a step again needs to know which. */
private fun plain(action: ProcedureAction): Pair<Int, ProcedureEvent>? = when (action) {
    ProcedureAction.SET_REFERENCE -> R.string.action_set_reference to ProcedureEvent.SetReference
    ProcedureAction.ACCEPT -> R.string.action_accept to ProcedureEvent.Accept
    ProcedureAction.REPEAT -> R.string.action_repeat to ProcedureEvent.Repeat
    ProcedureAction.SKIP -> R.string.action_skip to ProcedureEvent.Skip
    ProcedureAction.STOP_RECORDING -> R.string.action_stop_recording to ProcedureEvent.StopRecording
    ProcedureAction.CONTINUE -> R.string.action_continue to ProcedureEvent.Continue
    ProcedureAction.KEEP -> R.string.action_keep to ProcedureEvent.Keep
    ProcedureAction.RETRY -> R.string.action_retry to ProcedureEvent.Retry
    else -> null
}

/** Length and spacing as they were measured; in practice the simulated tape tells them. */
@Composable
private fun Hanging(shown: Shown, model: RunModel) {
    val planned = shown.state?.step?.hanging ?: return
    val measured = stringResource(R.string.action_measured)
    if (shown.isPractice) return WideButton(measured) { model.byTheBook() }
    var length by rememberSaveable(planned) { mutableStateOf(planned.lineLengthM?.value?.toString() ?: "") }
    var spacing by rememberSaveable(planned) { mutableStateOf(planned.spacingM?.value?.toString() ?: "") }
    if (planned.lineLengthM != null) Metres(R.string.line_length_m, length) { length = it }
    if (planned.spacingM != null) Metres(R.string.spacing_m, spacing) { spacing = it }
    WideButton(measured) { model.handle(ProcedureEvent.Measured(measuredAs(planned, length, spacing))) }
}

@Composable
private fun Metres(label: Int, text: String, onText: (String) -> Unit) {
    OutlinedTextField(
        text,
        onText,
        label = { Text(stringResource(label)) },
        keyboardOptions = KeyboardOptions(keyboardType = KeyboardType.Decimal),
        isError = numberIn(text) == null,
        singleLine = true,
    )
}

/** What was typed, with the uncertainty that was planned; what cannot be read stays as planned. */
private fun measuredAs(planned: Suspension, length: String, spacing: String) = MeasuredDimensions(
    lineLengthM = typed(length, planned.lineLengthM),
    spacingM = typed(spacing, planned.spacingM),
    topSpacingM = null,
    hullPitchDeg = null,
    pointsMovedM = null,
    axisHeightM = null,
    massKg = null,
    armM = null,
    depthM = null,
)

private fun typed(text: String, planned: Quantity?): Quantity? =
    planned?.let { Quantity(numberIn(text) ?: it.value, it.u) }

