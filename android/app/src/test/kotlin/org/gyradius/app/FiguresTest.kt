package org.gyradius.app

import androidx.test.ext.junit.runners.AndroidJUnit4
import java.util.Locale
import org.gyradius.app.ui.Goal
import org.gyradius.app.ui.LimitTyped
import org.gyradius.app.ui.asShown
import org.gyradius.app.ui.asTyped
import org.gyradius.app.ui.withUncertainty
import org.junit.Assert.assertEquals
import org.junit.Test
import org.junit.runner.RunWith

/** Figures as they stand on the screen. */
@RunWith(AndroidJUnit4::class)
class FiguresTest {
    @Test
    fun `an uncertainty has two digits and its figure as many places`() {
        assertEquals("2.34568" to "0.00012", withUncertainty(2.345678, 0.000123))
        assertEquals("212" to "15", withUncertainty(212.4, 15.2))
        assertEquals("−5.52" to "0.65", withUncertainty(-5.52, 0.65))
        assertEquals("2.3457" to "–", withUncertainty(2.345678, 0.0))
    }

    @Test
    fun `a sentence begins with a capital and keeps figures beside their units`() {
        assertEquals("Wait 3\u00A0s, 5\u00A0% of 2 swings, 9.81\u00A0m/s².", asShown("wait 3 s, 5 % of 2 swings, 9.81 m/s²."))
        for (symbol in listOf("ψ is not known", "k_yaw_m is", "χ² is")) assertEquals(symbol, asShown(symbol))
    }

    @Test
    fun `a limit that was kept stands in its fields again`() {
        val typed = LimitTyped(Goal.K_PITCH, isLeast = false, "1,18")
        assertEquals("k_pitch_m<=1.18", typed.text())
        assertEquals(typed.copy(value = "1.18"), LimitTyped.of("k_pitch_m<=1.18"))
        assertEquals(null, LimitTyped.of("mast_m<=1.18"))
        assertEquals(null, LimitTyped.of("k_pitch_m"))
    }

    @Test
    fun `figures have the decimal sign of the language`() {
        val before = Locale.getDefault()
        try {
            Locale.setDefault(Locale.GERMANY)
            assertEquals("9,80665", asTyped(9.80665))
            assertEquals("1,18", LimitTyped.of("k_pitch_m<=1.18")?.value)
            assertEquals("k_pitch_m<=1.18", LimitTyped.of("k_pitch_m<=1.18")?.text())
        } finally {
            Locale.setDefault(before)
        }
    }
}
