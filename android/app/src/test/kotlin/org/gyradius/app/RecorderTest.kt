package org.gyradius.app

import android.os.Looper
import androidx.test.ext.junit.runners.AndroidJUnit4
import java.lang.management.ManagementFactory
import kotlin.concurrent.thread
import org.gyradius.Channel
import org.gyradius.ProcedureEvent
import org.gyradius.ProcedurePhase
import org.junit.Assert.assertEquals
import org.junit.Assert.assertTrue
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.Shadows.shadowOf
import org.robolectric.util.ReflectionHelpers

/** From the sensor's event to the recorder's file. */
@RunWith(AndroidJUnit4::class)
class RecorderTest {
    private val park = Park()

    @Test
    fun `ten minutes of six axes at 200 Hz are in the file, and cost the main thread nothing`() {
        park.record()
        val main = shadowOf(Looper.getMainLooper())
        // The start of the service, once.
        main.idle()
        val before = park.phone.sent
        val feeding = thread { park.phone.rest(600.0) }
        var longestNs = 0L
        while (feeding.isAlive) {
            while (!main.isIdle) longestNs = maxOf(longestNs, busyNs(main::runOneTask))
            feeding.join(5)
        }
        park.model.handle(ProcedureEvent.StopRecording)
        park.reach(ProcedurePhase.JUDGE)
        val sent = park.phone.sent - before
        assertEquals(120_000, sent)
        assertEquals(mapOf(Channel.GYROSCOPE to sent, Channel.ACCELEROMETER to sent), park.recorded())
        assertTrue("the main thread was busy for ${longestNs / 1e6} ms at a time", longestNs < 16_000_000)
    }

    @Test
    fun `the last samples before a stop are in the file, and nothing listens after the end`() {
        park.record()
        val before = park.phone.sent
        park.phone.rest(1.035)
        park.model.handle(ProcedureEvent.StopRecording)
        park.reach(ProcedurePhase.JUDGE)
        assertEquals(park.phone.sent - before, park.recorded()[Channel.GYROSCOPE])
        assertEquals(1, park.phone.listening)
        park.leave()
        assertEquals(0, park.phone.listening)
    }

    @Test
    fun `a sensor with a memory of its own sends batches, and another sends each sample at once`() {
        ReflectionHelpers.setField(park.phone.gyroscope, "mFifoReservedEventCount", 300)
        park.record()
        assertEquals(mapOf(park.phone.gyroscope to 100_000, park.phone.accelerometer to 0), park.phone.latenciesUs)
        park.leave()
    }

    /** Time that this thread worked; that it waited for the processor among others' threads is not its own doing. */
    private fun busyNs(what: () -> Unit): Long {
        val threads = ManagementFactory.getThreadMXBean()
        val fromNs = threads.currentThreadCpuTime
        what()
        return threads.currentThreadCpuTime - fromNs
    }
}
