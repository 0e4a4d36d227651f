package org.gyradius.app.ui

import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.res.stringResource
import org.gyradius.app.R

/** What this is, whose it is, and which versions. */
@Composable
fun AboutScreen(appVersion: String, libraryVersion: String, onBack: () -> Unit) = Page {
    TopBar(stringResource(R.string.about), onBack, R.string.back)
    TwoColumns({
        Text(stringResource(R.string.about_says), style = MaterialTheme.typography.bodyLarge)
        Figure(stringResource(R.string.version_app), appVersion)
        Figure(stringResource(R.string.version_library), libraryVersion)
    }) {
        SectionHead(stringResource(R.string.licences))
        Text(stringResource(R.string.licences_says), style = MaterialTheme.typography.bodyLarge)
    }
}
