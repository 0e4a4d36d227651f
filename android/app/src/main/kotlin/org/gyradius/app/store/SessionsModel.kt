package org.gyradius.app.store

import android.content.ContentResolver
import android.net.Uri
import android.provider.OpenableColumns
import androidx.lifecycle.ViewModel
import androidx.lifecycle.viewModelScope
import java.io.File
import java.io.IOException
import kotlinx.coroutines.Job
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.flow.asStateFlow
import kotlinx.coroutines.flow.update
import kotlinx.coroutines.launch
import org.gyradius.GyradiusException
import org.gyradius.app.Failure
import org.gyradius.app.failureOf

/** What the list of sessions shows. */
data class Sessions(
    val listed: List<Listed> = emptyList(),
    val isPracticeLeft: Boolean = false,
    /** Taken off the list; its files are there until nobody can want them back. */
    val deleted: Listed? = null,
    val error: Failure? = null,
)

/** The list of sessions and what can be done with them. */
class SessionsModel(private val store: SessionStore, private val resolver: ContentResolver) : ViewModel() {
    private val flow = MutableStateFlow(Sessions())
    private var reading: Job? = null

    /** What the list shows. */
    val sessions: StateFlow<Sessions> = flow.asStateFlow()

    /** Reads the folders anew; what is still being read is out of date. */
    fun refresh() {
        reading?.cancel()
        reading = viewModelScope.launch { reread() }
    }

    /** Takes a session off the list. An earlier one that was taken off is removed for good. */
    fun delete(session: Listed) {
        val before = flow.value.deleted
        flow.update { it.copy(deleted = session, listed = it.listed - session) }
        viewModelScope.launch { before?.let { store.remove(it.folder) } }
    }

    /** Puts it back. */
    fun undo() {
        flow.update { it.copy(deleted = null) }
        refresh()
    }

    /** Nobody wanted it back: its files go. */
    fun forget(session: Listed) {
        flow.update { if (it.deleted == session) it.copy(deleted = null) else it }
        viewModelScope.launch { store.remove(session.folder) }
    }

    /** Takes in a file that the operator chose. */
    fun import(uri: Uri) = attempt {
        val name = nameOf(uri)
        val content = resolver.openInputStream(uri) ?: throw IOException(name)
        content.use { store.import(name, it) }
        refresh()
    }

    /** Packs a session and hands the zip on. */
    fun share(session: Listed, onPacked: (File) -> Unit) = attempt {
        onPacked(store.share(session))
    }

    private suspend fun reread() {
        val listed = store.list()
        val isPracticeLeft = store.isPracticeLeft()
        flow.update { it.copy(listed = listed.filter { one -> one.folder != it.deleted?.folder }, isPracticeLeft = isPracticeLeft) }
    }

    private fun attempt(what: suspend () -> Unit) {
        viewModelScope.launch {
            flow.update { it.copy(error = null) }
            try {
                what()
            } catch (wrong: GyradiusException) {
                flow.update { it.copy(error = failureOf(wrong)) }
            } catch (wrong: IOException) {
                flow.update { it.copy(error = failureOf(wrong)) }
            }
        }
    }

    private fun nameOf(uri: Uri): String {
        val cursor = resolver.query(uri, arrayOf(OpenableColumns.DISPLAY_NAME), null, null, null)
        val told = cursor?.use { if (it.moveToFirst()) it.getString(0) else null }
        return told ?: uri.lastPathSegment?.substringAfterLast('/') ?: "import"
    }
}
