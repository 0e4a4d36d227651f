package org.gyradius.app.ui

import android.os.Build
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.material3.LinearProgressIndicator
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.DisposableEffect
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalView
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import org.gyradius.Channel
import org.gyradius.MeasuredDimensions
import org.gyradius.PhoneInfo
import org.gyradius.Placement
import org.gyradius.ProcedureEvent
import org.gyradius.ProcedurePhase
import org.gyradius.ProcedureState
import org.gyradius.app.R
import org.gyradius.app.run.RunModel
import org.gyradius.app.run.Shown

/** What an operator can do while the procedure runs. */
class Deeds(
    val begin: (Placement) -> Unit,
    val measured: (MeasuredDimensions) -> Unit,
    val record: () -> Unit,
    val workAgain: () -> Unit,
    val handle: (ProcedureEvent) -> Unit,
    val setPace: (Int) -> Unit,
    val leave: () -> Unit,
    /** Opens the whole result. */
    val openResult: () -> Unit,
)

/** The procedure as its model runs it; the screen stays on, for nobody touches it. */
@Composable
fun ProcedureScreen(
    shown: Shown,
    model: RunModel,
    isAloud: Boolean,
    onAloud: (Boolean) -> Unit,
    onLeave: () -> Unit,
    onResult: () -> Unit,
) {
    ScreenOn()
    ProcedurePage(shown, deedsOf(shown.isPractice, model, onLeave, onResult), isAloud, onAloud)
}

@Composable
private fun ScreenOn() {
    val view = LocalView.current
    DisposableEffect(view) {
        view.keepScreenOn = true
        onDispose { view.keepScreenOn = false }
    }
}

/** In practice the simulated hull's tape tells what there is to type in. */
private fun deedsOf(isPractice: Boolean, model: RunModel, onLeave: () -> Unit, onResult: () -> Unit) = Deeds(
    begin = { placement ->
        val phone = PhoneInfo("${Build.MANUFACTURER} ${Build.MODEL}", model.sensors)
        if (isPractice) model.byTheBook() else model.start(phone, placement)
    },
    measured = { if (isPractice) model.byTheBook() else model.handle(ProcedureEvent.Measured(it)) },
    record = model::record,
    workAgain = model::workAgain,
    handle = { model.handle(it) },
    setPace = model::setPace,
    leave = onLeave,
    openResult = onResult,
)

/** The procedure: what to do now, what is measured, what may be done. */
@Composable
fun ProcedurePage(shown: Shown, deeds: Deeds, isAloud: Boolean, onAloud: (Boolean) -> Unit) {
    val state = shown.state ?: return
    Page {
        TopBar(stringResource(title(state.phase)), deeds.leave, R.string.back) {
            AloudButton(isAloud, onAloud)
            HelpButton(helpOf(state.phase))
        }
        Progress(state)
        if (shown.isPractice) PracticeBanner(shown.pace, deeds.setPace)
        TwoColumns({ Now(shown, state) }) {
            Actions(shown, deeds)
            Details(shown, state, deeds)
        }
    }
}

@Composable
private fun AloudButton(isAloud: Boolean, onAloud: (Boolean) -> Unit) {
    val (picture, says) = if (isAloud) R.drawable.ic_sound_on to R.string.sound_off else R.drawable.ic_sound_off to R.string.sound_on
    BarButton(picture, says) { onAloud(!isAloud) }
}

@Composable
private fun Progress(state: ProcedureState) {
    val share = state.progress.share.toFloat()
    LinearProgressIndicator({ share }, Modifier.fillMaxWidth().height(8.dp))
    state.step?.let {
        val at = stringResource(R.string.step_of, it.index.toInt() + 1, it.count.toInt())
        val take = if (it.take > 1uL) " · " + stringResource(R.string.take, it.take.toInt()) else ""
        Text("$at · ${idName(it.id)}$take", style = MaterialTheme.typography.titleMedium)
    }
}

/** What is to be done, and what is measured. */
@Composable
private fun Now(shown: Shown, state: ProcedureState) {
    val isQuiet = state.phase in setOf(ProcedurePhase.LEVEL, ProcedurePhase.REST, ProcedurePhase.RECORD)
    val region = if (isQuiet) Modifier else Modifier.semantics { liveRegion = LiveRegionMode.Polite }
    Text(instruction(state), region, style = MaterialTheme.typography.headlineSmall)
    shown.error?.let { Advice(spoken(it), Tone.WRONG) }
    shown.silent.forEach { Advice(stringResource(silence(it)), Tone.WRONG) }
    state.warnings.forEach { Advice(spoken(it)) }
    PhaseBody(state)
    if (state.work != null && !shown.isWorkStuck) Working(shown.workShare)
}

/** At the end the library names the folder, which on a phone nobody can open. */
@Composable
private fun instruction(state: ProcedureState): String =
    if (state.phase == ProcedurePhase.DONE) stringResource(R.string.done_says) else spoken(state.instruction)

private fun silence(channel: Channel): Int =
    if (channel == Channel.ACCELEROMETER) R.string.sensor_stopped_accelerometer else R.string.sensor_stopped_gyroscope

@Composable
private fun Working(share: Double?) {
    val bar = Modifier.fillMaxWidth().height(16.dp)
    if (share == null) return LinearProgressIndicator(bar)
    LinearProgressIndicator({ share.toFloat() }, bar)
    Text(stringResource(R.string.percent_done, 100 * share), style = MaterialTheme.typography.titleLarge)
}
