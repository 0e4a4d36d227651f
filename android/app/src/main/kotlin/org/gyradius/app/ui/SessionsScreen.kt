package org.gyradius.app.ui

import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.safeDrawingPadding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import org.gyradius.app.R

/** Where the app begins. */
@Composable
fun SessionsScreen(error: String?, onMeasure: () -> Unit, onPractise: () -> Unit) {
    Stack(Modifier.safeDrawingPadding().verticalScroll(rememberScrollState()).padding(16.dp)) {
        Text(
            stringResource(R.string.sessions),
            Modifier.semantics { heading() },
            style = MaterialTheme.typography.headlineLarge,
        )
        Text(stringResource(R.string.sessions_none), style = MaterialTheme.typography.bodyLarge)
        error?.let { Advice(it) }
        WideButton(stringResource(R.string.measure), onClick = onMeasure)
        WideButton(stringResource(R.string.practise), isMain = false, onClick = onPractise)
    }
}
