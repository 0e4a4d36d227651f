package org.gyradius.app.cues

import org.gyradius.LiveAdvice
import org.gyradius.ProcedurePhase
import org.gyradius.ProcedureState
import org.gyradius.Recommend
import org.gyradius.swing

/** What an operator is told who does not look at the phone. */
enum class Cue { RELEASE_NOW, RECORDING, TOUCHED, GOOD, REPEAT, DONE }

/** Tells cues: by sound, voice and vibration. */
interface Cues : AutoCloseable {
    /** Tells one, and breaks off what is still being told. */
    fun tell(cue: Cue)

    override fun close() = Unit
}

/** Follows the states of a procedure and tells what changed. */
class CueTeller(private val cues: Cues) {
    private var last: ProcedureState? = null

    /** Takes the newest state. */
    fun see(state: ProcedureState, isOn: Boolean) {
        val before = last
        last = state
        if (isOn && before != null) cueFor(before, state)?.let(cues::tell)
    }
}

/** Which cue a change of state deserves, if any. */
fun cueFor(before: ProcedureState, now: ProcedureState): Cue? = when {
    now.phase == ProcedurePhase.RECORD -> cueOfRecording(before, now)
    now.phase == before.phase -> Cue.GOOD.takeIf { before.rest?.found == null && now.rest?.found != null }
    now.phase == ProcedurePhase.JUDGE ->
        if (now.judgement?.recommend == Recommend.REPEAT) Cue.REPEAT else Cue.GOOD
    now.phase == ProcedurePhase.DONE -> Cue.DONE
    else -> null
}

private fun cueOfRecording(before: ProcedureState, now: ProcedureState): Cue? {
    val isSwing = now.step?.planned?.swing != null
    return when {
        now.touches() > before.touches() -> Cue.TOUCHED
        now.isSwinging && !before.isSwinging -> Cue.RECORDING
        !isSwing && before.phase != ProcedurePhase.RECORD -> Cue.RECORDING
        isSwing && !now.isSwinging && now.isToBeReleased && !before.isToBeReleased -> Cue.RELEASE_NOW
        else -> null
    }
}

private val ProcedureState.isSwinging: Boolean
    get() = phase == ProcedurePhase.RECORD && recording?.swingingS != null

private val ProcedureState.isToBeReleased: Boolean
    get() = phase == ProcedurePhase.RECORD && (recording?.recordedS ?: 0.0) >= QUIET_S

private fun ProcedureState.touches(): Int = recording?.live?.advice.orEmpty().count { it is LiveAdvice.Touched }

/** So long the hull is held before it is let go, s: the procedure's own words. */
private const val QUIET_S = 3.0
