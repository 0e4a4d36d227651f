package org.gyradius.app.ui

import androidx.annotation.StringRes
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.res.stringResource
import org.gyradius.PlanStep
import org.gyradius.ProcedurePhase
import org.gyradius.ProcedureState
import org.gyradius.app.R
import org.gyradius.app.run.Shown
import org.gyradius.swing

/** The picture and the figures of a phase. */
@Composable
fun PhaseBody(state: ProcedureState) {
    when (state.phase) {
        ProcedurePhase.LEVEL -> state.tilt?.let { LevelBody(it) }
        ProcedurePhase.HANG -> state.step?.hanging?.let { SuspensionSketch(it) }
        ProcedurePhase.READY -> state.step?.planned?.swing?.let { ReadyBody(it) }
        ProcedurePhase.SUGGEST -> state.suggestion?.let { Suggested(it) }
        else -> Unit
    }
    state.rest?.let { RestBody(it) }
    state.recording?.let { RecordingBody(it) }
    state.judgement?.let { JudgementBody(it) }
    state.result?.let { ResultSummary(it) }
}

@Composable
private fun Suggested(step: PlanStep) {
    val swing = step.swing ?: return
    SuspensionSketch(swing.suspension)
    Motions(swing.excited)
}

/** What need not be seen from afar. */
@Composable
fun Details(shown: Shown, state: ProcedureState, deeds: Deeds) {
    state.recording?.let { RecordingDetails(it, shown.trace) }
    state.judgement?.let { JudgementDetails(it) }
    if (state.phase == ProcedurePhase.HANG) {
        state.tilt?.let { TiltFigures(it) }
    }
    state.critique?.let {
        SectionHead(stringResource(R.string.criticism))
        Advice(stringResource(statusOf(it.status)), toneOf(it.status))
        Text(spoken(it.message), style = MaterialTheme.typography.bodyLarge)
    }
    if (state.result != null) WideButton(stringResource(R.string.whole_result), isMain = state.phase == ProcedurePhase.DONE, onClick = deeds.openResult)
}

@StringRes
internal fun title(phase: ProcedurePhase): Int = when (phase) {
    ProcedurePhase.START -> R.string.phase_start
    ProcedurePhase.LEVEL -> R.string.phase_level
    ProcedurePhase.REST -> R.string.phase_rest
    ProcedurePhase.HANG -> R.string.phase_hang
    ProcedurePhase.READY -> R.string.phase_ready
    ProcedurePhase.RECORD -> R.string.phase_record
    ProcedurePhase.INTERRUPTED -> R.string.phase_interrupted
    ProcedurePhase.JUDGE -> R.string.phase_judge
    ProcedurePhase.MEASURE -> R.string.phase_measure
    ProcedurePhase.FAILED -> R.string.phase_failed
    ProcedurePhase.CRITIQUE -> R.string.phase_critique
    ProcedurePhase.SUGGEST -> R.string.phase_suggest
    ProcedurePhase.DONE -> R.string.phase_done
}

@StringRes
internal fun helpOf(phase: ProcedurePhase): Int = when (phase) {
    ProcedurePhase.START -> R.string.help_start
    ProcedurePhase.LEVEL -> R.string.help_level
    ProcedurePhase.REST -> R.string.help_rest
    ProcedurePhase.HANG -> R.string.help_hang
    ProcedurePhase.READY -> R.string.help_ready
    ProcedurePhase.RECORD -> R.string.help_record
    ProcedurePhase.INTERRUPTED -> R.string.help_interrupted
    ProcedurePhase.JUDGE -> R.string.help_judge
    ProcedurePhase.MEASURE, ProcedurePhase.CRITIQUE -> R.string.help_work
    ProcedurePhase.FAILED -> R.string.help_failed
    ProcedurePhase.SUGGEST -> R.string.help_suggest
    ProcedurePhase.DONE -> R.string.help_result
}
