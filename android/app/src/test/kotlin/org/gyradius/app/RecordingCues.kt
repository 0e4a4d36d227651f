package org.gyradius.app

import java.util.concurrent.CopyOnWriteArrayList
import org.gyradius.app.cues.Cue
import org.gyradius.app.cues.Cues

/** Keeps what it was told. */
class RecordingCues : Cues {
    private val kept = CopyOnWriteArrayList<Cue>()

    /** In the order they came. */
    val told: List<Cue> get() = kept

    override fun tell(cue: Cue) {
        kept += cue
    }
}
