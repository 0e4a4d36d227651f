package org.gyradius.app.ui

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.safeDrawingPadding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.FilterChip
import androidx.compose.material3.LinearProgressIndicator
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Text
import androidx.compose.material3.TextButton
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import org.gyradius.Channel
import org.gyradius.ProcedurePhase
import org.gyradius.ProcedureState
import org.gyradius.app.R
import org.gyradius.app.run.RunModel
import org.gyradius.app.run.Shown

/** The procedure: what to do now, what is measured, what may be done. */
@Composable
fun ProcedureScreen(shown: Shown, model: RunModel) {
    val state = shown.state ?: return
    Stack(Modifier.safeDrawingPadding().verticalScroll(rememberScrollState()).padding(16.dp)) {
        Heading(state, model::leave)
        if (shown.isPractice) Pace(shown.pace, model::setPace)
        Text(state.instruction.english, style = MaterialTheme.typography.headlineSmall)
        (listOfNotNull(shown.error) + state.warnings.map { it.english }).forEach { Advice(it) }
        shown.silent.forEach { Advice(stringResource(silence(it))) }
        PhaseBody(shown, state)
        if (state.work != null && !shown.isWorkStuck) Working(shown.workShare)
        Actions(shown, model)
    }
}

@Composable
private fun Heading(state: ProcedureState, onLeave: () -> Unit) {
    Row(horizontalArrangement = Arrangement.SpaceBetween) {
        Text(
            stringResource(title(state.phase)),
            Modifier.weight(1f).semantics { heading() },
            style = MaterialTheme.typography.headlineLarge,
        )
        TextButton(onLeave) { Text(stringResource(R.string.back)) }
    }
    val progress = state.progress
    LinearProgressIndicator({ progress.share.toFloat() })
    state.step?.let {
        val at = stringResource(R.string.step_of, it.index.toInt() + 1, it.count.toInt())
        Text("$at · ${it.id}", style = MaterialTheme.typography.titleMedium)
    }
}

@Composable
private fun Pace(pace: Int, onPace: (Int) -> Unit) {
    Row(horizontalArrangement = Arrangement.spacedBy(8.dp)) {
        Text("${stringResource(R.string.practice)} · ${stringResource(R.string.practice_time)}", Modifier.padding(top = 14.dp))
        for (one in listOf(1, 10, 60)) FilterChip(one == pace, { onPace(one) }, { Text("$one×") })
    }
}

@Composable
private fun PhaseBody(shown: Shown, state: ProcedureState) {
    state.tilt?.takeIf { state.recording == null }?.let { TiltBody(it) }
    state.rest?.let { RestBody(it) }
    state.recording?.let { RecordingBody(it, shown.trace) }
    state.judgement?.let { JudgementBody(it) }
    state.result?.let { ResultBody(it) }
    state.critique?.let { Text(it.text, style = MaterialTheme.typography.bodyLarge) }
}

private fun silence(channel: Channel): Int =
    if (channel == Channel.ACCELEROMETER) R.string.sensor_stopped_accelerometer else R.string.sensor_stopped_gyroscope

@Composable
private fun Working(share: Double?) {
    val done = share ?: return LinearProgressIndicator()
    LinearProgressIndicator({ done.toFloat() })
}

/** What a phase is called. */
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
