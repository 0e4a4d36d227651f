package org.gyradius

import kotlinx.coroutines.runBlocking
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.io.File
import kotlin.math.PI
import kotlin.math.cos

/** Typed results beside their JSON: what an app shows. */
class ResultsTest {
    @TempDir
    lateinit var folder: File

    @Test
    fun `a measurement as records`() {
        val result = boatPark.result()
        assertEquals("gyradius-measurement/1", result.format)
        assertEquals(result.swings.map { it.id }, listOf("yaw-sway", "surge-pitch", "roll", "bow-up", "bow-down"))
        val yaw = result.quantity("k_yaw_m")!!
        val (low, high) = yaw.interval95!!
        assertTrue(yaw.value.number!! in low..high)
        assertTrue(result.quantities.map { it.name } == result.quantities.map { it.name }.sorted())
        val inertia = result.quantity("inertia_kg_m2")!!.value as QuantityValue.Matrix
        assertEquals(listOf(3, 3, 3), inertia.rows.map { it.size })
        assertEquals(3, (result.quantity("principal_gyradii_m")!!.value as QuantityValue.Vector).values.size)
        assertEquals("k_yaw_m", result.verdicts.single().quantity)
        assertTrue(result.budget.first { it.name == "k_yaw_m" }.lines.all { it.uContribution >= 0.0 })
        assertEquals(ModeName.YAW, result.swings.last().modes.first().mode)
    }

    @Test
    fun `pictures come thinned`() = runBlocking {
        val recordings = boatPark.recordings(Language.ENGLISH)
        assertEquals(5, recordings.size)
        for (trace in recordings.flatMap { it.traces }) {
            // A pause in the record adds a point to the 1200 of the core.
            assertTrue(trace.measured.x.size in 100..1300, "${trace.label}: ${trace.measured.x.size}")
            assertEquals(trace.measured.x.size, trace.measured.y.size)
        }
        assertTrue(recordings.all { it.spectrum!!.amplitude.x.isNotEmpty() })
        assertTrue(boatPark.figures(null, Language.ENGLISH).all { it.svg.startsWith("<svg") && it.title.isNotEmpty() })
        val html = boatPark.reportHtml(measuredOn = "4 May 2026")
        assertTrue(html.startsWith("<!DOCTYPE html>") && "4 May 2026" in html)
        val german = boatPark.reportHtml(language = Language.GERMAN)
        assertTrue("<html lang=\"de\">" in german && "Trägheitsradius Gieren" in german)
        assertTrue(boatPark.recordings(Language.GERMAN).first().traces.first().label.startsWith("Drehrate um "))
    }

    @Test
    fun `a criticism that was kept heads the report`() = runBlocking {
        val kept = File(Shared.root, "core/crates/report/tests/it/report/critiques/ambiguous.json").readText()
        val criticism = Criticism.fromJson(kept)
        val verdict = criticism.result().verdict
        assertEquals("ambiguous", verdict.status)
        assertTrue(verdict.nextSwing!!.lineLengthM > 0.0)
        val analysis = loadSession(Shared.session("keelboat")).measure()
        assertTrue("gyradius-critique" in analysis.reportHtml(criticism))
        assertTrue("gyradius-critique" !in analysis.reportHtml())
    }

    @Test
    fun `a plan tells what to do`() = runBlocking {
        val hull = usualPlanRequest().hull.copy(massKg = 622.0, lengthM = 6.35, beamM = 1.73, boatType = boatTypes().first())
        val plan = planSwings(usualPlanRequest().copy(hull = hull, wanted = listOf("k_yaw=0.5%"))).result()
        val swing = plan.steps.firstNotNullOf { it.swing }
        assertTrue(swing.suspension.lineLengthM!!.value <= plan.means.mostLineLengthM)
        assertTrue(plan.predicted.first().periodsS.getValue(ModeName.YAW) > 0.0)
        val yaw = plan.quantities.first { it.name == "k_yaw_m" }.quantity
        assertEquals(0.005 * yaw.value, yaw.wantedU!!, 1e-12)
        assertEquals(yaw.isReached, yaw.u!! <= yaw.wantedU)
        assertTrue(sentenceIn(plan.suspensions.first().message, Language.GERMAN).startsWith("Waagerecht, zwei Leinen von "))
    }

    @Test
    fun `oscillations of any record`() {
        // Period 2 s, no decay, the amplitude 1 beside rounding to 1e-3.
        val t = DoubleArray(3000) { 0.02 * it }
        val y = DoubleArray(t.size) { Math.round(1000.0 * cos(PI * t[it])) / 1000.0 }
        val found = decompose(t, listOf(y))
        val mode = found.oscillations().first()
        assertEquals(2.0, mode.periodS, 1e-4)
        assertEquals(0.0, mode.alphaPerS, 1e-3)
        assertEquals(1.0, found.evaluate(doubleArrayOf(2.0)).single().single(), 0.01)
    }

    @Test
    fun `a session that was never swung`() = runBlocking {
        val (session, truth) = File(folder, "session") to File(folder, "truth.json")
        Shared.rig().write(session.path, truth.path, 7uL, Overwrite.REFUSE)
        assertTrue("gyradius-truth/1" in truth.readText())
        assertEquals(Shared.rig().swingIds(), loadSession(session).swingIds())
        assertTrue("line_length" in loadSession(session).statedToml()!!)
    }

    @Test
    fun `a result is told in German`() = runBlocking {
        val result = boatPark.result()
        val claim = result.consistency.first { it.claim == "line_length" }
        assertEquals(claim.message.english, sentenceIn(claim.message, Language.ENGLISH))
        assertTrue(sentenceIn(claim.message, Language.GERMAN).startsWith("Leinenlänge: angegeben "))
        assertEquals(result.warnings.map { it.english }, result.warnings.map { sentenceIn(it, Language.ENGLISH) })
        assertEquals("Abstand der Leinen", inputIn("spacing", Language.GERMAN))
    }

    @Test
    fun `every text has a key of its own`() {
        val (texts, german) = Language.entries.map { texts(it) }
        assertEquals(texts.map { it.name }, german.map { it.name })
        assertEquals(texts.size, texts.map { it.name }.toSet().size)
        assertTrue(texts.all { it.name.isNotEmpty() && it.text.isNotEmpty() })
        assertTrue(listOf("", "live-", "plan-", "inertia-", "critique-").all { room -> texts.any { it.name.startsWith(room) } })
        assertEquals("0.1.0", libraryVersion())
    }

    private companion object {
        /** Measured once for all tests. */
        val boatPark: Analysis by lazy {
            Session.load(Shared.session("boat-park").path, emptyList()).measureBlocking(listOf("k_yaw_m>=1.000"), null)
        }
    }
}
