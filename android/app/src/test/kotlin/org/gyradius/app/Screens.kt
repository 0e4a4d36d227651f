package org.gyradius.app

import android.graphics.Bitmap
import androidx.compose.ui.graphics.asAndroidBitmap
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.SemanticsMatcher
import androidx.compose.ui.test.captureToImage
import androidx.compose.ui.test.junit4.ComposeTestRule
import androidx.compose.ui.test.onAllNodesWithText
import androidx.compose.ui.test.onRoot
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
        waitUntil(timeoutMillis = PATIENCE_MS, condition = holds)
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
