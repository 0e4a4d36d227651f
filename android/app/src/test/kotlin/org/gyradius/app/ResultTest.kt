package org.gyradius.app

import android.content.Intent
import android.net.Uri
import android.os.Bundle
import android.os.CancellationSignal
import android.os.Handler
import android.os.Looper
import android.os.ParcelFileDescriptor
import android.print.PageRange
import android.print.PrintAttributes
import android.print.PrintDocumentAdapter
import android.print.PrintJob
import android.print.PrintManager
import android.webkit.WebView
import androidx.compose.ui.test.junit4.createAndroidComposeRule
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performScrollTo
import androidx.compose.ui.test.performTextReplacement
import androidx.test.ext.junit.runners.AndroidJUnit4
import kotlinx.coroutines.runBlocking
import org.junit.Assert.assertEquals
import org.junit.Assert.assertTrue
import org.junit.Before
import org.junit.Rule
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.Shadows.shadowOf
import org.robolectric.annotation.Implementation
import org.robolectric.annotation.Implements
import org.robolectric.annotation.RealObject
import org.robolectric.shadows.ShadowWebView

/** A session that was opened: what is kept with it, its report shared and printed. */
@RunWith(AndroidJUnit4::class)
class ResultTest {
    @get:Rule
    val rule = createAndroidComposeRule<MainActivity>()

    private val store get() = (rule.activity.application as GyradiusApp).store

    @Before
    fun open() {
        forgetSharedFolders()
        val listed = runBlocking { store.import("boat-park.zip", Core.boatParkZip.inputStream()) }
        // As an earlier criticism left it.
        Core.dragged.keep(listed.folder.path)
        rule.activityRule.scenario.recreate()
        click("Open")
        rule.patient("the result") { rule.exists("Share the report") }
    }

    @Test
    fun `a criticism that was kept has its curves`() {
        val swing = Core.dragged.compared().first().swing
        rule.patient("the curves") { rule.exists("Measured and simulated: $swing") }
    }

    @Test
    fun `class limits are kept with the session and offered for the next`() {
        click("Class limits")
        click("Add a limit")
        rule.onNodeWithText("Limit, m").performScrollTo().performTextReplacement("1,1")
        click("Judge by these limits")
        rule.patient("the verdict") { rule.texts().any { "Yaw gyradius ≥\u00A01.1\u00A0m" in it } }
        rule.patient("the limits kept") { store.usualLimits() == listOf("k_yaw_m>=1.1") }
        assertEquals(listOf("k_yaw_m>=1.1"), runBlocking { store.list() }.map { store.measurable(it.folder)!!.limits }.single())
        click("Share the report")
        val report = rule.activity.contentResolver.openInputStream(offered())!!.use { it.reader().readText() }
        assertTrue("a verdict in the report", "probability that the hull conforms" in report)
    }

    @Test
    fun `the report is offered as a page that the chosen app can read`() {
        click("Share the report")
        val uri = offered()
        assertEquals("content://org.gyradius.app.files/shared/report.html", "$uri")
        assertEquals("text/html", rule.activity.contentResolver.getType(uri))
        val report = rule.activity.contentResolver.openInputStream(uri)!!.use { it.reader().readText() }
        assertTrue("a page", report.startsWith("<!doctype html>", ignoreCase = true) && "Open keelboat in the boat park" in report)
    }

    @Test
    fun `the report is laid out and handed to the printer`() {
        RecordingPrinter.printed.clear()
        click("Print, or save as PDF")
        rule.patient("the printer") { RecordingPrinter.printed.isNotEmpty() }
        val (name, page) = RecordingPrinter.printed.single()
        assertEquals("Report", name)
        assertTrue("the report itself", page.startsWith("<!doctype html>", ignoreCase = true) && page.trimEnd().endsWith("</html>"))
    }

    /** What the system's chooser is asked to hand over. */
    private fun offered(): Uri {
        var chooser: Intent? = null
        rule.patient("the chooser") {
            chooser = chooser ?: shadowOf(rule.activity).nextStartedActivity
            chooser != null
        }
        val offered = chooser!!.getParcelableExtra(Intent.EXTRA_INTENT, Intent::class.java)!!
        assertEquals(Intent.ACTION_SEND to "text/html", offered.action to offered.type)
        assertEquals(Intent.FLAG_GRANT_READ_URI_PERMISSION, offered.flags and Intent.FLAG_GRANT_READ_URI_PERMISSION)
        return offered.getParcelableExtra(Intent.EXTRA_STREAM, Uri::class.java)!!
    }

    private fun click(text: String) {
        rule.patient(text) { rule.exists(text) }
        rule.onNodeWithText(text).performScrollTo().performClick()
    }
}

/** A web view that has laid its page out at once, and can print what it was given. */
@Implements(WebView::class)
class LaidOutPage : ShadowWebView() {
    @RealObject
    private lateinit var view: WebView

    @Implementation
    public override fun loadDataWithBaseURL(base: String?, data: String?, type: String?, encoding: String?, history: String?) {
        super.loadDataWithBaseURL(base, data, type, encoding, history)
        // A view that is on no screen would keep what is posted to it.
        Handler(Looper.getMainLooper()).post { webViewClient?.onPageFinished(view, "about:blank") }
    }

    @Implementation
    fun createPrintDocumentAdapter(@Suppress("UNUSED_PARAMETER") name: String): PrintDocumentAdapter = Page(lastLoadDataWithBaseURL.data)

    /** A document whose content a test can look at. */
    class Page(val content: String) : PrintDocumentAdapter() {
        override fun onLayout(
            old: PrintAttributes?, new: PrintAttributes?, signal: CancellationSignal?, callback: LayoutResultCallback?,
            extras: Bundle?,
        ) = Unit

        override fun onWrite(
            pages: Array<out PageRange>?, to: ParcelFileDescriptor?, signal: CancellationSignal?,
            callback: WriteResultCallback?,
        ) = Unit
    }
}

/** Android's printing, which keeps what it is given. */
@Implements(PrintManager::class)
class RecordingPrinter {
    @Implementation
    fun print(name: String, document: PrintDocumentAdapter, @Suppress("UNUSED_PARAMETER") attributes: PrintAttributes?): PrintJob? {
        printed += name to (document as LaidOutPage.Page).content
        return null
    }

    companion object {
        val printed = mutableListOf<Pair<String, String>>()
    }
}
