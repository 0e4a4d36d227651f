package org.gyradius.app.store

import androidx.lifecycle.ViewModel
import androidx.lifecycle.viewModelScope
import java.io.File
import kotlinx.coroutines.Job
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.flow.asStateFlow
import kotlinx.coroutines.flow.update
import kotlinx.coroutines.launch
import org.gyradius.GyradiusException
import org.gyradius.InertiaResult
import org.gyradius.loadSession
import org.gyradius.measure
import org.gyradius.text

/** What is known of a file that came from elsewhere. */
data class Read(
    val title: String = "",
    val share: Double? = null,
    val result: InertiaResult? = null,
    val error: String? = null,
)

/** A session that was recorded elsewhere, measured here. */
class ReadModel : ViewModel() {
    private val flow = MutableStateFlow<Read?>(null)
    private var reading: Job? = null

    /** What is known of it; absent while none is open. */
    val read: StateFlow<Read?> = flow.asStateFlow()

    /** Reads and measures a file. */
    fun open(file: File, title: String) {
        flow.value = Read(title)
        reading = viewModelScope.launch {
            try {
                val result = measured(file)
                flow.update { it?.copy(result = result) }
            } catch (wrong: GyradiusException) {
                flow.update { it?.copy(error = wrong.text) }
            }
        }
    }

    /** Leaves it. */
    fun close() {
        reading?.cancel()
        flow.value = null
    }

    private suspend fun measured(file: File): InertiaResult = loadSession(file).use { session ->
        session.measure { share, _ -> flow.update { it?.copy(share = share) } }.use { it.result() }
    }
}
