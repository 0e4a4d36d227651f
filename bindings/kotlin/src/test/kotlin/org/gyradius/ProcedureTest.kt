package org.gyradius

import kotlinx.coroutines.runBlocking
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.io.File
import kotlin.math.abs
import kotlin.random.Random

/** The procedure as an app drives it, and its rehearsal to the end. */
class ProcedureTest {
    @TempDir
    lateinit var folder: File

    private fun task(): ProcedureTask = runBlocking {
        val hull = usualPlanRequest().hull.copy(massKg = 212.0, lengthM = 5.05, beamM = 1.6, boatType = "dinghy")
        planSwings(usualPlanRequest().copy(title = "boat", hull = hull, wanted = listOf("k_yaw=1%"))).use { it.task() }
    }

    @Test
    fun `a rehearsal goes by the book to the result, and is near the truth`() = runBlocking {
        val rehearsal = Rehearsal.create(folder.path, Shared.rig(), Random.nextLong(1L shl 53).toULong().also(::println))
        val phases = LinkedHashSet<ProcedurePhase>()
        while (rehearsal.state().phase != ProcedurePhase.CRITIQUE) {
            val state = rehearsal.state()
            phases += state.phase
            assertTrue(state.instruction.english.isNotEmpty() && '{' !in state.instruction.english)
            val event = rehearsal.byTheBook(Shared.AT_UTC)
            if (event != null) rehearsal.handle(event)
            else if (state.work != null) rehearsal.work()
            else rehearsal.advance(5.0)
        }
        val order = listOf("START", "LEVEL", "REST", "HANG", "READY", "RECORD", "JUDGE", "MEASURE")
        assertEquals(order, phases.map { it.name })
        rehearsal.handle(ProcedureEvent.Skip)
        assertEquals(ProcedurePhase.DONE, rehearsal.state().phase)
        val truth = rehearsal.truth().associate { it.name to it.value }
        for (name in listOf("k_yaw_m", "k_pitch_m")) {
            val found = rehearsal.state().result!!.quantities.first { it.name == name }.quantity
            val (value, u) = found.value.number!! to found.u.number!!
            // Off by more than five of its own uncertainties once in a million.
            assertTrue(abs(value - truth.getValue(name)) < 5.0 * u, "$name: $value, u $u, true ${truth[name]}")
        }
        assertEquals(listOf("yaw-sway", "surge-pitch"), loadSession(File(folder, "session")).swingIds())
    }

    @Test
    fun `a procedure keeps every sample and goes on where the app was killed`() {
        val phone = PhoneInfo("phone", listOf(PhoneSensor(Channel.GYROSCOPE, "gyro", null)))
        val first = Procedure.create(folder.path, task())
        first.handle(ProcedureEvent.Begin(Shared.AT_UTC, null, phone, Placement.FLAT_TOP_TO_BOW))
        quiet(first, 0, 20)
        val tilt = first.state().tilt!!
        assertEquals(TiltAgainst.PHONE_PLANE, tilt.against)
        assertEquals(0.0, tilt.bowUpDeg!!, 0.1)
        first.handle(ProcedureEvent.Accept)
        quiet(first, 20, 40)
        val rest = first.state().rest!!.found!!
        assertEquals(100.0, rest.gyroscope.rateHz, 0.01)
        assertEquals(9.81, rest.gravityMS2!!, 0.01)
        first.handle(ProcedureEvent.Accept)
        val planned = first.state().step!!.planned.swing!!.suspension
        first.handle(ProcedureEvent.Measured(measured(planned)))
        first.handle(ProcedureEvent.StartRecording(Shared.AT_UTC))
        quiet(first, 60, 65)
        val file = File(folder, first.state().recording!!.file)
        first.close()

        val second = Procedure.open(folder.path)
        assertEquals(ProcedurePhase.INTERRUPTED, second.state().phase)
        assertTrue(ProcedureAction.CONTINUE in second.state().actions)
        second.handle(ProcedureEvent.Continue)
        quiet(second, 66, 70)
        second.handle(ProcedureEvent.StopRecording)
        val state = second.state()
        assertEquals(ProcedurePhase.JUDGE, state.phase)
        assertEquals(Recommend.REPEAT, state.judgement!!.recommend)
        assertTrue(state.judgement.reasons.any { it.key == "reason_no_swing" })
        val recorded = RecorderFile.read(file.path).samples().first { it.channel == Channel.GYROSCOPE }.stampsNs
        // Never more than half a second behind: what was told before the kill is there but for its last half second.
        val (before, after) = recorded.partition { it < 66 * SECOND }
        assertEquals((0 until 400).map { 66 * SECOND + 10_000_000L * it }, after)
        assertTrue(before.size in 450..500, "${before.size}")
        assertEquals(before.indices.map { 60 * SECOND + 10_000_000L * it }, before)
    }

    /** A hull that hangs still, by a phone that lies flat. */
    private fun quiet(procedure: Procedure, fromS: Long, untilS: Long) {
        val random = Random(fromS)
        for (start in 100 * fromS until 100 * untilS step 20) {
            val stamps = LongArray(20) { 10_000_000L * (start + it) }
            for ((channel, up) in listOf(Channel.GYROSCOPE to 0.0, Channel.ACCELEROMETER to 9.81)) {
                val values = DoubleArray(60) { random.nextDouble(-1e-3, 1e-3) + if (it % 3 == 2) up else 0.0 }
                procedure.push(Samples(channel, stamps, values))
            }
        }
    }

    private fun measured(planned: Suspension) = MeasuredDimensions(
        lineLengthM = planned.lineLengthM,
        spacingM = planned.spacingM,
        topSpacingM = null,
        hullPitchDeg = null,
        pointsMovedM = null,
        axisHeightM = null,
        massKg = null,
        armM = null,
        depthM = null,
    )

    @Test
    fun `what is not offered is refused and changes nothing`() {
        val procedure = Procedure.create(folder.path, task())
        val before = procedure.stateJson()
        val error = assertThrows(GyradiusException.BadArgument::class.java) { procedure.handle(ProcedureEvent.Accept) }
        assertTrue("one of: begin" in error.text, error.text)
        assertEquals(before, procedure.stateJson())
        assertThrows(GyradiusException.Unwritable::class.java) { Procedure.create(folder.path, task()) }
        assertEquals(ProcedureEvent.Tick(5), procedureEventFromJson("""{"event": "tick", "stamp_ns": 5}"""))
    }

    private companion object {
        const val SECOND = 1_000_000_000L
    }
}
