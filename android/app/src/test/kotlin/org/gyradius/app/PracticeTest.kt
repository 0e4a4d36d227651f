package org.gyradius.app

import androidx.compose.ui.test.junit4.createAndroidComposeRule
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performScrollTo
import androidx.test.ext.junit.runners.AndroidJUnit4
import org.gyradius.ProcedurePhase
import org.junit.Assert.assertTrue
import org.junit.Rule
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.annotation.Config

/** The whole practice through the real screens, from the first touch to the result. */
@RunWith(AndroidJUnit4::class)
class PracticeTest {
    @get:Rule
    val rule = createAndroidComposeRule<MainActivity>()

    private val state get() = rule.activity.model.shown.value.state

    @Test
    fun `practice leads to a result`() {
        rule.shot("1-sessions")
        rule.onNodeWithText("Practise on a simulated hull").performClick()
        until("begun") { state != null }
        press("Begin", ProcedurePhase.START)
        rule.onNodeWithText("60×").performClick()
        until("the tilt") { state?.tilt != null }
        press("It is level now", ProcedurePhase.LEVEL)
        until("a reference") { state?.tilt?.angleDeg != null }
        rule.shot("2-level")
        press("Accept", ProcedurePhase.LEVEL)
        until("the rest") { state?.rest?.found != null }
        rule.shot("3-rest")
        press("Accept", ProcedurePhase.REST)
        while (state!!.phase != ProcedurePhase.MEASURE && state!!.phase != ProcedurePhase.CRITIQUE) swing()
        until("the result") { state?.result != null }
        rule.shot("7-result")
        assertTrue(state!!.result!!.quantities.any { it.name == "k_yaw_m" })
        press("Do without", ProcedurePhase.CRITIQUE)
        until("the end") { state?.phase == ProcedurePhase.DONE }
        rule.onNodeWithText("Yaw gyradius").assertExists()
        wholeResult()
    }

    @Test
    @Config(qualifiers = "de")
    fun `the hull of the practice has its name in the language of the phone`() {
        rule.onNodeWithText("An einem simulierten Rumpf üben").performClick()
        until("begun") { rule.texts().any { "Kielboot, simuliert" in it } }
    }

    private fun wholeResult() {
        rule.onNodeWithText("All of the result").performScrollTo().performClick()
        until("the way to share") { rule.exists("Share the report") }
        rule.shot("8-whole-result")
    }

    /** Hangs, records and accepts one step. */
    private fun swing() {
        press("As typed", ProcedurePhase.HANG)
        press("Start the recording", ProcedurePhase.READY)
        until("a live period") { state?.recording?.live?.swing != null || state?.phase == ProcedurePhase.JUDGE }
        rule.shot("5-swing")
        until("the end of the recording") { state?.phase == ProcedurePhase.JUDGE }
        rule.shot("6-judge")
        press("Accept", ProcedurePhase.JUDGE)
        until("the next step") { state?.phase !in setOf(ProcedurePhase.JUDGE, null) }
    }

    private fun press(text: String, phase: ProcedurePhase) {
        until(phase.name) { state?.phase == phase }
        until(text) { rule.exists(text) }
        rule.onNodeWithText(text).performScrollTo().performClick()
        until("$phase and what $text makes of it") { state?.phase != phase || text == "It is level now" }
    }

    private fun until(what: String, holds: () -> Boolean) = rule.patient(what, holds)
}
