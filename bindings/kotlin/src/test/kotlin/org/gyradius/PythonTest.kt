package org.gyradius

import kotlinx.coroutines.runBlocking
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonPrimitive
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource
import java.io.File

/** The same files through Kotlin give the same bytes as through Python. */
class PythonTest {
    @TempDir
    lateinit var folder: File

    private fun text(name: String) = Shared.python(name).readText()

    private fun doubles(name: String) = Shared.python(name).readBytes().asDoubles()

    @ParameterizedTest
    @ValueSource(strings = ["boat-park", "keelboat", "model-hull"])
    fun `a session's measurement and report`(name: String) = runBlocking {
        val limits = listOf("k_yaw_m>=1.000", "k_pitch_m<=1.2")
        loadSession(Shared.session(name)).use { session ->
            session.measure(limits).use {
                assertEquals(text("measure-$name.json"), it.json())
                assertEquals(text("report-$name.html"), it.reportHtml())
            }
        }
    }

    @Test
    fun `a bare recording`() = runBlocking {
        val bare = loadSession(File(Shared.session("boat-park"), "yaw-sway.csv"))
        assertEquals(text("measure-bare.json"), bare.measure().json())
    }

    @ParameterizedTest
    @ValueSource(strings = ["keelboat", "model-hull"])
    fun `a criticism`(name: String) = runBlocking {
        val criticism = loadSession(Shared.session(name)).critique()
        assertEquals(text("critique-$name.json"), criticism.json())
    }

    @Test
    fun `a plan and its files`() = runBlocking {
        val plan = planSwings(planRequestFromJson(text("plan-request.json")))
        assertEquals(text("plan.json"), plan.json())
        assertEquals(text("plan-session.toml"), plan.sessionToml())
        assertEquals(text("plan-rig.toml"), plan.rigToml())
    }

    @Test
    fun `a simulated swing, and its oscillations`() {
        val numbers = Shared.json(Shared.python("simulation-numbers.json")).jsonArray.map { it.jsonPrimitive.content }
        val swung = Shared.rig().simulate("surge-pitch", derivatives = numbers, seed = Shared.SEED)
        val (t, readings) = swung.tS().asDoubles() to swung.readings().asDoubles()
        assertBits(doubles("simulation-t_s.bin"), t)
        assertBits(doubles("simulation-readings.bin"), readings)
        assertBits(doubles("simulation-derivatives.bin"), swung.derivatives().asDoubles())
        val gyroscope = List(3) { axis -> DoubleArray(4000) { readings[6 * (1000 + it) + axis] } }
        val found = decompose(t.copyOfRange(1000, 5000), gyroscope)
        assertEquals(text("decomposition.json"), found.json())
    }

    @Test
    fun `the live estimate of that swing`() {
        val readings = Shared.rig().simulate("surge-pitch", seed = Shared.SEED).readings().asDoubles()
        val stamps = Shared.python("live-stamps_ns.bin").readBytes().asStamps()
        LiveEstimator(1e-4, null, null).use { live ->
            for (rows in stamps.indices.chunked(100)) {
                live.push(rows.samples(Channel.GYROSCOPE, stamps, readings, 0))
                live.push(rows.samples(Channel.ACCELEROMETER, stamps, readings, 3))
            }
            assertEquals(text("live.json"), live.estimateJson())
        }
    }

    private fun List<Int>.samples(channel: Channel, stamps: LongArray, readings: DoubleArray, first: Int) = Samples(
        channel,
        LongArray(size) { stamps[this[it]] },
        DoubleArray(3 * size) { readings[6 * this[it / 3] + first + it % 3] },
    )

    @Test
    fun `a practice, state by state, and its recordings`() {
        val states = Shared.json(Shared.python("practice-states.json")).jsonArray.map { it.jsonPrimitive.content }
        val rehearsal = Rehearsal.create(File(folder, "practice").path, Shared.rig(), Shared.SEED)
        rehearsal.mishap("yaw-sway", 1u, "slip")
        val told = mutableListOf(rehearsal.stateJson())
        while (rehearsal.state().work == null) {
            when (val event = rehearsal.byTheBook(Shared.AT_UTC)) {
                null -> rehearsal.advance(5.0)
                else -> rehearsal.handle(event).also { told += rehearsal.stateJson() }
            }
        }
        assertEquals(states, told)
        val takes = File(folder, "practice/takes").listFiles()!!.sortedBy { it.name }
        assertEquals(Shared.python("practice/takes").list()!!.sorted(), takes.map { it.name })
        takes.forEach(::sameTake)
    }

    private fun sameTake(take: File) {
        val python = Shared.python("practice/takes/${take.name}")
        assertArrayEquals(python.readBytes(), take.readBytes(), take.name)
        val gyroscope = RecorderFile.read(python.path).samples().first { it.channel == Channel.GYROSCOPE }
        assertArrayEquals(Shared.python("${take.name}-stamps_ns.bin").readBytes().asStamps(), gyroscope.stampsNs)
        assertBits(doubles("${take.name}-values.bin"), gyroscope.values)
        assertTrue(gyroscope.stampsNs.size > 1000, "${gyroscope.stampsNs.size} samples")
    }

    @Test
    fun `an import`() {
        val notes = Shared.json(Shared.python("import-notes.json")).jsonArray.map { it.jsonPrimitive.content }
        val files = listOf(File(Shared.root, "core/crates/recording/tests/fixtures/import/phyphox-android.zip"), Shared.python("cut.gyr"))
        val imported = File(folder, "imported")
        assertEquals(notes, importRecordings(files.map { it.path }, imported.path, request(), Overwrite.REFUSE))
        val python = Shared.python("imported").listFiles()!!.sortedBy { it.name }
        assertEquals(python.map { it.name }, imported.list()!!.sorted())
        python.forEach { assertArrayEquals(it.readBytes(), File(imported, it.name).readBytes(), it.name) }
    }

    private fun request() = ImportRequest(
        mapping = emptyList(),
        trial = null,
        platform = null,
        flagWidthM = null,
        title = "faces",
        massKg = Quantity(622.7, 0.5),
        gravityMS2 = null,
        suspension = Suspension(
            kind = SuspensionKind.BIFILAR,
            orientation = Orientation.ATHWARTSHIPS,
            lineLengthM = Quantity(3.477, 0.003),
            spacingM = Quantity(1.8, 0.001),
            topSpacingM = null,
            hullPitchDeg = null,
            hullRollDeg = null,
            pointsM = null,
            pointsMovedM = null,
            axisHeightM = null,
        ),
    )
}

/** Equal bit by bit: a NaN equals itself, 0 is not −0. */
internal fun assertBits(expected: DoubleArray, found: DoubleArray) =
    assertArrayEquals(expected.bits(), found.bits())

private fun DoubleArray.bits() = LongArray(size) { this[it].toRawBits() }
