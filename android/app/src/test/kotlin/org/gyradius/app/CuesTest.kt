package org.gyradius.app

import androidx.test.ext.junit.runners.AndroidJUnit4
import org.gyradius.ProcedurePhase
import org.gyradius.ProcedureState
import org.gyradius.app.cues.Cue
import org.gyradius.app.cues.CueTeller
import org.junit.Assert.assertEquals
import org.junit.Test
import org.junit.runner.RunWith

/** What an operator hears who does not look at the phone. */
@RunWith(AndroidJUnit4::class)
class CuesTest {
    @Test
    fun `a swing by the book`() {
        val swing = listOf(Cue.RELEASE_NOW, Cue.RECORDING, Cue.GOOD)
        assertEquals(listOf(Cue.GOOD) + swing + swing + Cue.DONE, heard(Core.byTheBook))
    }

    @Test
    fun `a touch is told while it swings`() {
        assertEquals(listOf(Cue.GOOD, Cue.RELEASE_NOW, Cue.RECORDING, Cue.TOUCHED), heard(Core.touched).take(4))
    }

    @Test
    fun `a bad release is to be repeated, and then is good`() {
        val swing = listOf(Cue.RELEASE_NOW, Cue.RECORDING)
        assertEquals(listOf(Cue.GOOD) + swing + Cue.REPEAT + swing + Cue.GOOD, heard(Core.badlyReleased).take(7))
    }

    @Test
    fun `nothing is told where it is turned off`() {
        assertEquals(emptyList<Cue>(), heard(Core.byTheBook, isOn = false))
    }

    @Test
    fun `nothing is told of what was there when the screen opened`() {
        val done = Core.byTheBook.last { it.phase == ProcedurePhase.DONE }
        assertEquals(emptyList<Cue>(), heard(listOf(done, done)))
    }

    private fun heard(states: List<ProcedureState>, isOn: Boolean = true): List<Cue> {
        val cues = RecordingCues()
        val teller = CueTeller(cues)
        states.forEach { teller.see(it, isOn) }
        return cues.told
    }
}
