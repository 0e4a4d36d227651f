package org.gyradius.app.run

import java.io.File
import org.gyradius.Channel
import org.gyradius.GyradiusException
import org.gyradius.OnProgress
import org.gyradius.PhoneSensor
import org.gyradius.Procedure
import org.gyradius.ProcedureEvent
import org.gyradius.ProcedurePhase
import org.gyradius.ProcedureState
import org.gyradius.ProcedureTask
import org.gyradius.Rehearsal
import org.gyradius.Rig
import org.gyradius.Samples
import org.gyradius.Sensor
import org.gyradius.asSamples
import org.gyradius.push
import org.gyradius.work

/** A procedure under way: on a real hull or on a simulated one. Everything keeps the thread that calls it; [work] alone goes
 * on beside the others. */
interface Run : AutoCloseable {
    /** The sensors that it listens to. */
    val sensors: List<PhoneSensor>

    /** Streams that have stopped. */
    val silent: Set<Channel>

    /** Everything that a screen shows. */
    fun state(): ProcedureState

    /** Takes what the operator did. */
    fun handle(event: ProcedureEvent)

    /** Takes in what came since the last call; returns what a trace can show of it. */
    fun takeIn(): List<Samples>

    /** Lets so much time go by where time is simulated, s. */
    fun letGoBy(seconds: Double) = Unit

    /** What an operator who plays by the book does now; known only where the hull is simulated. */
    fun byTheBook(atUtc: String): ProcedureEvent? = null

    /** Does the work that the state wants: seconds or minutes. */
    suspend fun work(onProgress: OnProgress)
}

/** A real hull, on what a source gives. */
class Measuring(private val procedure: Procedure, private val source: MotionSource) : Run {
    private val quiet = Quiet(source.sensors.map { it.channel })
    private var newestNs = 0L

    /** Of what has stopped, what the recording under way knows. */
    private var told = emptySet<Channel>()

    override val sensors get() = source.sensors

    override val silent get() = quiet.silent

    override fun state() = procedure.state()

    /** What came before it is taken in before it: a recording that is stopped has all samples up to then. */
    override fun handle(event: ProcedureEvent) {
        pushAll(source.take())
        procedure.handle(event)
    }

    override fun takeIn(): List<Samples> {
        val found = source.take()
        val stopped = quiet.look(found)
        pushAll(found)
        val isRecording = procedure.state().phase == ProcedurePhase.RECORD
        if (isRecording) (stopped - told).forEach(::tellStopped)
        told = if (isRecording) stopped else emptySet()
        return found
    }

    override suspend fun work(onProgress: OnProgress) = procedure.work(onProgress)

    override fun close() = procedure.use {
        source.close()
        pushAll(source.take())
    }

    /** Every batch is offered, whatever became of the one before: the library says which it can still use. */
    private fun pushAll(batches: List<Samples>) {
        val failures = batches.mapNotNull { batch ->
            newestNs = maxOf(newestNs, batch.stampsNs.last())
            try {
                procedure.push(batch)
                null
            } catch (wrong: GyradiusException) {
                wrong
            }
        }
        failures.firstOrNull()?.let { throw it }
    }

    /** It then stands in the recording itself, and whoever judges it knows. */
    private fun tellStopped(channel: Channel) {
        val sensor = if (channel == Channel.ACCELEROMETER) Sensor.ACCELEROMETER else Sensor.GYROSCOPE
        procedure.handle(ProcedureEvent.SensorStopped(sensor, newestNs))
    }

    companion object {
        /** Begins in a folder. */
        fun create(folder: File, task: ProcedureTask, source: MotionSource) =
            Measuring(Procedure.create(folder.path, task), source.apply { open() })

        /** Goes on with what was left in a folder. */
        fun open(folder: File, source: MotionSource) = Measuring(Procedure.open(folder.path), source.apply { open() })
    }
}

/** A simulated hull: time goes by as it is let. */
class Practising(private val rehearsal: Rehearsal) : Run {
    private var heard = emptyList<Samples>()

    override val sensors = emptyList<PhoneSensor>()

    override val silent = emptySet<Channel>()

    override fun state() = rehearsal.state()

    override fun handle(event: ProcedureEvent) = rehearsal.handle(event)

    override fun takeIn() = heard.also { heard = emptyList() }

    override fun letGoBy(seconds: Double) {
        rehearsal.advance(seconds)
        heard += rehearsal.heard().map { it.asSamples() }
    }

    override fun byTheBook(atUtc: String): ProcedureEvent? = rehearsal.byTheBook(atUtc)

    override suspend fun work(onProgress: OnProgress) = rehearsal.work(onProgress)

    override fun close() = rehearsal.close()

    companion object {
        /** Goes on with a practice that was left in a folder, or begins there under a title. */
        fun of(folder: File, rigText: String, title: String, seed: ULong): Practising = Rig.parse(rigText, "practice").use { rig ->
            val known = File(folder, JOURNAL).exists()
            Practising(if (known) Rehearsal.open(folder.path, rig, seed) else begun(folder, rig, title, seed))
        }

        private fun begun(folder: File, rig: Rig, title: String, seed: ULong): Rehearsal =
            rig.titled(title).use { Rehearsal.create(folder.path, it, seed) }
    }
}

/** The file that makes a folder a procedure's. */
const val JOURNAL = "procedure.journal"
