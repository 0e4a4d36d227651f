package org.gyradius.app.ui

import androidx.compose.foundation.layout.heightIn
import androidx.compose.material3.AlertDialog
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Text
import androidx.compose.material3.TextButton
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.unit.dp
import org.gyradius.app.R

/** Why the app would like to show a notification, before the system asks. */
@Composable
fun NoticeDialog(onAllow: () -> Unit, onRefuse: () -> Unit) = AlertDialog(
    onDismissRequest = onRefuse,
    confirmButton = { TextButton(onAllow, Modifier.heightIn(min = 56.dp)) { Text(stringResource(R.string.notice_allow)) } },
    dismissButton = { TextButton(onRefuse, Modifier.heightIn(min = 56.dp)) { Text(stringResource(R.string.notice_refuse)) } },
    title = { Text(stringResource(R.string.notice_why_title)) },
    text = { Text(stringResource(R.string.notice_why), style = MaterialTheme.typography.bodyLarge) },
)
