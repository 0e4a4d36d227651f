package org.gyradius.app.ui

import androidx.annotation.StringRes
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.AlertDialog
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Text
import androidx.compose.material3.TextButton
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.saveable.rememberSaveable
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.unit.dp
import org.gyradius.app.R

/** Explains the screen that it stands on. */
@Composable
fun HelpButton(@StringRes text: Int) {
    var isOpen by rememberSaveable(text) { mutableStateOf(false) }
    BarButton(R.drawable.ic_help, R.string.help) { isOpen = true }
    if (!isOpen) return
    AlertDialog(
        onDismissRequest = { isOpen = false },
        confirmButton = { TextButton({ isOpen = false }, Modifier.heightIn(min = 56.dp)) { Text(stringResource(R.string.close)) } },
        title = { Text(stringResource(R.string.help)) },
        text = {
            Text(stringResource(text), Modifier.verticalScroll(rememberScrollState()), style = MaterialTheme.typography.bodyLarge)
        },
    )
}

/** Says that nothing of this is real, and lets simulated time go by faster. */
@Composable
fun PracticeBanner(pace: Int, onPace: (Int) -> Unit) {
    Panel(Tone.INFO) {
        FlowRow(
            horizontalArrangement = Arrangement.spacedBy(16.dp),
            verticalArrangement = Arrangement.spacedBy(8.dp),
            itemVerticalAlignment = Alignment.CenterVertically,
        ) {
            Text(stringResource(R.string.practice_banner), style = MaterialTheme.typography.titleMedium)
            Row(horizontalArrangement = Arrangement.spacedBy(8.dp)) {
                for (one in PACES) Chip("$one×", one == pace) { onPace(one) }
            }
        }
    }
}

/** Simulated seconds in a real one. */
private val PACES = listOf(1, 10, 60)
