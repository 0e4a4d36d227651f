package org.gyradius.app.run

import org.gyradius.Channel
import org.gyradius.Samples

/** What the live trace shows: the last seconds of the three rates, thinned for the screen; layout, no science. */
class Trace(private val seconds: Double = 12.0) {
    /** A moment: s since the first sample, and the rates about x, y and z, rad/s. */
    class Point(val atS: Double, val x: Float, val y: Float, val z: Float)

    private val points = ArrayDeque<Point>()
    private var firstNs: Long? = null

    /** Takes every fourth sample of the gyroscope: fifty points a second. */
    fun take(samples: Samples) {
        if (samples.channel != Channel.GYROSCOPE) return
        for (at in samples.stampsNs.indices step THIN) {
            val first = firstNs ?: samples.stampsNs[at].also { firstNs = it }
            val xyz = FloatArray(3) { samples.values[3 * at + it].toFloat() }
            points += Point((samples.stampsNs[at] - first) / 1e9, xyz[0], xyz[1], xyz[2])
        }
        while (points.isNotEmpty() && points.last().atS - points.first().atS > seconds) points.removeFirst()
    }

    /** Begins anew. */
    fun clear() {
        points.clear()
        firstNs = null
    }

    /** As it is now. */
    fun points(): List<Point> = points.toList()

    private companion object {
        const val THIN = 4
    }
}
