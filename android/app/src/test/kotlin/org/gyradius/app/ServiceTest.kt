package org.gyradius.app

import android.Manifest.permission.FOREGROUND_SERVICE
import android.Manifest.permission.FOREGROUND_SERVICE_SPECIAL_USE
import android.Manifest.permission.POST_NOTIFICATIONS
import android.Manifest.permission.REORDER_TASKS
import android.Manifest.permission.VIBRATE
import android.Manifest.permission.WAKE_LOCK
import android.app.NotificationManager
import android.content.pm.PackageManager
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

    @Test
    fun `the phone is asked for nothing beyond what recording needs, and for no network`() {
        val info = park.app.packageManager.getPackageInfo(park.app.packageName, PackageManager.GET_PERMISSIONS)
        val asked = info.requestedPermissions!!.filter { it.startsWith("android.permission.") }.toSet()
        val needed = setOf(FOREGROUND_SERVICE, FOREGROUND_SERVICE_SPECIAL_USE, POST_NOTIFICATIONS, WAKE_LOCK, VIBRATE)
        // The last is wanted by androidx.test, which is in no APK.
        assertEquals(needed + REORDER_TASKS, asked)
    }

    private fun idle() = shadowOf(Looper.getMainLooper()).idle()
}
