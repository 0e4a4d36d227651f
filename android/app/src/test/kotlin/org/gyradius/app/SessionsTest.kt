package org.gyradius.app

import android.app.Activity
import android.content.Intent
import android.net.Uri
import androidx.compose.ui.test.junit4.createAndroidComposeRule
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performScrollTo
import androidx.test.ext.junit.runners.AndroidJUnit4
import java.io.File
import java.io.FilterInputStream
import java.util.zip.ZipFile
import kotlinx.coroutines.runBlocking
import org.gyradius.ProcedureEvent
import org.gyradius.ProcedurePhase
import org.junit.Assert.assertEquals
import org.junit.Assert.assertFalse
import org.junit.Assert.assertTrue
import org.junit.Rule
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.Shadows.shadowOf

/** What can be done with sessions in their list. */
@RunWith(AndroidJUnit4::class)
class SessionsTest {
    @get:Rule
    val rule = createAndroidComposeRule<MainActivity>()

    private val park = Park()

    @Test
    fun `what was deleted comes back, until nobody can want it back`() {
        recorded()
        click("Delete")
        rule.patient("the way back") { rule.exists("Finn was deleted") && !rule.exists("Share") }
        assertTrue(park.folder.exists())
        rule.onNodeWithText("Undo").performClick()
        rule.patient("the session again") { rule.exists("Share") }
        click("Delete")
        rule.patient("the way back") { rule.exists("Finn was deleted") }
        rule.mainClock.advanceTimeBy(LONGER_THAN_A_SNACKBAR_MS)
        rule.patient("the files gone") { !park.folder.exists() }
    }

    @Test
    fun `what was shared is a zip that goes on wherever it is imported`() {
        recorded()
        val zip = runBlocking { park.app.store.share(park.app.store.list().single()) }
        val names = ZipFile(zip).use { packed -> packed.entries().toList().map { it.name } }
        assertTrue("$names", "procedure/procedure.journal" in names && names.any { it.startsWith("procedure/takes/01-") })
        import(Uri.fromFile(zip))
        rule.patient("both of them") { park.sessions().size == 2 }
        assertEquals(take(park.folder), take(park.sessions().first { it != park.folder }))
    }

    @Test
    fun `what is shared is offered to other apps, to be read by the chosen one alone`() {
        forgetSharedFolders()
        recorded()
        click("Share")
        var chooser: Intent? = null
        rule.patient("the chooser") {
            chooser = chooser ?: shadowOf(rule.activity).nextStartedActivity
            chooser != null
        }
        val offered = chooser!!.getParcelableExtra(Intent.EXTRA_INTENT, Intent::class.java)!!
        assertEquals("application/zip", offered.type)
        assertEquals(Intent.FLAG_GRANT_READ_URI_PERMISSION, offered.flags and Intent.FLAG_GRANT_READ_URI_PERMISSION)
        val uri = offered.getParcelableExtra(Intent.EXTRA_STREAM, Uri::class.java)!!
        assertEquals("content://org.gyradius.app.files/shared/Finn.zip", "$uri")
    }

    @Test
    fun `a recording of another app is taken in`() {
        import(Uri.fromFile(File(park.app.cacheDir, "Gyroscope.csv").apply { writeText(recording()) }))
        rule.patient("the recording in the list") { rule.exists("From a file") && rule.exists("Open") }
    }

    @Test
    fun `a file is in no list until it is whole`() {
        val seen = mutableListOf<Int>()
        val arriving = object : FilterInputStream(recording().byteInputStream()) {
            override fun read(bytes: ByteArray, from: Int, count: Int): Int {
                seen += park.sessions().size
                return super.read(bytes, from, count)
            }
        }
        val listed = runBlocking { park.app.store.import("Gyroscope.csv", arriving) }
        assertEquals(setOf(0), seen.toSet())
        assertEquals(listOf(listed.folder), park.sessions())
    }

    @Test
    fun `a file that is no recording is refused in words and leaves nothing behind`() {
        import(Uri.fromFile(File(park.app.cacheDir, "notes.csv").apply { writeText("mast, boom\n") }))
        rule.patient("an error") { rule.texts().any { "notes.csv" in it } }
        assertFalse(rule.exists("Share"))
        assertEquals(emptyList<File>(), park.sessions())
    }

    private fun recording(): String {
        val header = listOf("Time (s)", "Gyroscope x (rad/s)", "Gyroscope y (rad/s)", "Gyroscope z (rad/s)").joinToString(",") { "\"$it\"" }
        val rows = (0..400).joinToString("\n") { "${it / 200.0},0.001,0.002,0.0005" }
        return "$header\n$rows\n"
    }

    /** A session with one recording, seen in the list. */
    private fun recorded() {
        park.record()
        park.phone.rest(5.0)
        park.model.handle(ProcedureEvent.StopRecording)
        park.reach(ProcedurePhase.JUDGE)
        rule.waitForIdle()
        park.leave()
        rule.patient("the list") { rule.exists("Share") }
    }

    /** The system's picker opens, and a file is chosen. */
    private fun import(uri: Uri) {
        click("Open a file")
        val activity = shadowOf(rule.activity)
        val asked = activity.nextStartedActivityForResult
        assertEquals(Intent.ACTION_OPEN_DOCUMENT, asked.intent.action)
        activity.receiveResult(asked.intent, Activity.RESULT_OK, Intent().setData(uri))
    }

    private fun take(folder: File) = park.take(folder).readBytes().toList()

    private fun click(text: String) {
        rule.patient(text) { rule.exists(text) }
        rule.onNodeWithText(text).performScrollTo().performClick()
    }

    private companion object {
        const val LONGER_THAN_A_SNACKBAR_MS = 11_000L
    }
}
