package org.gyradius.app.ui

import androidx.annotation.StringRes
import java.io.Serializable
import org.gyradius.Means
import org.gyradius.PlanRequest
import org.gyradius.Quantity
import org.gyradius.RoughHull
import org.gyradius.app.R
import org.gyradius.usualPlanRequest

/** One number of the set-up, in the unit that its label tells. */
enum class Entry(@StringRes val label: Int) {
    MASS(R.string.boat_mass),
    LENGTH(R.string.boat_length),
    BEAM(R.string.boat_beam),
    MOST_LINE(R.string.most_line_m),
    LEAST_LINE(R.string.least_line_m),
    MOST_SPACING(R.string.most_spacing_m),
    LEAST_SPACING(R.string.least_spacing_m),
    U_LINE(R.string.u_line_m),
    U_SPACING(R.string.u_spacing_m),
    U_LEVEL(R.string.u_level_deg),
    AMPLITUDE(R.string.release_deg),
    LEAST_DURATION(R.string.least_duration_s),
    MOST_DURATION(R.string.most_duration_s),
    DECAY(R.string.decay_s),
    GYRO_NOISE(R.string.gyro_noise),
    ACC_NOISE(R.string.acc_noise),
    RATE(R.string.rate_hz),
}

/** A figure of the hull with its uncertainty, where somebody knows it. */
enum class Known(@StringRes val label: Int) {
    K_YAW(R.string.known_k_yaw),
    K_PITCH(R.string.known_k_pitch),
    K_ROLL(R.string.known_k_roll),
    DEPTH(R.string.known_depth),
    PSI(R.string.known_psi),
}

/** A quantity whose uncertainty can be wished for, or that a class limits. */
enum class Goal(val wanted: String, val unit: String, val measured: String) {
    K_YAW("k_yaw", "%", "k_yaw_m"),
    K_PITCH("k_pitch", "%", "k_pitch_m"),
    K_ROLL("k_roll", "%", "k_roll_m"),
    DEPTH("depth", "%", "cm_depth_m"),
    PSI("psi", "°", "psi_deg"),
}

/** A class limit as it stands in its fields. */
data class LimitTyped(val goal: Goal, val isLeast: Boolean, val value: String) : Serializable {
    /** As the library reads it, where there is a number. */
    fun text(): String? = numberIn(value)?.let { "${goal.measured}${if (isLeast) LEAST else MOST}$it" }

    companion object {
        private const val LEAST = ">="
        private const val MOST = "<="

        /** What [text] has written; anything else is no limit that has fields. */
        fun of(text: String): LimitTyped? {
            val isLeast = LEAST in text
            val (measured, value) = text.split(if (isLeast) LEAST else MOST).takeIf { it.size == 2 } ?: return null
            val goal = Goal.entries.firstOrNull { it.measured == measured } ?: return null
            return LimitTyped(goal, isLeast, withDecimalSign(value))
        }
    }
}

/** Everything that is typed in before a plan is made; it outlives a turn of the screen. */
internal data class SetupForm(
    val name: String = "",
    val type: String,
    val numbers: HashMap<Entry, String>,
    val gravity: Typed,
    val known: HashMap<Known, Typed> = HashMap(),
    val wanted: HashMap<Goal, String> = HashMap(),
    val limits: ArrayList<LimitTyped> = ArrayList(),
) : Serializable {
    fun with(entry: Entry, text: String) = copy(numbers = HashMap(numbers + (entry to text)))

    fun with(one: Known, typed: Typed) = copy(known = HashMap(known + (one to typed)))

    fun with(goal: Goal, text: String) = copy(wanted = HashMap(wanted + (goal to text)))

    fun with(limits: List<LimitTyped>) = copy(limits = ArrayList(limits))

    /** What is asked of the planner; a field that cannot be read keeps the library's default. */
    fun request(): PlanRequest {
        val usual = usualPlanRequest()
        val asked = wanted.mapNotNull { (goal, text) -> numberIn(text)?.let { "${goal.wanted}=$it${goal.unit}" } }
        return usual.copy(title = name, hull = hull(usual.hull), wanted = asked.ifEmpty { usual.wanted }, means = means(usual.means))
    }

    /** Class limits as the library reads them. */
    fun limitTexts(): List<String> = limits.mapNotNull { it.text() }

    private fun number(entry: Entry): Double? = numbers[entry]?.let(::numberIn)

    private fun quantity(one: Known): Quantity? = known[one]?.quantity()

    private fun hull(usual: RoughHull) = usual.copy(
        massKg = number(Entry.MASS),
        lengthM = number(Entry.LENGTH),
        beamM = number(Entry.BEAM),
        boatType = type,
        kYawM = quantity(Known.K_YAW),
        kPitchM = quantity(Known.K_PITCH),
        kRollM = quantity(Known.K_ROLL),
        cmDepthM = quantity(Known.DEPTH),
        psiDeg = quantity(Known.PSI),
    )

    private fun means(usual: Means) = Means(
        mostLineLengthM = number(Entry.MOST_LINE) ?: usual.mostLineLengthM,
        leastLineLengthM = number(Entry.LEAST_LINE) ?: usual.leastLineLengthM,
        mostSpacingM = number(Entry.MOST_SPACING),
        leastSpacingM = number(Entry.LEAST_SPACING),
        uLineLengthM = number(Entry.U_LINE) ?: usual.uLineLengthM,
        uSpacingM = number(Entry.U_SPACING) ?: usual.uSpacingM,
        uHullPitchDeg = number(Entry.U_LEVEL) ?: usual.uHullPitchDeg,
        gravityMS2 = gravity.quantity() ?: usual.gravityMS2,
        gyroNoiseRadS = number(Entry.GYRO_NOISE) ?: usual.gyroNoiseRadS,
        accNoiseMS2 = number(Entry.ACC_NOISE) ?: usual.accNoiseMS2,
        rateHz = number(Entry.RATE) ?: usual.rateHz,
        decayS = number(Entry.DECAY) ?: usual.decayS,
        amplitudeDeg = number(Entry.AMPLITUDE) ?: usual.amplitudeDeg,
        leastDurationS = number(Entry.LEAST_DURATION) ?: usual.leastDurationS,
        mostDurationS = number(Entry.MOST_DURATION) ?: usual.mostDurationS,
    )

    companion object {
        /** The library's defaults and the limits used last, to be seen and changed. */
        fun of(means: Means, type: String, usualLimits: List<String>): SetupForm {
            val numbers = mapOf(
                Entry.MOST_LINE to means.mostLineLengthM,
                Entry.LEAST_LINE to means.leastLineLengthM,
                Entry.U_LINE to means.uLineLengthM,
                Entry.U_SPACING to means.uSpacingM,
                Entry.U_LEVEL to means.uHullPitchDeg,
                Entry.AMPLITUDE to means.amplitudeDeg,
                Entry.LEAST_DURATION to means.leastDurationS,
                Entry.MOST_DURATION to means.mostDurationS,
                Entry.DECAY to means.decayS,
                Entry.GYRO_NOISE to means.gyroNoiseRadS,
                Entry.ACC_NOISE to means.accNoiseMS2,
                Entry.RATE to means.rateHz,
            )
            val gravity = Typed(asTyped(means.gravityMS2.value), asTyped(means.gravityMS2.u))
            val limits = ArrayList(usualLimits.mapNotNull(LimitTyped::of))
            return SetupForm(type = type, numbers = HashMap(numbers.mapValues { asTyped(it.value) }), gravity = gravity, limits = limits)
        }
    }
}
