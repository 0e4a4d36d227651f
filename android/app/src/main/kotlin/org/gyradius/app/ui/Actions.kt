package org.gyradius.app.ui

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.selection.selectable
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.RadioButton
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.saveable.rememberSaveable
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.unit.dp
import org.gyradius.Placement
import org.gyradius.ProcedureAction
import org.gyradius.ProcedureEvent
import org.gyradius.ProcedurePhase
import org.gyradius.ProcedureState
import org.gyradius.Recommend
import org.gyradius.app.R
import org.gyradius.app.run.Shown

/** A button for everything that may be done now; what is typed in has its fields. */
@Composable
fun Actions(shown: Shown, deeds: Deeds) {
    val state = shown.state ?: return
    val advised = advised(state)
    for (action in state.actions) {
        when (action) {
            ProcedureAction.BEGIN -> Begin(shown.isPractice, deeds)
            ProcedureAction.MEASURED -> Measuring(shown, state, deeds)
            ProcedureAction.START_RECORDING ->
                WideButton(stringResource(R.string.action_start_recording), onClick = deeds.record)
            ProcedureAction.WORK ->
                if (shown.isWorkStuck) WideButton(stringResource(R.string.action_work_again), onClick = deeds.workAgain)
            ProcedureAction.REOPEN -> Reopen(state, deeds)
            else -> plain(action)?.let { (text, event) ->
                WideButton(stringResource(text), action == advised) { deeds.handle(event) }
            }
        }
    }
}

/** The action that stands out; none while there is nothing to do but wait. */
private fun advised(state: ProcedureState): ProcedureAction? = when {
    state.phase == ProcedurePhase.REST && state.rest?.found == null -> null
    state.judgement?.recommend == Recommend.REPEAT -> ProcedureAction.REPEAT
    else -> state.actions.firstOrNull()
}

/** Actions that need nothing but a touch. */
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

/** How the phone lies, and the beginning; the simulated phone of practice lies as it does. */
@Composable
private fun Begin(isPractice: Boolean, deeds: Deeds) {
    var placement by rememberSaveable { mutableStateOf(Placement.FLAT_TOP_TO_BOW) }
    if (!isPractice) PlacementChoice(placement) { placement = it }
    WideButton(stringResource(R.string.action_begin)) { deeds.begin(placement) }
}

/** Which way the phone lies on the hull. */
@Composable
fun PlacementChoice(chosen: Placement, onChoice: (Placement) -> Unit) {
    SectionHead(stringResource(R.string.placement))
    PlacementSketch(chosen)
    Choice(R.string.placement_flat, chosen == Placement.FLAT_TOP_TO_BOW) { onChoice(Placement.FLAT_TOP_TO_BOW) }
    Choice(R.string.placement_any, chosen == Placement.ANY_WAY) { onChoice(Placement.ANY_WAY) }
}

@Composable
private fun Choice(text: Int, isChosen: Boolean, onChoice: () -> Unit) {
    Row(
        Modifier.fillMaxWidth().heightIn(min = 56.dp).selectable(isChosen, role = Role.RadioButton, onClick = onChoice),
        Arrangement.spacedBy(16.dp),
        Alignment.CenterVertically,
    ) {
        RadioButton(isChosen, null)
        Text(stringResource(text), style = MaterialTheme.typography.bodyLarge)
    }
}

/** What was measured of the hanging: asked for while it is hung, and open to mending afterwards. */
@Composable
private fun Measuring(shown: Shown, state: ProcedureState, deeds: Deeds) {
    val step = state.step ?: return
    when {
        state.phase != ProcedurePhase.HANG -> Fold(R.string.measured_again) { Hanging(step, deeds.measured) }
        shown.isPractice -> WideButton(stringResource(R.string.action_measured)) { deeds.measured(nothingMeasured) }
        else -> Hanging(step, deeds.measured)
    }
}

/** Every step by its number; one that is not done is refused in words. */
@Composable
private fun Reopen(state: ProcedureState, deeds: Deeds) {
    Fold(R.string.action_reopen) {
        for (at in 0uL until state.progress.steps) {
            val text = stringResource(R.string.step_of, at.toInt() + 1, state.progress.steps.toInt())
            WideButton(text, isMain = false) { deeds.handle(ProcedureEvent.Reopen(at)) }
        }
    }
}
