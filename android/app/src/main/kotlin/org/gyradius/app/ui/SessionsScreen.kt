package org.gyradius.app.ui

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.PaddingValues
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.items
import androidx.compose.material3.Card
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Scaffold
import androidx.compose.material3.SnackbarDuration
import androidx.compose.material3.SnackbarHost
import androidx.compose.material3.SnackbarHostState
import androidx.compose.material3.SnackbarResult
import androidx.compose.material3.Text
import androidx.compose.material3.TextButton
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.res.stringResource
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import java.time.ZoneId
import java.time.format.DateTimeFormatter
import java.time.format.FormatStyle
import org.gyradius.NamedQuantity
import org.gyradius.app.Failure
import org.gyradius.app.R
import org.gyradius.app.store.Listed
import org.gyradius.app.store.Sessions
import org.gyradius.number
import org.gyradius.unitOf

/** What can be done in the list of sessions. */
interface SessionActions {
    fun measure()
    fun about()
    fun practise()
    fun goOnPractising()
    fun import()

    /** Shows what was measured. */
    fun open(session: Listed)

    /** Goes on with the procedure. */
    fun goOn(session: Listed)
    fun share(session: Listed)
    fun delete(session: Listed)
    fun undo()
    fun forget(session: Listed)
}

/** Where the app begins. */
@Composable
fun SessionsScreen(sessions: Sessions, error: Failure?, on: SessionActions) {
    val snackbar = remember { SnackbarHostState() }
    Undoing(sessions.deleted, snackbar, on)
    Scaffold(snackbarHost = { SnackbarHost(snackbar) }) { inner ->
        LazyColumn(
            Modifier.testTag("sessions").padding(inner).fillMaxWidth(),
            horizontalAlignment = Alignment.CenterHorizontally,
            contentPadding = PaddingValues(16.dp),
            verticalArrangement = Arrangement.spacedBy(16.dp),
        ) {
            item { Beginning(sessions, listOfNotNull(error, sessions.error), on) }
            items(sessions.listed, key = { it.folder.name }) { SessionCard(it, on) }
        }
    }
}

@Composable
private fun Beginning(sessions: Sessions, errors: List<Failure>, on: SessionActions) = Stack(Modifier.widthIn(max = MOST_WIDTH)) {
    TopBar(stringResource(R.string.sessions), onBack = null, back = R.string.back) {
        BarButton(R.drawable.ic_info, R.string.about, on::about)
    }
    errors.forEach { Advice(spoken(it)) }
    WideButton(stringResource(R.string.measure), onClick = on::measure)
    if (sessions.isPracticeLeft) {
        WideButton(stringResource(R.string.practice_go_on), isMain = false, onClick = on::goOnPractising)
    }
    WideButton(stringResource(R.string.practise), isMain = false, onClick = on::practise)
    WideButton(stringResource(R.string.sessions_import), isMain = false, onClick = on::import)
    if (sessions.listed.isEmpty()) {
        Text(stringResource(R.string.sessions_none), style = MaterialTheme.typography.bodyLarge)
    }
}

@Composable
private fun SessionCard(session: Listed, on: SessionActions) = Card(Modifier.widthIn(max = MOST_WIDTH).fillMaxWidth()) {
    Column(Modifier.padding(16.dp), Arrangement.spacedBy(4.dp)) {
        Text(titleOf(session), Modifier.semantics { heading() }, style = MaterialTheme.typography.titleLarge)
        Text(dateOf(session), style = MaterialTheme.typography.bodyMedium)
        Text(standing(session), style = MaterialTheme.typography.bodyLarge)
        session.figures.inOrder { it.name }.forEach { Text(figure(it), style = MaterialTheme.typography.titleMedium) }
        FlowRow {
            if (session.canBeOpened) Choice(R.string.session_open) { on.open(session) }
            if (session.phase != null) Choice(R.string.session_go_on) { on.goOn(session) }
            Choice(R.string.session_share) { on.share(session) }
            Choice(R.string.session_delete) { on.delete(session) }
        }
    }
}

private val Listed.canBeOpened: Boolean
    get() = damage == null && (phase == null || figures.isNotEmpty())

@Composable
private fun Choice(text: Int, onClick: () -> Unit) =
    TextButton(onClick, Modifier.heightIn(min = 56.dp)) {
        Text(stringResource(text), style = MaterialTheme.typography.titleMedium)
    }

/** Offers to put back what was taken off the list; what is not wanted back goes. */
@Composable
private fun Undoing(deleted: Listed?, snackbar: SnackbarHostState, on: SessionActions) {
    val gone = deleted ?: return
    val message = stringResource(R.string.session_deleted, titleOf(gone))
    val undo = stringResource(R.string.undo)
    LaunchedEffect(gone) {
        when (snackbar.showSnackbar(message, undo, duration = SnackbarDuration.Long)) {
            SnackbarResult.ActionPerformed -> on.undo()
            SnackbarResult.Dismissed -> on.forget(gone)
        }
    }
}

@Composable
private fun titleOf(session: Listed) = session.title.ifBlank { stringResource(R.string.session_untitled) }

@Composable
private fun standing(session: Listed): String {
    val damage = session.damage
    val phase = session.phase
    return when {
        damage != null -> stringResource(R.string.session_damaged, damage)
        phase != null -> stringResource(title(phase))
        else -> stringResource(R.string.session_from_file)
    }
}

@Composable
private fun figure(one: NamedQuantity): String {
    val unit = unitOf(one.name)
    val (value, u) = withUncertainty(one.quantity.value.number ?: 0.0, one.quantity.u.number ?: 0.0)
    return quantityName(one.name) + ": " + inUnit(R.string.quantity_u, value, u, unit)
}

/** In the language that the phone speaks now. */
private fun dateOf(session: Listed): String =
    DateTimeFormatter.ofLocalizedDateTime(FormatStyle.MEDIUM, FormatStyle.SHORT).format(session.at.atZone(ZoneId.systemDefault()))

/** Buttons and cards wider than this look lost on a tablet. */
private val MOST_WIDTH = 720.dp
