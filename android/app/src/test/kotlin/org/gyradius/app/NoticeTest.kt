package org.gyradius.app

import android.Manifest.permission.POST_NOTIFICATIONS
import androidx.compose.ui.test.junit4.createAndroidComposeRule
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.test.ext.junit.runners.AndroidJUnit4
import org.gyradius.Channel
import org.gyradius.ProcedurePhase
import org.gyradius.ProcedureEvent
import org.junit.After
import org.junit.Assert.assertEquals
import org.junit.Assert.assertFalse
import org.junit.Assert.assertNull
import org.junit.Rule
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.Shadows.shadowOf

/** The one permission that is asked for, and an operator who says no. */
@RunWith(AndroidJUnit4::class)
class NoticeTest {
    @get:Rule
    val rule = createAndroidComposeRule<MainActivity>()

    private val park = Park(mayNotify = false)

    @After
    fun leave() = park.leave()

    @Test
    fun `refused before the system asks, it is not asked again, and the recording is whole`() {
        park.record()
        rule.patient("the question") { rule.exists(QUESTION) }
        rule.shot("15-notice")
        rule.onNodeWithText("Not now").performClick()
        rule.patient("the answer taken") { !rule.exists(QUESTION) }
        assertNull(shadowOf(rule.activity).lastRequestedPermission)
        rule.activityRule.scenario.recreate()
        rule.patient("the screen") { rule.exists("Stop") }
        assertFalse(rule.exists(QUESTION))
        assertWholeRecording()
    }

    @Test
    fun `refused when the system asks, the recording is whole`() {
        park.record()
        rule.patient("the question") { rule.exists(QUESTION) }
        rule.onNodeWithText("Show it").performClick()
        val asked = shadowOf(rule.activity).lastRequestedPermission
        assertEquals(listOf(POST_NOTIFICATIONS), asked.requestedPermissions.toList())
        assertWholeRecording()
    }

    private fun assertWholeRecording() {
        val before = park.phone.sent
        val early = park.recorded().getOrDefault(Channel.GYROSCOPE, 0)
        park.phone.rest(5.0)
        park.model.handle(ProcedureEvent.StopRecording)
        park.reach(ProcedurePhase.JUDGE)
        assertEquals(early + park.phone.sent - before, park.recorded()[Channel.GYROSCOPE])
    }

    private companion object {
        const val QUESTION = "Show that it records?"
    }
}
