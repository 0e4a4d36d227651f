package org.gyradius.app.ui

import androidx.annotation.DrawableRes
import androidx.annotation.StringRes
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.RowScope
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.safeDrawingPadding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.Icon
import androidx.compose.material3.IconButton
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.res.painterResource
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import org.gyradius.app.R

/** A screen that scrolls as a whole, so that nothing is out of reach at any size of type. */
@Composable
fun Page(content: @Composable () -> Unit) {
    Stack(Modifier.fillMaxSize().safeDrawingPadding().verticalScroll(rememberScrollState()).padding(16.dp)) { content() }
}

/** The head of a screen: the way back, its name, and what is always at hand. */
@Composable
fun TopBar(title: String, onBack: (() -> Unit)?, @StringRes back: Int, more: @Composable RowScope.() -> Unit = {}) {
    Row(Modifier.fillMaxWidth(), verticalAlignment = Alignment.CenterVertically) {
        onBack?.let { BarButton(R.drawable.ic_back, back, it) }
        Text(
            title,
            Modifier.weight(1f).padding(horizontal = 8.dp).semantics { heading() },
            style = MaterialTheme.typography.headlineMedium,
            fontWeight = FontWeight.SemiBold,
        )
        more()
    }
}

/** A picture to touch in the head of a screen. */
@Composable
fun BarButton(@DrawableRes picture: Int, @StringRes says: Int, onClick: () -> Unit) {
    IconButton(onClick, Modifier.size(56.dp)) {
        Icon(painterResource(picture), stringResource(says), Modifier.size(28.dp))
    }
}

/** Two columns where there is room for both, else one below the other. */
@Composable
fun TwoColumns(first: @Composable () -> Unit, second: @Composable () -> Unit) {
    BoxWithConstraints(Modifier.fillMaxWidth()) {
        if (maxWidth < WIDE) {
            Stack { first(); second() }
        } else {
            Row(horizontalArrangement = Arrangement.spacedBy(32.dp)) {
                Stack(Modifier.weight(1f).widthIn(max = MOST)) { first() }
                Stack(Modifier.weight(1f).widthIn(max = MOST)) { second() }
            }
        }
    }
}

/** From this width on, two columns. */
private val WIDE = 720.dp

/** Lines longer than this are hard to read. */
private val MOST = 640.dp
