package org.gyradius.app.ui

import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.safeDrawingPadding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
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
import org.gyradius.ModeResult
import org.gyradius.ResultView
import org.gyradius.app.R
import org.gyradius.app.store.Read

/** A session that came from a file: its figures. A bare recording has periods alone. */
@Composable
fun ReadScreen(read: Read, onLeave: () -> Unit) {
    Stack(Modifier.safeDrawingPadding().verticalScroll(rememberScrollState()).padding(16.dp)) {
        TextButton(onLeave) { Text(stringResource(R.string.back)) }
        Text(read.title, Modifier.semantics { heading() }, style = MaterialTheme.typography.headlineLarge)
        read.error?.let { Advice(it) }
        val result = read.result
        if (result != null) {
            ResultBody(ResultView(read.title, result.quantities, result.warnings))
            result.swings.forEach { swing -> swing.modes.forEach { Mode(swing.id, it) } }
        } else if (read.error == null) {
            Progress(read.share)
        }
    }
}

@Composable
private fun Progress(share: Double?) =
    if (share == null) LinearProgressIndicator() else LinearProgressIndicator({ share.toFloat() })

@Composable
private fun Mode(swing: String, mode: ModeResult) {
    val (period, u) = withUncertainty(mode.periodS, mode.periodSeS)
    Figure("$swing · ${mode.mode.name.lowercase()}", stringResource(R.string.seconds_u, period, u))
}
