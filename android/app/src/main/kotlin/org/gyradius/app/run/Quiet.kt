package org.gyradius.app.run

import org.gyradius.Channel
import org.gyradius.Samples

/** Which streams have fallen silent. Looks are counted, not time: while the phone gave the app no time at all, none was made,
 * and what came meanwhile is still there at the next. */
internal class Quiet(channels: Collection<Channel>) {
    private val lookedInVain = channels.associateWith { 0 }.toMutableMap()

    /** Streams that have given nothing for [LOOKS]. */
    val silent: Set<Channel>
        get() = lookedInVain.filterValues { it >= LOOKS }.keys

    /** Takes what one look found; returns the streams that have just fallen silent. */
    fun look(found: List<Samples>): Set<Channel> {
        val before = silent
        val heard = found.map { it.channel }
        lookedInVain.replaceAll { channel, looks -> if (channel in heard) 0 else looks + 1 }
        return silent - before
    }

    private companion object {
        /** Of [RunModel.LOOK_MS] each: seen before a second is over. */
        const val LOOKS = 8
    }
}
