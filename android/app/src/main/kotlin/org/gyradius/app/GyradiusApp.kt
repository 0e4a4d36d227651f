package org.gyradius.app

import android.app.Application
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.MainScope
import kotlinx.coroutines.flow.distinctUntilChanged
import kotlinx.coroutines.flow.map
import kotlinx.coroutines.launch
import org.gyradius.app.run.RunModel
import org.gyradius.app.service.RecorderService
import org.gyradius.app.store.SessionStore

/** What lives as long as the process does: the procedure under way, and the sessions on the disk. */
class GyradiusApp : Application() {
    /** The procedure under way. */
    lateinit var model: RunModel
        private set

    /** The sessions. */
    lateinit var store: SessionStore
        private set

    private lateinit var scope: CoroutineScope

    override fun onCreate() {
        super.onCreate()
        scope = MainScope()
        model = RunModel(scope)
        store = SessionStore(filesDir)
        scope.launch { serveWhileListening() }
    }

    /** The service keeps the process up for as long as the sensors are listened to, and stops by itself. */
    private suspend fun serveWhileListening() =
        model.shown.map { it.isListening }.distinctUntilChanged().collect { if (it) RecorderService.start(this) }
}
