package org.gyradius.app.service

import android.app.Notification
import android.app.NotificationChannel
import android.app.NotificationManager
import android.app.PendingIntent
import android.app.Service
import android.content.Context
import android.content.Intent
import android.content.pm.ServiceInfo
import android.os.Build
import android.os.IBinder
import android.os.PowerManager
import androidx.core.app.NotificationCompat
import androidx.core.app.ServiceCompat
import androidx.core.content.ContextCompat
import androidx.core.content.getSystemService
import kotlinx.coroutines.Job
import kotlinx.coroutines.MainScope
import kotlinx.coroutines.cancel
import kotlinx.coroutines.flow.first
import kotlinx.coroutines.launch
import org.gyradius.app.GyradiusApp
import org.gyradius.app.MainActivity
import org.gyradius.app.R

/**
 * Keeps the process and the processor up while the sensors are listened to, and says so in a notification: from Android 9 an
 * app in the background gets no samples. It holds no samples itself; they go from the sensors' thread to the run.
 *
 * Its type is `specialUse`. The other one that sensors may run under, `health`, is for the body of the phone's owner, and wants
 * a second permission (high sampling rates, body sensors or activity recognition) beside its own; a hull is neither.
 */
class RecorderService : Service() {
    private val scope = MainScope()
    private var watching: Job? = null
    private val wakeLock by lazy {
        checkNotNull(getSystemService<PowerManager>()).newWakeLock(PowerManager.PARTIAL_WAKE_LOCK, "gyradius:recorder")
    }

    override fun onBind(intent: Intent?): IBinder? = null

    override fun onCreate() {
        super.onCreate()
        wakeLock.acquire(LONGEST_MS)
    }

    override fun onStartCommand(intent: Intent?, flags: Int, startId: Int): Int {
        ServiceCompat.startForeground(this, NOTIFICATION, notification(), type())
        watching?.cancel()
        watching = scope.launch {
            (application as GyradiusApp).model.shown.first { !it.isListening }
            stopSelf(startId)
        }
        // Killed with its process, there is nothing to restart it for: the operator goes on from the list of sessions.
        return START_NOT_STICKY
    }

    override fun onDestroy() {
        scope.cancel()
        if (wakeLock.isHeld) wakeLock.release()
        super.onDestroy()
    }

    private fun notification(): Notification {
        val channel = NotificationChannel(CHANNEL, getString(R.string.notice_channel), NotificationManager.IMPORTANCE_LOW)
        checkNotNull(getSystemService<NotificationManager>()).createNotificationChannel(channel)
        val back = Intent(this, MainActivity::class.java).addFlags(Intent.FLAG_ACTIVITY_SINGLE_TOP)
        return NotificationCompat.Builder(this, CHANNEL)
            .setSmallIcon(R.drawable.ic_notice)
            .setContentTitle(getString(R.string.notice_title))
            .setContentText(getString(R.string.notice_text))
            .setContentIntent(PendingIntent.getActivity(this, 0, back, PendingIntent.FLAG_IMMUTABLE))
            .setCategory(NotificationCompat.CATEGORY_SERVICE)
            .setOngoing(true)
            .build()
    }

    private fun type(): Int =
        if (Build.VERSION.SDK_INT >= 34) ServiceInfo.FOREGROUND_SERVICE_TYPE_SPECIAL_USE else 0

    companion object {
        private const val CHANNEL = "recorder"
        private const val NOTIFICATION = 1

        /** A day in the boat park; a phone that was forgotten there does not run itself empty. */
        private const val LONGEST_MS = 10L * 60 * 60 * 1000

        /** Starts it; it stops by itself when nothing is listened to any more. */
        fun start(context: Context) =
            ContextCompat.startForegroundService(context, Intent(context, RecorderService::class.java))
    }
}
