package org.gyradius.app.run

import org.gyradius.Channel
import org.gyradius.Samples

/** Which streams have fallen silent. */
internal class Quiet(channels: Collection<Channel>) {
    private val lookedInVain = channels.associateWith { 0 }.toMutableMap()
    private val newestNs = mutableMapOf<Channel, Long>()
    private var behind = emptySet<Channel>()

    /** Streams that have given nothing for [LOOKS]. Looks are counted, not time: while the phone gave the app no time at all,
     * none was made, and what came meanwhile is still there at the next. */
    val silent: Set<Channel>
        get() = behind + lookedInVain.filterValues { it >= LOOKS }.keys

    /** Takes what one look found; returns the streams that have certainly stopped: left behind by another's stamps, or all of them,
     * where so many looks found nothing that the app cannot just have been held up. */
    fun look(found: List<Samples>): Set<Channel> {
        val heard = found.associate { it.channel to it.stampsNs.last() }
        lookedInVain.replaceAll { channel, looks -> if (channel in heard) 0 else looks + 1 }
        newestNs += heard
        if (lookedInVain.values.all { it >= LOOKS_OF_ALL }) return lookedInVain.keys.toSet()
        val newest = newestNs.values.maxOrNull() ?: return emptySet()
        behind = lookedInVain.keys.filterTo(mutableSetOf()) { newest - (newestNs[it] ?: newest) > MOST_BEHIND_NS }
        return behind
    }

    private companion object {
        /** Of [RunModel.LOOK_MS] each: seen before a second is over. */
        const val LOOKS = 8

        /** Of the same: three seconds. */
        const val LOOKS_OF_ALL = 30

        /** Longer than a sensor's own memory holds its samples back. */
        const val MOST_BEHIND_NS = 800_000_000L
    }
}
