package org.gyradius.app.result

import androidx.lifecycle.ViewModel
import androidx.lifecycle.viewModelScope
import java.io.File
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
import org.gyradius.RecordingFigureData
import org.gyradius.Session
import org.gyradius.app.store.Measurable
import org.gyradius.critique
import org.gyradius.loadSession
import org.gyradius.measure
import org.gyradius.reportHtml
import org.gyradius.text

/** What a result's screen shows. */
data class ResultShown(
    val title: String = "",
    val result: InertiaResult? = null,
    val recordings: List<RecordingFigureData> = emptyList(),
    val critique: Critique? = null,
    /** Only of a criticism made just now; one that was kept has no curves. */
    val compared: List<ComparedSwing> = emptyList(),
    /** How much of the work under way is done, 0 to 1. */
    val share: Double? = null,
    val error: String? = null,
)

/** A session that was measured: its result, its criticism, its report. */
class ResultModel : ViewModel() {
    private val flow = MutableStateFlow<ResultShown?>(null)
    private var session: Session? = null
    private var analysis: Analysis? = null
    private var criticism: Criticism? = null
    private var working: Job? = null

    /** What the screen shows; absent while no result is open. */
    val shown: StateFlow<ResultShown?> = flow.asStateFlow()

    /** Reads a session, measures it, and takes the criticism that was kept, if there is one. */
    fun open(found: Measurable) {
        flow.value = ResultShown(found.title, share = 0.0)
        work {
            session = loadSession(found.session)
            criticism = withContext(Dispatchers.IO) { found.critique.takeIf { it.exists() }?.readText() }?.let(Criticism::fromJson)
            show { it.copy(critique = criticism?.result()) }
            measure(found.limits)
        }
    }

    /** Leaves it. */
    fun close() {
        working?.cancel()
        flow.value = null
    }

    /** Measures again, with verdicts on other limits. */
    fun judge(limits: List<String>) = work { measure(limits) }

    /** Looks for what the simulation gets wrong: minutes. */
    fun criticise() = work {
        val found = session?.critique(::tell) ?: return@work
        criticism = found
        show { it.copy(critique = found.result(), compared = found.compared()) }
    }

    /** Writes the report into a folder and hands over its file. */
    fun report(folder: File, then: (File) -> Unit) = work {
        val html = analysis?.reportHtml(criticism) ?: return@work
        then(withContext(Dispatchers.IO) { File(folder.apply { mkdirs() }, "report.html").apply { writeText(html) } })
    }

    private suspend fun measure(limits: List<String>) {
        val found = session?.measure(limits, ::tell) ?: return
        analysis = found
        show { it.copy(result = found.result(), recordings = found.recordings()) }
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
                show { it.copy(error = wrong.text) }
            }
            show { it.copy(share = null) }
        }
    }
}
