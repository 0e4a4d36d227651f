package org.gyradius.app

import android.hardware.Sensor
import android.hardware.SensorManager
import androidx.compose.ui.test.junit4.createAndroidComposeRule
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performScrollTo
import androidx.compose.ui.test.performTextInput
import androidx.test.ext.junit.runners.AndroidJUnit4
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.exp
import kotlin.random.Random
import org.gyradius.ProcedurePhase
import org.junit.Assert.assertEquals
import org.junit.Assert.assertTrue
import org.junit.Before
import org.junit.Rule
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.Shadows.shadowOf
import org.robolectric.annotation.Config
import org.robolectric.annotation.GraphicsMode
import org.robolectric.shadows.SensorEventBuilder
import org.robolectric.shadows.ShadowSensor

/** A boat from its set-up to the judgement of a swing, by sensor events at 200 Hz as Android would give them. */
@RunWith(AndroidJUnit4::class)
@GraphicsMode(GraphicsMode.Mode.NATIVE)
@Config(sdk = [35], qualifiers = "w411dp-h891dp-xhdpi")
class BoatTest {
    @get:Rule
    val rule = createAndroidComposeRule<MainActivity>()

    private val state get() = rule.activity.model.shown.value.state
    private val manager get() = rule.activity.getSystemService(SensorManager::class.java)!!
    private val gyroscope = ShadowSensor.newInstance(Sensor.TYPE_GYROSCOPE_UNCALIBRATED)
    private val accelerometer = ShadowSensor.newInstance(Sensor.TYPE_ACCELEROMETER)
    private val random = Random(1)
    private var nowNs = 7_000_000_000_000L

    @Before
    fun sensors() = listOf(gyroscope, accelerometer).forEach { shadowOf(manager).addSensor(it) }

    @Test
    fun `a swing is measured on a boat`() {
        rule.onNodeWithText("Measure a boat").performClick()
        for ((label, text) in listOf("Name" to "Finn", "Mass of all that hangs, kg" to "120", "Length overall, m" to "4.5", "Beam, m" to "1.5")) {
            rule.onNodeWithText(label).performScrollTo().performTextInput(text)
        }
        click("Plan the swings")
        rule.patient("the plan") { rule.exists("To the boat") }
        rule.shot("8-plan")
        click("To the boat")
        reach(ProcedurePhase.START)
        click("Begin")
        reach(ProcedurePhase.LEVEL)
        feed(5.0)
        rule.patient("level") { abs(state?.tilt?.bowUpDeg ?: 90.0) < 0.2 && rule.exists("Accept") }
        rule.shot("9-level-flat")
        click("Accept")
        reach(ProcedurePhase.REST)
        feed(20.0)
        rule.patient("the rest") { state?.rest?.found != null && rule.exists("Accept") }
        assertEquals(200.0, state!!.rest!!.found!!.gyroscope.rateHz, 0.1)
        click("Accept")
        reach(ProcedurePhase.HANG)
        rule.shot("10-hang")
        click("As typed")
        reach(ProcedurePhase.READY)
        click("Start the recording")
        reach(ProcedurePhase.RECORD)
        feed(3.0)
        feed(40.0) { t -> 0.1 * (exp(-t / 300) * cos(2 * PI * t / PERIOD_S)) }
        rule.patient("a period") { (state?.recording?.live?.swing?.atS ?: 0.0) > 25.0 }
        rule.shot("11-swing-live")
        val swing = state!!.recording!!.live!!.swing!!
        assertTrue("$swing", abs(swing.periodS - PERIOD_S) < 5 * swing.periodUS)
        click("Stop")
        reach(ProcedurePhase.JUDGE)
        rule.shot("12-judge")
    }

    /** So many seconds of sensor events; [angle] is that about the phone's z axis, rad, s after they begin. */
    private fun feed(seconds: Double, angle: (Double) -> Double = { 0.0 }) {
        val fromNs = nowNs
        while (nowNs < fromNs + (seconds * 1e9).toLong()) {
            val t = (nowNs - fromNs) / 1e9
            send(gyroscope, floatArrayOf(noise(), noise(), ((angle(t + H) - angle(t - H)) / (2 * H)).toFloat() + noise()))
            send(accelerometer, floatArrayOf(noise(), noise(), 9.81f + noise()))
            nowNs += 5_000_000
        }
    }

    private fun send(sensor: Sensor, values: FloatArray) {
        val event = SensorEventBuilder.newBuilder(sensor, values).setTimestamp(nowNs).build()
        shadowOf(manager).sendSensorEventToListeners(event)
    }

    private fun noise() = random.nextDouble(-1e-3, 1e-3).toFloat()

    private fun click(text: String) {
        rule.patient(text) { rule.exists(text) }
        rule.onNodeWithText(text).performScrollTo().performClick()
    }

    private fun reach(phase: ProcedurePhase) = rule.patient(phase.name) { state?.phase == phase }

    private companion object {
        const val PERIOD_S = 3.1
        const val H = 1e-4
    }
}
