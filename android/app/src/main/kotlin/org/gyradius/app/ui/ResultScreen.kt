package org.gyradius.app.ui

import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.material3.LinearProgressIndicator
import androidx.compose.material3.Text
import androidx.compose.material3.MaterialTheme
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.saveable.rememberSaveable
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.res.stringResource
import org.gyradius.RecordingFigureData
import org.gyradius.app.R
import org.gyradius.app.result.ResultShown

/** What can be done with a result. */
class ResultDeeds(
    val judge: (limits: List<String>) -> Unit,
    val criticise: () -> Unit,
    val share: () -> Unit,
    val print: () -> Unit,
    val leave: () -> Unit,
)

/** The whole result of a session: figures, verdicts, criticism, report. */
@Composable
fun ResultScreen(shown: ResultShown, deeds: ResultDeeds) = Page {
    TopBar(stringResource(R.string.phase_done), deeds.leave, R.string.back) { HelpButton(R.string.help_result) }
    shown.error?.let { Advice(spoken(it), Tone.WRONG) }
    shown.share?.let { share -> LinearProgressIndicator({ share.toFloat() }, Modifier.fillMaxWidth()) }
    Text(shown.title, style = MaterialTheme.typography.titleLarge)
    TwoColumns({ Measured(shown, deeds) }) { Criticised(shown, deeds) }
}

@Composable
private fun Measured(shown: ResultShown, deeds: ResultDeeds) {
    val result = shown.result ?: return
    result.verdicts.forEach { VerdictCard(it) }
    Quantities(result.quantities)
    result.warnings.forEach { Advice(spoken(it)) }
    WideButton(stringResource(R.string.report_share), onClick = deeds.share)
    WideButton(stringResource(R.string.report_print), isMain = false, onClick = deeds.print)
    Fold(R.string.class_limits) { Judge(shown.limits, deeds.judge) }
    Ellipsoid(result.quantities)
    ResultDetails(result)
}

@Composable
private fun Judge(kept: List<String>, onJudge: (List<String>) -> Unit) {
    var limits by rememberSaveable { mutableStateOf(ArrayList(kept.mapNotNull(LimitTyped::of))) }
    Limits(limits) { limits = ArrayList(it) }
    // Where the last one was taken away, too, there is something to judge anew.
    if (limits.isNotEmpty() || kept.isNotEmpty()) WideButton(stringResource(R.string.limit_judge)) { onJudge(limits.mapNotNull { it.text() }) }
}

@Composable
private fun Criticised(shown: ResultShown, deeds: ResultDeeds) {
    val critique = shown.critique
    if (critique != null) {
        CritiqueBody(critique, shown.compared)
    } else if (shown.result != null) {
        SectionHead(stringResource(R.string.criticism))
        Text(stringResource(R.string.criticise_says), style = MaterialTheme.typography.bodyLarge)
        WideButton(stringResource(R.string.criticise), isMain = false, isEnabled = shown.share == null, onClick = deeds.criticise)
    }
    if (shown.recordings.isNotEmpty()) Fold(R.string.recordings) { shown.recordings.forEach { Recorded(it) } }
}

@Composable
private fun Recorded(one: RecordingFigureData) {
    Text(idName(one.id), style = MaterialTheme.typography.titleMedium)
    for (trace in one.traces) {
        Text(trace.label, style = MaterialTheme.typography.bodyLarge)
        val near = trace.closeUp
        val drawn = listOf(Drawn(R.string.curve_measured, near?.measured ?: trace.measured), Drawn(R.string.curve_fit, near?.model ?: trace.model, isThin = true))
        CurvePlot(R.string.fit_says, drawn, trace.unit)
        CurvePlot(R.string.residual_says, listOf(Drawn(R.string.curve_residual, trace.residual, isThin = true)), trace.unit)
    }
}
