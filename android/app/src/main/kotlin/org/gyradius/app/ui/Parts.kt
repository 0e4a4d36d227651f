package org.gyradius.app.ui

import androidx.annotation.StringRes
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ColumnScope
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.Button
import androidx.compose.material3.ButtonDefaults
import androidx.compose.material3.Card
import androidx.compose.material3.CardDefaults
import androidx.compose.material3.FilterChip
import androidx.compose.material3.FilterChipDefaults
import androidx.compose.material3.Icon
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.OutlinedButton
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.saveable.rememberSaveable
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.rotate
import androidx.compose.ui.graphics.SolidColor
import androidx.compose.ui.res.painterResource
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.stateDescription
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.unit.dp
import org.gyradius.app.R

/** A button for wet hands: the whole width, and high. */
@Composable
fun WideButton(text: String, isMain: Boolean = true, isEnabled: Boolean = true, onClick: () -> Unit) {
    val modifier = Modifier.fillMaxWidth().heightIn(min = 64.dp)
    val label: @Composable () -> Unit = {
        Text(text, style = MaterialTheme.typography.titleLarge, textAlign = TextAlign.Center)
    }
    if (isMain) return Button(onClick, modifier, isEnabled) { label() }
    // The usual rim is hardly seen in the sun.
    val rim = ButtonDefaults.outlinedButtonBorder(isEnabled).copy(brush = SolidColor(MaterialTheme.colorScheme.outline))
    OutlinedButton(onClick, modifier, isEnabled, border = rim) { label() }
}

/** One of some choices; the chosen one stands out on every ground. */
@Composable
fun Chip(text: String, isChosen: Boolean, onChoice: () -> Unit) {
    val scheme = MaterialTheme.colorScheme
    val colours = FilterChipDefaults.filterChipColors(selectedContainerColor = scheme.primary, selectedLabelColor = scheme.onPrimary)
    val rim = FilterChipDefaults.filterChipBorder(enabled = true, isChosen, borderColor = scheme.outline)
    FilterChip(isChosen, onChoice, { Text(text) }, Modifier.heightIn(min = 56.dp), colors = colours, border = rim)
}

/** Choices beside each other, and in further rows where there is no room. */
@Composable
fun Chips(content: @Composable () -> Unit) {
    FlowRow(horizontalArrangement = Arrangement.spacedBy(8.dp), verticalArrangement = Arrangement.spacedBy(8.dp)) { content() }
}

/** A figure and what it is; read as one by a screen reader. */
@Composable
fun Figure(label: String, value: String, modifier: Modifier = Modifier) {
    Column(modifier.fillMaxWidth().semantics(mergeDescendants = true) {}) {
        Text(label, style = MaterialTheme.typography.labelLarge, color = MaterialTheme.colorScheme.onSurfaceVariant)
        Text(value, style = MaterialTheme.typography.headlineMedium, fontWeight = FontWeight.SemiBold)
    }
}

/** How grave a message is. */
enum class Tone { INFO, CAUTION, WRONG }

/** What must be done or known now: large, and told aloud by a screen reader as it changes. */
@Composable
fun Advice(text: String, tone: Tone = Tone.CAUTION) {
    Panel(tone, Modifier.semantics { liveRegion = LiveRegionMode.Polite }) {
        Text(text, style = MaterialTheme.typography.titleLarge)
    }
}

/** A card in the colour of its tone. */
@Composable
fun Panel(tone: Tone, modifier: Modifier = Modifier, content: @Composable ColumnScope.() -> Unit) {
    val scheme = MaterialTheme.colorScheme
    val (ground, ink) = when (tone) {
        Tone.INFO -> scheme.secondaryContainer to scheme.onSecondaryContainer
        Tone.CAUTION -> scheme.tertiaryContainer to scheme.onTertiaryContainer
        Tone.WRONG -> scheme.errorContainer to scheme.onErrorContainer
    }
    Card(modifier.fillMaxWidth(), colors = CardDefaults.cardColors(containerColor = ground, contentColor = ink)) {
        Column(Modifier.padding(16.dp), Arrangement.spacedBy(8.dp), content = content)
    }
}

/** Things below each other. */
@Composable
fun Stack(modifier: Modifier = Modifier, content: @Composable ColumnScope.() -> Unit) {
    Column(modifier.fillMaxWidth(), Arrangement.spacedBy(16.dp), content = content)
}

/** The head of a part of a screen. */
@Composable
fun SectionHead(text: String, modifier: Modifier = Modifier) {
    Text(text, modifier.semantics { heading() }, style = MaterialTheme.typography.titleLarge, fontWeight = FontWeight.SemiBold)
}

/** A part that is folded away until it is asked for. */
@Composable
fun Fold(@StringRes title: Int, isOpenAtFirst: Boolean = false, content: @Composable ColumnScope.() -> Unit) {
    var isOpen by rememberSaveable(title) { mutableStateOf(isOpenAtFirst) }
    val state = stringResource(if (isOpen) R.string.open else R.string.folded)
    Column {
        Row(
            Modifier
                .fillMaxWidth()
                .clickable(role = Role.Button) { isOpen = !isOpen }
                .heightIn(min = 56.dp)
                .semantics { stateDescription = state },
            Arrangement.spacedBy(8.dp),
            Alignment.CenterVertically,
        ) {
            SectionHead(stringResource(title), Modifier.weight(1f))
            Icon(painterResource(R.drawable.ic_fold), null, Modifier.rotate(if (isOpen) 180f else 0f))
        }
        if (isOpen) Stack(Modifier.padding(bottom = 16.dp), content)
    }
}
