package org.gyradius.app.run

import java.io.File
import java.time.Instant
import java.time.LocalDate
import java.time.ZoneId
import java.time.temporal.ChronoUnit
import kotlinx.coroutines.CoroutineDispatcher
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.Job
import kotlinx.coroutines.coroutineScope
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.flow.asStateFlow
import kotlinx.coroutines.flow.update
import kotlinx.coroutines.isActive
import kotlinx.coroutines.launch
import kotlinx.coroutines.sync.Mutex
import kotlinx.coroutines.sync.withLock
import org.gyradius.Channel
import org.gyradius.GyradiusException
import org.gyradius.PhoneInfo
import org.gyradius.PhoneSensor
import org.gyradius.Placement
import org.gyradius.ProcedureEvent
import org.gyradius.ProcedureState
import org.gyradius.ProcedureTask
import org.gyradius.ProcedureWork
import org.gyradius.app.Failure
import org.gyradius.app.failureOf

/** What the screens show. */
data class Shown(
    val state: ProcedureState? = null,
    val trace: List<Trace.Point> = emptyList(),
    val isPractice: Boolean = false,
    /** Where it is kept. */
    val folder: File? = null,
    /** Simulated seconds that go by in one; only in practice. */
    val pace: Int = 1,
    val workShare: Double? = null,
    /** The work that is wanted has failed, and waits for [RunModel.workAgain]. */
    val isWorkStuck: Boolean = false,
    /** Streams of the phone that have stopped. */
    val silent: Set<Channel> = emptySet(),
    val error: Failure? = null,
) {
    /** Whether the phone's sensors are listened to. */
    val isListening: Boolean
        get() = state != null && !isPractice
}

/** The procedure under way. It lives as long as the process: screens come and go while a hull swings. One thread at a time
 * touches the library, and never the main one. */
class RunModel(
    private val scope: CoroutineScope,
    private val clock: () -> Instant = Instant::now,
    dispatcher: CoroutineDispatcher = Dispatchers.Default,
) {
    private val oneByOne = dispatcher.limitedParallelism(1)
    private val flow = MutableStateFlow(Shown())

    /** From its beginning until it is closed; touched by [begin] and [leave] alone, on the main thread. */
    private var life: Job? = null

    /** Held from a run's opening to its closing: no two of them write into one folder. */
    private val closed = Mutex()

    // What follows is touched by `oneByOne` alone.
    private var run: Run? = null
    private val trace = Trace()
    private var working: Job? = null
    private var workBegun: ProcedureWork? = null

    /** The phone's sensors, once a measurement listens to them. */
    @Volatile
    var sensors: List<PhoneSensor> = emptyList()
        private set

    /** What the screens show. */
    val shown: StateFlow<Shown> = flow.asStateFlow()

    /** Goes on with the practice in a folder, or begins one there under a title. */
    fun practise(folder: File, rigText: String, title: String, seed: ULong) =
        begin(folder, isPractice = true) { Practising.of(folder, rigText, title, seed) }

    /** Begins a measurement in a folder, on what a source gives. */
    fun measure(folder: File, task: ProcedureTask, source: MotionSource) =
        begin(folder, isPractice = false) { Measuring.create(folder, task, source) }

    /** Goes on with the measurement in a folder. */
    fun goOn(folder: File, source: MotionSource) = begin(folder, isPractice = false) { Measuring.open(folder, source) }

    /** Begins, phone and placement told. */
    fun start(phone: PhoneInfo, placement: Placement) = handle(ProcedureEvent.Begin(utc(), today(), phone, placement))

    /** The recording begins. */
    fun record() = handle(ProcedureEvent.StartRecording(utc()))

    /** What an operator who plays by the book does now; only in practice, where it types in what the tape says. */
    fun byTheBook() = act { run -> run.byTheBook(utc())?.let(run::handle) }

    /** Takes what the operator did. */
    fun handle(event: ProcedureEvent) = act { it.handle(event) }

    /** Tries the work once more that failed. */
    fun workAgain() = act { workBegun = null }

    /** Lets simulated time go by faster or slower. */
    fun setPace(pace: Int) = flow.update { it.copy(pace = pace) }

    /** Leaves it; it is kept, and goes on where it stands. */
    fun leave() {
        life?.cancel()
    }

    private fun begin(folder: File, isPractice: Boolean, make: () -> Run) {
        life?.cancel()
        life = scope.launch(oneByOne) {
            closed.withLock {
                flow.value = Shown(isPractice = isPractice, folder = folder)
                var made: Run? = null
                guarded { made = make() }
                made?.let { live(it) }
            }
        }
    }

    /** From its opening to its closing, whatever ends it. */
    private suspend fun live(opened: Run) {
        run = opened
        sensors = opened.sensors
        try {
            coroutineScope { follow(opened) }
        } finally {
            guarded { opened.close() }
            run = null
            trace.clear()
            workBegun = null
            // What went wrong in closing is still shown, over the list of sessions.
            flow.update { Shown(error = it.error) }
        }
    }

    private suspend fun CoroutineScope.follow(run: Run) {
        while (isActive) {
            guarded { run.takeIn().forEach(trace::take) }
            guarded { run.letGoBy(flow.value.pace * LOOK_MS / 1e3) }
            show(run)
            workAsWanted(run)
            delay(LOOK_MS)
        }
    }

    private fun act(what: (Run) -> Unit) {
        scope.launch(oneByOne) {
            flow.update { it.copy(error = null) }
            val now = run ?: return@launch
            guarded { what(now) }
            show(now)
        }
    }

    private fun guarded(what: () -> Unit) {
        try {
            what()
        } catch (wrong: GyradiusException) {
            flow.update { it.copy(error = failureOf(wrong)) }
        }
    }

    private fun show(run: Run) {
        val state = run.state()
        val silent = run.silent
        flow.update { it.copy(state = state, trace = trace.points(), silent = silent) }
    }

    /** Begins the work that is newly wanted, and stops what is wanted no more. What failed is not begun again by itself. */
    private fun CoroutineScope.workAsWanted(run: Run) {
        val wanted = flow.value.state?.work
        if (wanted == workBegun) return
        workBegun = wanted
        working?.cancel()
        flow.update { it.copy(workShare = null, isWorkStuck = false) }
        if (wanted != null) working = launch { work(run, wanted) }
    }

    private suspend fun work(run: Run, wanted: ProcedureWork) {
        val failure = try {
            run.work { share, _ -> flow.update { it.copy(workShare = share) } }
            null
        } catch (wrong: GyradiusException) {
            // Done without meanwhile: then nobody waits for it any more.
            failureOf(wrong).takeIf { run.state().work == wanted }
        }
        flow.update { it.copy(workShare = null, isWorkStuck = failure != null, error = failure ?: it.error) }
    }

    private fun utc(): String = clock().truncatedTo(ChronoUnit.SECONDS).toString()

    /** The date where the phone is. */
    private fun today(): String = LocalDate.ofInstant(clock(), ZoneId.systemDefault()).toString()

    internal companion object {
        /** Between two looks at what came, ms. */
        const val LOOK_MS = 100L
    }
}
