package org.gyradius.app

import android.app.Application
import android.content.Context
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.MainScope
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.flow.distinctUntilChanged
import kotlinx.coroutines.flow.filterNotNull
import kotlinx.coroutines.flow.map
import kotlinx.coroutines.launch
import org.gyradius.app.cues.AndroidCues
import org.gyradius.app.cues.CueTeller
import org.gyradius.app.cues.Cues
import org.gyradius.app.run.RunModel
import org.gyradius.app.service.RecorderService
import org.gyradius.app.store.SessionStore

/** What lives as long as the process does: the procedure under way, its cues, and the sessions on the disk. */
class GyradiusApp : Application() {
    /** The procedure under way. */
    lateinit var model: RunModel
        private set

    /** The sessions. */
    lateinit var store: SessionStore
        private set

    /** Whether cues are told. */
    val isAloud = MutableStateFlow(true)

    /** What tells the cues. */
    var cuesOf: (Context) -> Cues = ::AndroidCues

    private lateinit var scope: CoroutineScope

    override fun onCreate() {
        super.onCreate()
        scope = MainScope()
        model = RunModel(scope)
        store = SessionStore(filesDir, cacheDir)
        scope.launch { serveWhileListening() }
        scope.launch { tellCues() }
    }

    /** The service keeps the process up for as long as the sensors are listened to, and stops by itself. */
    private suspend fun serveWhileListening() =
        model.shown.map { it.isListening }.distinctUntilChanged().collect { if (it) RecorderService.start(this) }

    /** Told from here and not from a screen: the operator stands aside, and the screen may be dark. */
    private suspend fun tellCues() {
        val states = model.shown.map { it.state }
        states.map { it != null }.distinctUntilChanged().collectLatest { isUnderWay ->
            if (isUnderWay) cuesOf(this).use { cues ->
                val teller = CueTeller(cues)
                states.filterNotNull().collect { teller.see(it, isAloud.value) }
            }
        }
    }
}
