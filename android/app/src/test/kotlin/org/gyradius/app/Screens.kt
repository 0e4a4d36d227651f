package org.gyradius.app

import android.graphics.Bitmap
import androidx.compose.ui.graphics.asAndroidBitmap
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.SemanticsMatcher
import androidx.compose.ui.test.captureToImage
import androidx.compose.ui.test.junit4.ComposeTestRule
import androidx.compose.ui.test.onAllNodesWithText
import androidx.compose.ui.test.onRoot
import androidx.core.content.FileProvider
import java.io.File

/** Keeps what the screen shows as a PNG, where pictures are asked for. */
fun ComposeTestRule.shot(name: String) {
    val folder = System.getProperty("gyradius.shots")?.takeIf { it.isNotEmpty() } ?: return
    File(folder).mkdirs()
    waitForIdle()
    val bitmap = onRoot().captureToImage().asAndroidBitmap()
    File(folder, "$name.png").outputStream().use { bitmap.compress(Bitmap.CompressFormat.PNG, 100, it) }
}

/** A slow machine is not a failure. */
private const val PATIENCE_MS = 120_000L

/** Waits in real time for what the library's threads bring about; the message says what for. */
fun ComposeTestRule.patient(what: String, holds: () -> Boolean) {
    try {
        // What is posted to the main thread runs while it is idle, and nothing else lets it be so here.
        waitUntil(timeoutMillis = PATIENCE_MS) {
            waitForIdle()
            holds()
        }
    } catch (late: Throwable) {
        throw AssertionError("waited in vain for $what; on the screen: ${texts()}", late)
    }
}

/** Whether a text is on the screen, or can be scrolled to. */
fun ComposeTestRule.exists(text: String): Boolean = onAllNodesWithText(text).fetchSemanticsNodes().isNotEmpty()

/** Everything that can be read on the screen. */
fun ComposeTestRule.texts(): List<String> =
    onAllNodes(SemanticsMatcher.keyIsDefined(SemanticsProperties.Text)).fetchSemanticsNodes()
        .flatMap { it.config[SemanticsProperties.Text] }.map { it.text }

/** Each test has folders of its own, but what offers files to other apps remembers those of the first that asked. */
fun forgetSharedFolders() {
    val remembered = FileProvider::class.java.getDeclaredField("sCache").apply { isAccessible = true }
    (remembered.get(null) as MutableMap<*, *>).clear()
}
