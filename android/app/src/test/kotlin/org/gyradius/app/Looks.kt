package org.gyradius.app

import android.graphics.Bitmap
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.material3.Surface
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.key
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.asAndroidBitmap
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.semantics.SemanticsNode
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.semantics.getOrNull
import androidx.compose.ui.test.DarkMode
import androidx.compose.ui.test.DeviceConfigurationOverride
import androidx.compose.ui.test.FontScale
import androidx.compose.ui.test.ForcedSize
import androidx.compose.ui.test.Locales
import androidx.compose.ui.test.captureToImage
import androidx.compose.ui.test.junit4.ComposeContentTestRule
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onRoot
import androidx.compose.ui.test.then
import androidx.compose.ui.text.TextLayoutResult
import androidx.compose.ui.text.intl.LocaleList
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.DpSize
import androidx.compose.ui.unit.dp
import java.io.File
import java.util.Locale
import org.gyradius.app.ui.GyradiusTheme
import org.junit.Assert.assertTrue

/** How a screen is looked at. */
class Look(
    val name: String,
    val size: DpSize,
    val isDark: Boolean = false,
    val fontScale: Float = 1f,
    val language: String = "en",
)

private val PHONE = DpSize(411.dp, 891.dp)

/** As much of a long screen as there is, on a phone's width. */
private val UNROLLED = DpSize(411.dp, 2600.dp)
private val TABLET = DpSize(1280.dp, 800.dp)

/** Light and dark, phone and tablet, type once and twice as large, English and German. */
val LOOKS = listOf(
    Look("phone", PHONE),
    Look("long", UNROLLED),
    Look("phone-dark-de", UNROLLED, isDark = true, language = "de"),
    Look("phone-large", UNROLLED, fontScale = 2f),
    Look("turned-large-de", DpSize(891.dp, 411.dp), fontScale = 2f, language = "de"),
    Look("tablet-dark", TABLET, isDark = true),
    Look("tablet-large", TABLET, fontScale = 2f),
)

/** Draws a screen in every look, keeps pictures where they are asked for, and checks what can be checked of each; `prepare` may
 * touch it first. */
fun ComposeContentTestRule.looks(name: String, prepare: (Look) -> Unit = {}, content: @Composable () -> Unit) {
    var look by mutableStateOf(LOOKS.first())
    setContent {
        val device = DeviceConfigurationOverride.ForcedSize(look.size) then
            DeviceConfigurationOverride.DarkMode(look.isDark) then
            DeviceConfigurationOverride.FontScale(look.fontScale) then
            DeviceConfigurationOverride.Locales(LocaleList(look.language))
        DeviceConfigurationOverride(device) {
            key(look) { GyradiusTheme { Surface(Modifier.fillMaxSize().testTag(SCREEN)) { content() } } }
        }
    }
    val before = Locale.getDefault()
    val wrong = LOOKS.flatMap { one ->
        // Android does so itself where the phone's language changes.
        Locale.setDefault(Locale.forLanguageTag(one.language))
        look = one
        waitForIdle()
        prepare(one)
        waitForIdle()
        picture("$name-${one.name}")
        faults(one).map { "$name-${one.name}: $it" }
    }
    Locale.setDefault(before)
    assertTrue(wrong.joinToString("\n"), wrong.isEmpty())
}

private fun ComposeContentTestRule.picture(name: String) {
    val folder = System.getProperty("gyradius.shots")?.takeIf { it.isNotEmpty() } ?: return
    File(folder).mkdirs()
    val bitmap = onNodeWithTag(SCREEN).captureToImage().asAndroidBitmap()
    File(folder, "$name.png").outputStream().use { bitmap.compress(Bitmap.CompressFormat.PNG, 100, it) }
}

/** Text that is cut off, lies over other text or beside the screen; what is to be touched and is too small, or has no name for a
 * screen reader. */
private fun ComposeContentTestRule.faults(look: Look): List<String> {
    val nodes = onRoot(useUnmergedTree = true).fetchSemanticsNode().andBelow().filter { it.size.width > 0 && it.size.height > 0 }
    val texts = nodes.filter { it.config.contains(SemanticsProperties.Text) }
    val none = listOf("shows no text").filter { texts.isEmpty() }
    val cut = texts.filter { it.isCutOff }.map { "cut off: ${it.words}" }
    val beside = texts.filter { it.place.left < -1 || it.place.right > px(look.size.width) + 1 }.map { "beside the screen: ${it.words}" }
    return none + cut + beside + overlaps(texts) + tooSmall(nodes, px(look.size.height)) + nameless()
}

private fun overlaps(texts: List<SemanticsNode>): List<String> = texts.flatMapIndexed { at, one ->
    texts.drop(at + 1).filter { other ->
        val common = one.place.intersect(other.place)
        common.width > 1 && common.height > 1
    }.map { "${one.words} lies over ${it.words}" }
}

/** What is half scrolled away is as large as it is when it is not. */
private fun ComposeContentTestRule.tooSmall(nodes: List<SemanticsNode>, height: Float): List<String> =
    nodes.filter { it.config.contains(SemanticsActions.OnClick) && it.place.top >= 0 && it.place.bottom <= height }
        .filter { minOf(it.touchBoundsInRoot.width, it.touchBoundsInRoot.height) < px(LEAST_TARGET) - 1 }
        .map { "too small to touch: ${it.words}, ${it.touchBoundsInRoot}" }

private fun ComposeContentTestRule.nameless(): List<String> {
    val names = listOf(SemanticsProperties.Text, SemanticsProperties.ContentDescription)
    return onRoot().fetchSemanticsNode().andBelow()
        .filter { it.config.contains(SemanticsActions.OnClick) && names.none { name -> it.config.contains(name) } }
        .map { "nothing to be read aloud: node ${it.id} at ${it.place}" }
}

private fun ComposeContentTestRule.px(length: Dp) = with(density) { length.toPx() }

private fun SemanticsNode.andBelow(): List<SemanticsNode> = listOf(this) + children.flatMap { it.andBelow() }

/** Where it would be if nothing were scrolled away. */
private val SemanticsNode.place: Rect
    get() = Rect(positionInRoot, Size(size.width.toFloat(), size.height.toFloat()))

private val SemanticsNode.words: String
    get() = config.getOrNull(SemanticsProperties.Text)?.joinToString { it.text }
        ?: config.getOrNull(SemanticsProperties.ContentDescription)?.joinToString() ?: "node $id"

/** The layout that is asked for here is as wide as there is room, so that its own word on overflow says nothing. */
private val SemanticsNode.isCutOff: Boolean
    get() {
        val found = mutableListOf<TextLayoutResult>()
        config.getOrNull(SemanticsActions.GetTextLayoutResult)?.action?.invoke(found)
        return found.any { laid ->
            val lines = 0 until laid.lineCount
            val isWide = lines.any { laid.getLineRight(it) - laid.getLineLeft(it) > size.width + 1 || laid.isLineEllipsized(it) }
            isWide || laid.getLineBottom(lines.last) > size.height + 1
        }
    }

private val LEAST_TARGET = 48.dp
private const val SCREEN = "screen"
