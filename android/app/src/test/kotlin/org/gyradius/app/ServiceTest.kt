package org.gyradius.app

import android.app.NotificationManager
import android.content.pm.ServiceInfo
import android.os.Looper
import androidx.test.ext.junit.runners.AndroidJUnit4
import org.gyradius.app.service.RecorderService
import org.junit.Assert.assertEquals
import org.junit.Assert.assertFalse
import org.junit.Assert.assertTrue
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.Robolectric
import org.robolectric.Shadows.shadowOf
import org.robolectric.shadows.ShadowPowerManager

/** The service that keeps the recording up. */
@RunWith(AndroidJUnit4::class)
class ServiceTest {
    private val park = Park()

    @Test
    fun `it is started with a procedure on the sensors and ends with it`() {
        park.record()
        idle()
        assertEquals(RecorderService::class.java.name, shadowOf(park.app).nextStartedService.component!!.className)
        val service = Robolectric.buildService(RecorderService::class.java).create().startCommand(0, 1)
        val shadow = shadowOf(service.get())
        assertEquals(ServiceInfo.FOREGROUND_SERVICE_TYPE_SPECIAL_USE, service.get().foregroundServiceType)
        assertEquals("Listening to the sensors", shadow.lastForegroundNotification.extras.getString("android.title"))
        assertTrue(ShadowPowerManager.getLatestWakeLock().isHeld)
        idle()
        assertFalse(shadow.isStoppedBySelf)
        park.leave()
        idle()
        assertTrue(shadow.isStoppedBySelf)
        service.destroy()
        assertFalse(ShadowPowerManager.getLatestWakeLock().isHeld)
    }

    @Test
    fun `its notification makes no sound`() {
        Robolectric.buildService(RecorderService::class.java).create().startCommand(0, 1)
        val channels = park.app.getSystemService(NotificationManager::class.java)!!.notificationChannels
        assertEquals(listOf(NotificationManager.IMPORTANCE_LOW), channels.map { it.importance })
    }

    private fun idle() = shadowOf(Looper.getMainLooper()).idle()
}
