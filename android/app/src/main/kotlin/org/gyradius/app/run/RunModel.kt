package org.gyradius.app.run

import androidx.lifecycle.ViewModel
import androidx.lifecycle.viewModelScope
import java.io.File
import java.time.Instant
import kotlinx.coroutines.CoroutineDispatcher
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.Job
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.flow.asStateFlow
import kotlinx.coroutines.flow.update
import kotlinx.coroutines.isActive
import kotlinx.coroutines.launch
import org.gyradius.GyradiusException
import org.gyradius.PhoneInfo
import org.gyradius.PhoneSensor
import org.gyradius.Placement
import org.gyradius.Procedure
import org.gyradius.ProcedureEvent
import org.gyradius.ProcedureState
import org.gyradius.ProcedureTask
import org.gyradius.Rehearsal
import org.gyradius.Rig
import org.gyradius.text

/** What the screens show. */
data class Shown(
    val state: ProcedureState? = null,
    val trace: List<Trace.Point> = emptyList(),
    val isPractice: Boolean = false,
    /** Simulated seconds that go by in one; only in practice. */
    val pace: Int = 1,
    val workShare: Double? = null,
    val error: String? = null,
)

/** The procedure under way, kept over a turn of the screen. One thread at a time touches the library. */
class RunModel(
    private val clock: () -> Instant = Instant::now,
    dispatcher: CoroutineDispatcher = Dispatchers.Default,
) : ViewModel() {
    private val oneByOne = dispatcher.limitedParallelism(1)
    private val flow = MutableStateFlow(Shown())
    private var run: Run? = null
    private var feeding: Job? = null
    private var working: Job? = null

    /** The phone's sensors, once a measurement listens to them. */
    var sensors: List<PhoneSensor> = emptyList()
        private set

    /** What the screens show. */
    val shown: StateFlow<Shown> = flow.asStateFlow()

    /** Begins or goes on with practice in a folder. */
    fun practise(folder: File, rigText: String, seed: ULong) = begin(isPractice = true) {
        val rig = Rig.parse(rigText, "practice")
        val known = File(folder, JOURNAL).exists()
        Practising(if (known) Rehearsal.open(folder.path, rig, seed) else Rehearsal.create(folder.path, rig, seed))
    }.also { feeding = viewModelScope.launch(oneByOne) { letTimeGoBy() } }

    /** Begins or goes on with a measurement in a folder, on what a source gives. */
    fun measure(folder: File, task: ProcedureTask, source: MotionSource) = begin(isPractice = false) {
        val known = File(folder, JOURNAL).exists()
        Measuring(if (known) Procedure.open(folder.path) else Procedure.create(folder.path, task))
    }.also { feeding = viewModelScope.launch(oneByOne) { listen(source) } }

    /** Begins, phone and placement told. */
    fun start(phone: PhoneInfo, placement: Placement) = handle(ProcedureEvent.Begin(utc(), phone, placement))

    /** The recording begins. */
    fun record() = handle(ProcedureEvent.StartRecording(utc()))

    /** What an operator who plays by the book does now; only in practice, where it types in what the tape says. */
    fun byTheBook() = attempt { (run as? Practising)?.let { it.byTheBook(utc())?.let(it::handle) } }

    /** Takes what the operator did. */
    fun handle(event: ProcedureEvent) = attempt { run?.handle(event) }

    /** Lets simulated time go by faster or slower. */
    fun setPace(pace: Int) = flow.update { it.copy(pace = pace) }

    /** Leaves it; it is kept, and goes on where it stands. */
    fun leave() {
        listOfNotNull(feeding, working).forEach { it.cancel() }
        viewModelScope.launch(oneByOne) {
            run = null
            flow.value = Shown()
        }
    }

    private fun begin(isPractice: Boolean, make: () -> Run) {
        feeding?.cancel()
        viewModelScope.launch(oneByOne) {
            flow.value = Shown(isPractice = isPractice)
            guarded { run = make() }
            show()
        }
    }

    private suspend fun letTimeGoBy() {
        while (viewModelScope.isActive) {
            delay(FRAME_MS)
            val practising = run as? Practising ?: continue
            guarded { practising.advance(flow.value.pace * FRAME_MS / 1e3) }
            show()
        }
    }

    private suspend fun listen(source: MotionSource) {
        val trace = Trace()
        sensors = source.sensors
        source.samples().collect { samples ->
            trace.take(samples)
            guarded { (run as? Measuring)?.push(samples) }
            show(trace.points())
        }
    }

    private fun attempt(what: () -> Unit) {
        viewModelScope.launch(oneByOne) {
            flow.update { it.copy(error = null) }
            guarded(what)
            show()
        }
    }

    private fun guarded(what: () -> Unit) {
        try {
            what()
        } catch (wrong: GyradiusException) {
            flow.update { it.copy(error = wrong.text) }
        }
    }

    private fun show(trace: List<Trace.Point>? = null) {
        val state = run?.state() ?: return
        flow.update { it.copy(state = state, trace = trace ?: it.trace) }
        if (state.work != null && working?.isActive != true) work()
    }

    private fun work() {
        val busy = run ?: return
        working = viewModelScope.launch {
            try {
                busy.work { share, _ -> flow.update { it.copy(workShare = share) } }
            } catch (wrong: GyradiusException) {
                flow.update { it.copy(error = wrong.text) }
            }
            flow.update { it.copy(workShare = null) }
            attempt {}
        }
    }

    private fun utc(): String = clock().toString().substringBefore('.').removeSuffix("Z") + "Z"

    private companion object {
        const val JOURNAL = "procedure.journal"

        /** Between two looks at the simulated hull, ms. */
        const val FRAME_MS = 100L
    }
}
