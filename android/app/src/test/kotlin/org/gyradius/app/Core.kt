package org.gyradius.app

import java.io.File
import java.nio.file.Files
import java.util.zip.ZipEntry
import java.util.zip.ZipOutputStream
import kotlinx.coroutines.runBlocking
import org.gyradius.Analysis
import org.gyradius.Channel
import org.gyradius.Criticism
import org.gyradius.Overwrite
import org.gyradius.PlanRequest
import org.gyradius.ProcedureEvent
import org.gyradius.ProcedurePhase
import org.gyradius.ProcedureState
import org.gyradius.Rehearsal
import org.gyradius.Rig
import org.gyradius.Samples
import org.gyradius.asDoubles
import org.gyradius.critique
import org.gyradius.loadSession
import org.gyradius.measure
import org.gyradius.planSwings
import org.gyradius.simulate
import org.gyradius.usualPlanRequest
import org.gyradius.app.run.Planned
import org.gyradius.app.run.Trace

/** What the core makes of hulls it simulates and of a session that ships; each is computed once for all tests. */
object Core {
    private val root = File(System.getProperty("gyradius.root")!!)
    private val rigText = File(root, "python/gyradius/rigs/keelboat.toml").readText()
    private val rig: Rig = Rig.parse(rigText, "practice")
    const val AT_UTC = "2026-05-04T09:30:00Z"

    /** A Finn, known as roughly as anybody knows one. */
    val request: PlanRequest by lazy {
        val hull = usualPlanRequest().hull.copy(massKg = 120.0, lengthM = 4.5, beamM = 1.5, boatType = "dinghy")
        usualPlanRequest().copy(title = "Finn", hull = hull, wanted = listOf("k_yaw=0.2%", "k_pitch=0.5%", "psi=0.5deg"))
    }

    val planned: Planned by lazy {
        runBlocking { planSwings(request) }.use { Planned(plan = it.result(), task = it.task()) }
    }

    /** Every state of a rehearsal that goes by the book, half a second of simulated time apart. */
    val byTheBook: List<ProcedureState> by lazy { rehearse { } }

    /** The same with somebody who touches the hull in the first recording. */
    val touched: List<ProcedureState> by lazy { rehearse { it.mishap("yaw-sway", 1u, "touch") } }

    /** The same with a first release that is not as planned. */
    val badlyReleased: List<ProcedureState> by lazy { rehearse { it.mishap("yaw-sway", 1u, "bad_release") } }

    /** The rates of a swing that the rig simulates, as the live trace takes them. */
    val trace: List<Trace.Point> by lazy {
        val rows = rig.simulate("yaw-sway", seed = 1uL).use { it.tS() to it.readings().asDoubles() }
        val (tS, readings) = rows.first.asDoubles() to rows.second
        val rates = DoubleArray(3 * tS.size) { readings[it / 3 * 6 + it % 3] }
        val stamps = LongArray(tS.size) { (tS[it] * 1e9).toLong() }
        val last = 2000
        Trace().apply { take(Samples(Channel.GYROSCOPE, stamps.copyOf(last), rates.copyOf(3 * last))) }.points()
    }

    val boatPark: Analysis by lazy {
        val limits = listOf("k_yaw_m>=1.100", "k_pitch_m<=1.180", "psi_deg<=2.400")
        runBlocking { loadSession(File(root, "python/gyradius/sessions/boat-park")).measure(limits) }
    }

    /** The same session as others hand it over. */
    val boatParkZip: File by lazy {
        val from = File(root, "python/gyradius/sessions/boat-park")
        File.createTempFile("boat-park", ".zip").also { zip ->
            ZipOutputStream(zip.outputStream().buffered()).use { out ->
                for (file in from.listFiles()!!) {
                    out.putNextEntry(ZipEntry(file.name))
                    file.inputStream().use { it.copyTo(out) }
                }
            }
        }
    }

    /** A hull in the air, whose drag the simulation without causes leaves out. */
    val dragged: Criticism by lazy {
        val folder = Files.createTempDirectory("drag").toFile()
        val rig = Rig.parse(rigText + DRAG, "drag")
        rig.write(File(folder, "session").path, File(folder, "truth.json").path, 1uL, Overwrite.REFUSE)
        runBlocking { loadSession(File(folder, "session")).critique() }
    }

    private fun rehearse(prepare: (Rehearsal) -> Unit): List<ProcedureState> {
        val folder = Files.createTempDirectory("rehearsal").toFile()
        return Rehearsal.create(folder.path, rig, 1uL).use { one ->
            prepare(one)
            val states = mutableListOf(one.state())
            while (states.last().phase != ProcedurePhase.DONE) {
                goOn(one, states.last())
                states += one.state()
            }
            states
        }
    }

    /** The criticism is left out: it takes minutes. */
    private fun goOn(one: Rehearsal, state: ProcedureState) {
        val next = one.byTheBook(AT_UTC)
        when {
            state.phase == ProcedurePhase.CRITIQUE -> one.handle(ProcedureEvent.Skip)
            next != null -> one.handle(next)
            state.work != null -> one.workBlocking(null)
            else -> one.advance(0.5)
        }
    }

    private const val DRAG = """
[[effect]]
id = "quadratic_drag"
yaw_torque_coefficient = 30.0
"""
}

/** The state in the middle of those that fit. */
fun List<ProcedureState>.middle(fits: (ProcedureState) -> Boolean): ProcedureState = filter(fits).let { it[it.size / 2] }
