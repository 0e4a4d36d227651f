package org.gyradius.app.ui

import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.res.stringResource
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.hypot
import kotlin.math.sin
import org.gyradius.NamedQuantity
import org.gyradius.app.R
import org.gyradius.number

/** The principal axes, as long as their gyradii, and the ellipsoid through their ends: bow to the right, seen a little from above. */
@Composable
fun Ellipsoid(quantities: List<NamedQuantity>) {
    val gyradiiM = quantities.three("principal_gyradii_m") ?: return
    val psiDeg = quantities.firstOrNull { it.name == "psi_deg" }?.quantity?.value?.number ?: 0.0
    val axes = principalAxes(gyradiiM, psiDeg)
    val style = MaterialTheme.typography.labelLarge
    val names = listOf(R.string.motion_roll, R.string.motion_pitch, R.string.motion_yaw).map { stringResource(it) }
    val bow = stringResource(R.string.bow)
    SectionHead(stringResource(R.string.ellipsoid))
    Sketch(R.string.sketch_ellipsoid, 0.8f) {
        val scale = 0.36f / gyradiiM.max().toFloat()
        for ((one, other) in listOf(0 to 1, 1 to 2, 0 to 2)) ring(axes[one], axes[other], scale)
        axes.zip(names).forEach { (axis, name) ->
            val (x, y) = axis.seen(scale)
            line(1 - x, 0.8f - y, x, y, accent)
            dot(x, y)
            val long = hypot(x - MIDDLE_X, y - MIDDLE_Y)
            val beyond = 1 + NAME_AWAY / long
            words(MIDDLE_X + beyond * (x - MIDDLE_X), MIDDLE_Y + beyond * (y - MIDDLE_Y), name, style)
        }
        words(0.93f, 0.74f, "$bow →", style, ink)
    }
    Text(stringResource(R.string.ellipsoid_says), style = MaterialTheme.typography.bodyLarge)
}

/** A point in hull axes: x to the bow, y to port, z up. */
private class Point(val x: Double, val y: Double, val z: Double) {
    /** Where it stands in the picture: a parallel projection from starboard, ahead of the beam and above. */
    fun seen(scale: Float): Pair<Float, Float> {
        val right = x * cos(TURN) + y * sin(TURN)
        val away = -x * sin(TURN) + y * cos(TURN)
        val up = z * cos(RISE) + away * sin(RISE)
        return MIDDLE_X + scale * right.toFloat() to MIDDLE_Y - scale * up.toFloat()
    }

    companion object {
        const val TURN = PI / 6
        const val RISE = PI / 8
    }
}

/** Roll, pitch and yaw axis; psi is bow up. */
private fun principalAxes(gyradiiM: List<Double>, psiDeg: Double): List<Point> {
    val psi = Math.toRadians(psiDeg)
    val (roll, pitch, yaw) = gyradiiM
    return listOf(Point(roll * cos(psi), 0.0, roll * sin(psi)), Point(0.0, pitch, 0.0), Point(-yaw * sin(psi), 0.0, yaw * cos(psi)))
}

private fun Pen.ring(one: Point, other: Point, scale: Float) = shape(fill = null) {
    for (step in 0 until STEPS) {
        val angle = 2 * PI * step / STEPS
        val (c, s) = cos(angle) to sin(angle)
        val (x, y) = Point(c * one.x + s * other.x, c * one.y + s * other.y, c * one.z + s * other.z).seen(scale)
        if (step == 0) moveTo(x, y) else lineTo(x, y)
    }
}

private const val STEPS = 72

/** So far from its end the name of an axis stands. */
private const val NAME_AWAY = 0.08f
private const val MIDDLE_X = 0.5f
private const val MIDDLE_Y = 0.4f
