package org.gyradius.app

import android.content.ComponentCallbacks2
import android.content.ComponentCallbacks2.TRIM_MEMORY_COMPLETE
import android.content.ComponentCallbacks2.TRIM_MEMORY_RUNNING_CRITICAL
import android.os.Bundle
import androidx.compose.ui.test.junit4.createEmptyComposeRule
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performScrollTo
import androidx.test.ext.junit.runners.AndroidJUnit4
import kotlin.concurrent.thread
import org.gyradius.Channel
import org.gyradius.ProcedurePhase
import org.gyradius.Sensor
import org.gyradius.app.service.RecorderService
import org.junit.After
import org.junit.Assert.assertEquals
import org.junit.Assert.assertFalse
import org.junit.Assert.assertTrue
import org.junit.Rule
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.Robolectric
import org.robolectric.Shadows.shadowOf
import org.robolectric.android.controller.ActivityController
import org.robolectric.android.controller.ServiceController

/** The system wants its memory back in the middle of a recording: it takes the screen away, and the sensors go on. */
@RunWith(AndroidJUnit4::class)
class LowMemoryTest {
    @get:Rule
    val rule = createEmptyComposeRule()

    private val park = Park()
    private lateinit var service: ServiceController<RecorderService>

    @After
    fun leave() {
        park.leave()
        service.destroy()
    }

    @Test
    fun `no sample is lost, and the screen comes back as it was`() {
        park.record()
        service = Robolectric.buildService(RecorderService::class.java).create().startCommand(0, 1)
        val before = park.phone.sent
        park.phone.rest(5.0)
        park.phone.pause(0.5)
        park.phone.rest(5.0)
        val screen = Robolectric.buildActivity(MainActivity::class.java).setup()
        rule.patient("the gaps") { rule.exists("Every gap") }
        rule.onNodeWithText("Every gap").performScrollTo().performClick()
        rule.patient("a gap") { isGapShown() }

        val feeding = thread { park.phone.rest(60.0) }
        val kept = takenAway(screen)
        assertTrue(screen.get().isDestroyed)
        feeding.join()
        // Nobody sees it, and it goes on.
        park.phone.rest(5.0)
        park.await("75 seconds") { (it.state?.recording?.recordedS ?: 0.0) > 75.0 }
        assertFalse(shadowOf(service.get()).isStoppedBySelf)

        Robolectric.buildActivity(MainActivity::class.java).setup(kept)
        rule.patient("the recording as it was left, its gaps unfolded") { rule.exists("Stop") && isGapShown() }
        rule.onNodeWithText("Stop").performScrollTo().performClick()
        park.reach(ProcedurePhase.JUDGE)
        val sent = park.phone.sent - before
        assertEquals(75 * Phone.RATE_HZ, sent)
        assertEquals(mapOf(Channel.GYROSCOPE to sent, Channel.ACCELEROMETER to sent), park.recorded())
        val gaps = park.state!!.judgement!!.gaps.listed
        assertEquals(setOf(Sensor.GYROSCOPE, Sensor.ACCELEROMETER), gaps.map { it.sensor }.toSet())
        assertEquals(2, gaps.size)
    }

    private fun isGapShown() = rule.texts().any { it.startsWith("5.0") && "Gyroscope, 0.5" in it }

    /** As the system does it: told that memory runs low, then out of sight, then destroyed, and the process the next to go. */
    private fun takenAway(screen: ActivityController<MainActivity>): Bundle {
        val kept = Bundle()
        screen.get().onTrimMemory(TRIM_MEMORY_RUNNING_CRITICAL)
        screen.pause().stop().saveInstanceState(kept).destroy()
        for (held in listOf<ComponentCallbacks2>(park.app, service.get())) {
            held.onTrimMemory(TRIM_MEMORY_COMPLETE)
            held.onLowMemory()
        }
        return kept
    }
}
