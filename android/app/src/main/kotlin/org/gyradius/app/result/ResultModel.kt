package org.gyradius.app.result

import androidx.lifecycle.ViewModel
import androidx.lifecycle.viewModelScope
import java.io.File
import java.io.IOException
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.Job
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.flow.asStateFlow
import kotlinx.coroutines.flow.update
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import org.gyradius.Analysis
import org.gyradius.ComparedSwing
import org.gyradius.Criticism
import org.gyradius.Critique
import org.gyradius.GyradiusException
import org.gyradius.InertiaResult
import org.gyradius.Language
import org.gyradius.RecordingFigureData
import org.gyradius.Session
import org.gyradius.app.Failure
import org.gyradius.app.failureOf
import org.gyradius.app.store.Measurable
import org.gyradius.app.store.SessionStore
import org.gyradius.critique
import org.gyradius.keptCriticism
import org.gyradius.loadSession
import org.gyradius.measure
import org.gyradius.reportHtml

/** What a result's screen shows. */
data class ResultShown(
    val title: String = "",
    val result: InertiaResult? = null,
    val recordings: List<RecordingFigureData> = emptyList(),
    /** Class limits that it is judged by. */
    val limits: List<String> = emptyList(),
    val critique: Critique? = null,
    /** Measured against simulated, by swing. */
    val compared: List<ComparedSwing> = emptyList(),
    /** How much of the work under way is done, 0 to 1. */
    val share: Double? = null,
    val error: Failure? = null,
)

/** A session that was measured: its result, its criticism, its report. */
class ResultModel(private val store: SessionStore) : ViewModel() {
    private val flow = MutableStateFlow<ResultShown?>(null)
    private var opened: Measurable? = null
    private var session: Session? = null
    private var analysis: Analysis? = null
    private var criticism: Criticism? = null
    private var language = Language.ENGLISH
    private var working: Job? = null

    /** What the screen shows; absent while no result is open. */
    val shown: StateFlow<ResultShown?> = flow.asStateFlow()

    /** Reads a session, measures it, and takes the criticism that was kept; channels have names in a language. */
    fun open(found: Measurable, language: Language) {
        this.language = language
        flow.value = ResultShown(found.title, limits = found.limits, share = 0.0)
        opened = found
        session = null
        analysis = null
        criticism = null
        work {
            session = loadSession(found.session)
            withContext(Dispatchers.IO) { keptCriticism(found.folder.path) }?.let(::show)
            measure(found.limits)
        }
    }

    /** Leaves it. */
    fun close() {
        working?.cancel()
        flow.value = null
    }

    /** Measures again, with verdicts on other limits, which are kept. */
    fun judge(limits: List<String>) = work {
        measure(limits)
        withContext(Dispatchers.IO) { opened?.let { store.keepLimits(it.folder, limits) } }
        show { it.copy(limits = limits) }
    }

    /** Looks for what the simulation gets wrong: minutes. */
    fun criticise() = work {
        val found = session?.critique(::tell) ?: return@work
        show(found)
        withContext(Dispatchers.IO) { opened?.let { found.keep(it.folder.path) } }
    }

    /** Writes the report in a language into a folder and hands over its file. */
    fun report(folder: File, language: Language, then: (File) -> Unit) = work {
        val html = analysis?.reportHtml(criticism, language = language) ?: return@work
        then(withContext(Dispatchers.IO) { File(folder.apply { mkdirs() }, "report.html").apply { writeText(html) } })
    }

    private suspend fun measure(limits: List<String>) {
        val found = session?.measure(limits, ::tell) ?: return
        analysis = found
        val result = criticism?.let(found::judged) ?: found.result()
        show { it.copy(result = result, recordings = found.recordings(language)) }
    }

    private fun show(found: Criticism) {
        criticism = found
        val judged = analysis?.judged(found)
        show { it.copy(result = judged ?: it.result, critique = found.result(), compared = found.compared()) }
    }

    private fun show(change: (ResultShown) -> ResultShown) = flow.update { it?.let(change) }

    private fun tell(share: Double, @Suppress("UNUSED_PARAMETER") doing: String) = show { it.copy(share = share) }

    private fun work(what: suspend () -> Unit) {
        working?.cancel()
        working = viewModelScope.launch {
            show { it.copy(error = null) }
            try {
                what()
            } catch (wrong: GyradiusException) {
                show { it.copy(error = failureOf(wrong)) }
            } catch (wrong: IOException) {
                show { it.copy(error = failureOf(wrong)) }
            }
            show { it.copy(share = null) }
        }
    }
}
