package org.gyradius.app

import androidx.compose.ui.test.junit4.createAndroidComposeRule
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performScrollTo
import androidx.lifecycle.Lifecycle
import androidx.test.ext.junit.runners.AndroidJUnit4
import com.sun.jna.Library
import com.sun.jna.Native
import java.io.File
import kotlin.concurrent.thread
import org.gyradius.Channel
import org.gyradius.DamageKind
import org.gyradius.Procedure
import org.gyradius.ProcedureEvent
import org.gyradius.ProcedurePhase
import org.gyradius.RecorderFile
import org.junit.After
import org.junit.Assert.assertEquals
import org.junit.Assert.assertFalse
import org.junit.Assert.assertTrue
import org.junit.Rule
import org.junit.Test
import org.junit.runner.RunWith

/** What goes wrong in the middle of a recording, and what is left of it. */
@RunWith(AndroidJUnit4::class)
class TroubleTest {
    @get:Rule
    val rule = createAndroidComposeRule<MainActivity>()

    private val park = Park()

    @After
    fun leave() {
        limitFiles(UNLIMITED)
        park.leave()
    }

    @Test
    fun `a turn of the screen loses no sample`() {
        park.record()
        val before = park.phone.sent
        val feeding = thread { park.phone.rest(60.0) }
        rule.activityRule.scenario.recreate()
        feeding.join()
        click("Stop")
        park.reach(ProcedurePhase.JUDGE)
        val sent = park.phone.sent - before
        assertEquals(mapOf(Channel.GYROSCOPE to sent, Channel.ACCELEROMETER to sent), park.recorded())
    }

    @Test
    fun `a call that covers the app loses no sample`() {
        park.record()
        val before = park.phone.sent
        park.phone.rest(5.0)
        rule.activityRule.scenario.moveToState(Lifecycle.State.CREATED)
        park.phone.rest(30.0)
        rule.activityRule.scenario.moveToState(Lifecycle.State.RESUMED)
        park.phone.rest(5.0)
        click("Stop")
        park.reach(ProcedurePhase.JUDGE)
        val sent = park.phone.sent - before
        assertEquals(40 * Phone.RATE_HZ, sent)
        assertEquals(mapOf(Channel.GYROSCOPE to sent, Channel.ACCELEROMETER to sent), park.recorded())
    }

    @Test
    fun `an app that is killed in a recording goes on with it`() {
        park.record()
        park.phone.rest(10.0)
        park.await("ten seconds") { (it.state?.recording?.recordedS ?: 0.0) > 9.9 }
        // The disk as it is at that moment; what the app then does in closing is undone.
        val asKilled = File(park.app.cacheDir, "killed").also { park.folder.copyRecursively(it) }
        park.leave()
        park.folder.deleteRecursively()
        asKilled.copyRecursively(park.folder)
        park.app.onCreate()
        rule.activityRule.scenario.recreate()
        rule.patient("the session in the list") { rule.exists("Cut off") }
        rule.shot("13-cut-off-in-list")
        click("Go on")
        park.reach(ProcedurePhase.INTERRUPTED)
        click("Go on with it")
        park.reach(ProcedurePhase.RECORD)
        park.phone.rest(5.0)
        click("Stop")
        park.reach(ProcedurePhase.JUDGE)
        assertLost(atMost = Phone.RATE_HZ / 2, of = 15 * Phone.RATE_HZ)
        val damage = RecorderFile.read(park.take().path).use { file -> file.damage().map { it.kind } }
        assertEquals(listOf(DamageKind.RESUMED), damage)
    }

    @Test
    fun `a sensor that stops is shown, and the recording knows`() {
        park.record()
        park.phone.rest(5.0)
        park.await("samples") { (it.state?.recording?.recordedS ?: 0.0) > 4.9 && it.silent.isEmpty() }
        val accelerometer = listOf(park.phone.accelerometer)
        val feeding = thread {
            repeat(3_000) { at -> if (at < 400 || park.model.shown.value.silent.isEmpty()) park.phone.rest(0.005, accelerometer) }
        }
        park.await("silence") { Channel.GYROSCOPE in it.silent }
        rule.patient("the word on it") { rule.exists("The gyroscope gives nothing. If this stays, restart the phone.") }
        feeding.join()
        park.phone.rest(2.0)
        park.await("samples again") { it.silent.isEmpty() }
        click("Stop")
        park.reach(ProcedurePhase.JUDGE)
        assertTrue("${park.marks()}", "sensor stopped gyroscope" in park.marks())
    }

    @Test
    fun `sensors that all stop for good are shown, and the recording knows`() {
        park.record()
        park.phone.rest(5.0)
        park.await("samples") { (it.state?.recording?.recordedS ?: 0.0) > 4.9 }
        park.await("silence") { it.silent == setOf(Channel.GYROSCOPE, Channel.ACCELEROMETER) }
        val stopped = listOf("gyroscope", "accelerometer").map { "sensor stopped $it" }
        rule.patient("the marks") { park.marks().containsAll(stopped) }
        // The app ends, and they never came back: the file and the judgement tell.
        park.leave()
        assertEquals(stopped.toSet(), park.marks().toSet() - "release")
        Procedure.open(park.folder.path).use { procedure ->
            procedure.handle(ProcedureEvent.Keep)
            assertEquals(2, procedure.state().judgement!!.reasons.count { it.key == "reason_silent" })
        }
    }

    @Test
    fun `a full disk is told, what was recorded stays, and it goes on when there is room`() {
        park.record()
        park.phone.rest(10.0)
        park.await("ten seconds") { (it.state?.recording?.recordedS ?: 0.0) > 9.9 }
        limitFiles(park.take().length() + 20_000)
        park.phone.rest(10.0)
        park.reach(ProcedurePhase.INTERRUPTED)
        rule.patient("one sentence on it") { rule.texts().count { "The disk is full" in it } == 1 }
        assertEquals(null, park.model.shown.value.error)
        assertFalse("${rule.texts()}", rule.texts().any { "cannot be written" in it || "/takes/" in it })
        // There is still no room: the app's own sentence takes the other's place.
        limitFiles(1_000)
        click("Go on with it")
        rule.patient("what to do") { rule.texts().count { "storage is full" in it } == 1 && rule.texts().none { "The disk is full" in it } }
        limitFiles(UNLIMITED)
        rule.shot("14-full-disk")
        click("Go on with it")
        park.reach(ProcedurePhase.RECORD)
        park.phone.rest(10.0)
        click("Stop")
        park.reach(ProcedurePhase.JUDGE)
        // Twenty of thirty seconds at least: those before the disk was full, and those after.
        assertLost(atMost = 10 * Phone.RATE_HZ, of = 30 * Phone.RATE_HZ)
    }

    private fun assertLost(atMost: Int, of: Int) = park.recorded().forEach { (channel, samples) ->
        assertTrue("$channel has $samples of $of", samples in of - atMost..of)
    }

    private fun click(text: String) {
        rule.patient(text) { rule.exists(text) }
        rule.onNodeWithText(text).performScrollTo().performClick()
    }

    /** The system refuses what would make a file longer than that, as it does on a full disk. */
    private fun limitFiles(bytes: Long) = assertEquals(0, libc.setrlimit(RLIMIT_FSIZE, longArrayOf(bytes, UNLIMITED)))

    interface C : Library {
        fun setrlimit(resource: Int, currentAndMost: LongArray): Int
    }

    private companion object {
        const val RLIMIT_FSIZE = 1
        const val UNLIMITED = -1L
        val libc: C by lazy { Native.load("c", C::class.java) }
    }
}
