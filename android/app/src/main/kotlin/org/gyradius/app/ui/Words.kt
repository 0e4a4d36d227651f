package org.gyradius.app.ui

import androidx.annotation.StringRes
import androidx.compose.runtime.Composable
import androidx.compose.ui.res.stringResource
import org.gyradius.Excitation
import org.gyradius.Language
import org.gyradius.ModeName
import org.gyradius.PlanWarning
import org.gyradius.Sentence
import org.gyradius.SideMotionKind
import org.gyradius.app.Failure
import org.gyradius.app.R
import org.gyradius.causeIn
import org.gyradius.idIn
import org.gyradius.inputIn
import org.gyradius.quantityIn
import org.gyradius.routeIn
import org.gyradius.sentenceIn
import org.gyradius.warningIn

/** A sentence of the library as the screen shows it: the one place that chooses its language. */
@Composable
fun spoken(sentence: Sentence): String = asShown(sentenceIn(sentence, libraryLanguage()))

/** A warning of the plan in the language of the screen. */
@Composable
fun spoken(warning: PlanWarning): String = asShown(warningIn(warning, libraryLanguage()))

/** A text that ends in a unit; the degree sign stands close to its figure. */
@Composable
internal fun inUnit(@StringRes text: Int, vararg parts: Any): String = stringResource(text, *parts).replace("\u00A0°", "°")

/** With a capital at its head where that is a word, and no line that ends between a figure and its unit. */
internal fun asShown(sentence: String): String =
    sentence.replace(FIRST_OF_WORD) { it.value.uppercase() }.replace(BEFORE_UNIT, "\u00A0")

private val FIRST_OF_WORD = Regex("^[a-zäöü](?=[\\p{L} ])")

private val BEFORE_UNIT = Regex("(?<=\\d) (?=(?:s|min|mm|m|m/s²|mrad/s|rad/s|Hz|kg|ppm|%)(?![\\p{L}\\d]))")

@Composable
private fun libraryLanguage(): Language = Language.valueOf(stringResource(R.string.library_language))

/** What to set going, in words. */
@StringRes
internal fun wordOf(excited: Excitation): Int = when (excited) {
    Excitation.YAW -> R.string.motion_yaw
    Excitation.SWAY -> R.string.motion_sway
    Excitation.SURGE -> R.string.motion_surge
    Excitation.PITCH -> R.string.motion_pitch
    Excitation.ROLL -> R.string.motion_roll
}

/** How to set it going, in a few words. */
@StringRes
internal fun howTo(excited: Excitation): Int = when (excited) {
    Excitation.YAW -> R.string.how_yaw
    Excitation.SWAY -> R.string.how_sway
    Excitation.SURGE -> R.string.how_surge
    Excitation.PITCH -> R.string.how_pitch
    Excitation.ROLL -> R.string.how_roll
}

/** A mode of motion in words. */
@StringRes
internal fun wordOf(mode: ModeName): Int = when (mode) {
    ModeName.YAW -> R.string.mode_yaw
    ModeName.SWAY -> R.string.mode_sway
    ModeName.PITCH_IN_PHASE -> R.string.mode_pitch_in_phase
    ModeName.PITCH_OUT_OF_PHASE -> R.string.mode_pitch_out_of_phase
    ModeName.ROLL_IN_PHASE -> R.string.mode_roll_in_phase
    ModeName.ROLL_OUT_OF_PHASE -> R.string.mode_roll_out_of_phase
    ModeName.COMPOUND -> R.string.mode_compound
    ModeName.OTHER -> R.string.mode_other
}

/** What a motion beside the main one looks like. */
@StringRes
internal fun wordOf(kind: SideMotionKind): Int = when (kind) {
    SideMotionKind.SWAY -> R.string.kind_sway
    SideMotionKind.OTHER_TURN -> R.string.kind_other_turn
    SideMotionKind.SAME_TURN -> R.string.kind_same_turn
}

/** A type of boat by the library's name for it; a name without a word stands as it is. */
@Composable
internal fun boatType(name: String): String = when (name) {
    "keelboat" -> stringResource(R.string.type_keelboat)
    "dinghy" -> stringResource(R.string.type_dinghy)
    "model_keelboat" -> stringResource(R.string.type_model_keelboat)
    "uniform_bar" -> stringResource(R.string.type_uniform_bar)
    else -> name
}

/** A quantity by the library's name for it, in words. */
@Composable
internal fun quantityName(name: String): String = quantityIn(name, libraryLanguage())

/** A step or a swing by its id, in words where the library has them. */
@Composable
internal fun idName(id: String): String = idIn(id, libraryLanguage())

/** An input of a budget by its label, in words. */
@Composable
internal fun inputName(label: String): String = inputIn(label, libraryLanguage())

/** A single route to a quantity, in words. */
@Composable
internal fun routeName(method: String): String = routeIn(method, libraryLanguage())

/** A cause of what the simulation gets wrong, in words. */
@Composable
internal fun causeName(id: String): String = causeIn(id, libraryLanguage())

/** What went wrong, in words. */
@Composable
internal fun spoken(failure: Failure): String = when (failure) {
    Failure.DiskFull -> stringResource(R.string.disk_full)
    is Failure.Told -> failure.text
}
