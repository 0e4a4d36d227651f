package org.gyradius.app

import androidx.test.ext.junit.runners.AndroidJUnit4
import org.gyradius.app.ui.nameAndUnit
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
        assertEquals("2.3457" to "–", withUncertainty(2.345678, 0.0))
    }

    @Test
    fun `the unit stands at the end of a name`() {
        assertEquals("k yaw" to "m", nameAndUnit("k_yaw_m"))
        assertEquals("inertia yaw" to "kg m²", nameAndUnit("inertia_yaw_kg_m2"))
    }
}
