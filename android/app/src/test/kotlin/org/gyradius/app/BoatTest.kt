package org.gyradius.app

import androidx.compose.ui.test.junit4.createAndroidComposeRule
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performScrollTo
import androidx.compose.ui.test.performTextInput
import androidx.test.ext.junit.runners.AndroidJUnit4
import java.io.File
import java.time.LocalDate
import kotlin.math.abs
import org.gyradius.Excitation
import org.gyradius.PlannedSwing
import org.gyradius.ProcedurePhase
import org.gyradius.Recommend
import org.gyradius.Rig
import org.gyradius.Simulation
import org.gyradius.Suspension
import org.gyradius.number
import org.gyradius.simulate
import org.gyradius.swing
import org.junit.Assert.assertEquals
import org.junit.Assert.assertTrue
import org.junit.Rule
import org.junit.Test
import org.junit.runner.RunWith

/** A boat from its set-up to the result through the real screens, by sensor events at 200 Hz as Android gives them. The hull
 * is the core's simulation; what is true of it stands here. */
@RunWith(AndroidJUnit4::class)
class BoatTest {
    @get:Rule
    val rule = createAndroidComposeRule<MainActivity>()

    private val park = Park()
    private val state get() = park.state

    @Test
    fun `a boat is measured, and the truth is inside of the interval`() {
        setUp()
        click("Begin")
        reach(ProcedurePhase.LEVEL)
        park.phone.rest(5.0)
        rule.patient("level") { abs(state?.tilt?.bowUpDeg ?: 90.0) < 0.2 && rule.exists("Accept") }
        rule.shot("20-level")
        click("Accept")
        reach(ProcedurePhase.REST)
        park.phone.rest(20.0)
        rule.patient("the rest") { state?.rest?.found != null && rule.exists("Accept") }
        assertEquals(200.0, state!!.rest!!.found!!.gyroscope.rateHz, 0.1)
        click("Accept")
        reach(ProcedurePhase.HANG)
        while (state!!.phase == ProcedurePhase.HANG) swing()
        rule.patient("the result") { state?.result != null }
        judge("k_yaw_m", K_YAW_M)
        judge("k_pitch_m", K_PITCH_M)
        click("Do without")
        rule.patient("the end") { state?.phase == ProcedurePhase.DONE }
        rule.onNodeWithText("Yaw gyradius").assertExists()
        val session = File(park.sessions().single(), "session/session.toml").readText()
        assertTrue(session, "measured_on = \"${LocalDate.now()}\"" in session)
    }

    private fun setUp() {
        click("Measure a boat")
        for ((label, text) in listOf("Name" to "Finn", "Mass of all that hangs, kg" to "120", "Length overall, m" to "4.5", "Beam, m" to "1.5")) {
            rule.onNodeWithText(label).performScrollTo().performTextInput(text)
        }
        click("Dinghy")
        click("Plan the swings")
        rule.patient("the plan") { rule.exists("To the boat") }
        click("To the boat")
        reach(ProcedurePhase.START)
    }

    /** Hangs, lets go and accepts one step. */
    private fun swing() {
        val step = state!!.step!!
        click("As typed")
        reach(ProcedurePhase.READY)
        val motion = simulated(step.planned.swing!!, step.hanging!!)
        click("Start the recording")
        reach(ProcedurePhase.RECORD)
        park.phone.ride(motion) { state?.phase == ProcedurePhase.RECORD }
        reach(ProcedurePhase.JUDGE)
        rule.shot("21-judge-${step.id}")
        assertEquals("${state!!.judgement}", Recommend.ACCEPT, state!!.judgement!!.recommend)
        click("Accept")
        rule.patient("the next step") { state?.phase !in setOf(ProcedurePhase.JUDGE, null) }
    }

    private fun simulated(planned: PlannedSwing, hanging: Suspension): Simulation =
        Rig.parse(rigText(planned, hanging), "the hull").use { it.simulate(planned.id, seed = 7UL) }

    private fun judge(name: String, truth: Double) {
        val found = state!!.result!!.quantities.first { it.name == name }.quantity
        val (value, u) = found.value.number!! to found.u.number!!
        assertTrue("$name: $value ± $u, true $truth", abs(value - truth) < 2 * u && u < 0.005 * truth)
    }

    private fun click(text: String) {
        rule.patient(text) { rule.exists(text) }
        rule.onNodeWithText(text).performScrollTo().performClick()
    }

    private fun reach(phase: ProcedurePhase) = rule.patient(phase.name) { state?.phase == phase }

    private companion object {
        const val K_YAW_M = 1.093
        const val K_PITCH_M = 1.121

        fun start(excited: Excitation) = when (excited) {
            Excitation.YAW -> "yaw_deg = 5.0"
            Excitation.SWAY -> "sway_m = 0.15"
            Excitation.PITCH -> "pitch_deg = 5.0"
            else -> error("the plan of a dinghy has no $excited")
        }

        /** The hull as it hangs for one swing; lengths as they are typed in. */
        fun rigText(planned: PlannedSwing, hanging: Suspension): String = """
            format = "gyradius-rig/1"
            title = "Finn"
            [body]
            name = "Finn"
            mass = 120.0
            [site]
            gravity = { value = 9.80665, u = 0.015 }
            [truth]
            k_yaw_m = $K_YAW_M
            k_pitch_m = $K_PITCH_M
            k_roll_m = 0.55
            cm_depth_m = 0.33
            position_x_m = 0.8
            position_z_m = 0.1
            gyro_bias_x_rad_s = 0.003
            rate_hz = 200.0
            [[swing]]
            id = "${planned.id}"
            recording = "swing.csv"
            [swing.suspension]
            kind = "bifilar"
            orientation = "${hanging.orientation.name.lowercase()}"
            line_length = { value = ${hanging.lineLengthM!!.value}, u = 0.003 }
            spacing = { value = ${hanging.spacingM!!.value}, u = 0.001 }
            [swing.truth]
            ${planned.excited.joinToString("\n") { start(it) }}
            held_s = 4.0
            duration_s = ${planned.durationS + 30.0}
            [[effect]]
            id = "linear_damping"
            surge_n_s_m = 1.2
            sway_n_s_m = 1.2
            pitch_n_m_s = 1.3
            yaw_n_m_s = 1.3
            [[effect]]
            id = "white_noise"
            gyro_rad_s = 0.002
            acc_m_s2 = 0.02
        """.trimIndent()
    }
}
