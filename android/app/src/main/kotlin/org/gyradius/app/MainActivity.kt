package org.gyradius.app

import android.Manifest.permission.POST_NOTIFICATIONS
import android.content.pm.PackageManager.PERMISSION_GRANTED
import android.hardware.SensorManager
import android.os.Build
import android.os.Bundle
import android.webkit.WebView
import androidx.activity.ComponentActivity
import androidx.activity.compose.BackHandler
import androidx.activity.compose.setContent
import androidx.activity.enableEdgeToEdge
import androidx.activity.result.contract.ActivityResultContracts.OpenDocument
import androidx.activity.result.contract.ActivityResultContracts.RequestPermission
import androidx.activity.viewModels
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.saveable.rememberSaveable
import androidx.compose.runtime.setValue
import androidx.core.content.edit
import androidx.lifecycle.compose.LifecycleResumeEffect
import androidx.lifecycle.compose.collectAsStateWithLifecycle
import androidx.lifecycle.viewmodel.initializer
import androidx.lifecycle.viewmodel.viewModelFactory
import java.io.File
import org.gyradius.Language
import org.gyradius.ProcedurePhase
import kotlinx.coroutines.Dispatchers
import org.gyradius.app.result.ResultModel
import org.gyradius.app.result.ResultShown
import org.gyradius.app.result.printReport
import org.gyradius.app.result.shareFile
import org.gyradius.app.run.PhoneSource
import org.gyradius.app.run.RunModel
import org.gyradius.app.run.SetupModel
import org.gyradius.app.run.Shown
import org.gyradius.app.store.Listed
import org.gyradius.app.store.SessionsModel
import org.gyradius.app.ui.AboutScreen
import org.gyradius.app.ui.GyradiusTheme
import org.gyradius.app.ui.NoticeDialog
import org.gyradius.app.ui.ProcedureScreen
import org.gyradius.app.ui.ResultDeeds
import org.gyradius.app.ui.ResultScreen
import org.gyradius.app.ui.SessionActions
import org.gyradius.app.ui.SessionsScreen
import org.gyradius.app.ui.SetupScreen
import org.gyradius.libraryVersion

/** The one activity: the sessions, the set-up of a boat, the procedure under way, or a result. */
class MainActivity : ComponentActivity() {
    private val app get() = application as GyradiusApp

    /** The procedure under way; it outlives the activity. */
    val model: RunModel get() = app.model
    private val sessions: SessionsModel by viewModels { viewModelFactory { initializer { SessionsModel(app.store, contentResolver) } } }
    private val setup: SetupModel by viewModels()
    private val result: ResultModel by viewModels { viewModelFactory { initializer { ResultModel(app.store) } } }
    private val chooser = registerForActivityResult(OpenDocument()) { it?.let(sessions::import) }

    /** What is printed; gone, it could not be laid out. */
    private var printed: WebView? = null

    /** Whatever the answer is, the app works. */
    private val permission = registerForActivityResult(RequestPermission()) {}

    override fun onCreate(savedInstanceState: Bundle?) {
        super.onCreate(savedInstanceState)
        enableEdgeToEdge()
        setContent { GyradiusTheme { Screens() } }
    }

    /** Where the operator is while nothing is under way. */
    private enum class Place { LIST, SETUP, ABOUT }

    @Composable
    private fun Screens() {
        // How far work has come is told by the library's threads; what draws hears of it on its own.
        val shown by model.shown.collectAsStateWithLifecycle(context = Dispatchers.Main.immediate)
        val opened by result.shown.collectAsStateWithLifecycle(context = Dispatchers.Main.immediate)
        var place by rememberSaveable { mutableStateOf(Place.LIST) }
        val toList = { place = Place.LIST }
        val file = opened
        when {
            file != null -> Result(file)
            shown.state != null -> UnderWay(shown)
            place == Place.SETUP -> Setup(toList)
            place == Place.ABOUT -> About(toList)
            else -> SessionsList(shown) { place = it }
        }
    }

    @Composable
    private fun Result(shown: ResultShown) {
        BackHandler(onBack = result::close)
        val deeds = ResultDeeds(
            judge = result::judge,
            criticise = result::criticise,
            share = { result.report(app.store.shared, language()) { shareFile(this, it, "text/html") } },
            print = { result.report(app.store.shared, language()) { printed = printReport(this, it) } },
            leave = result::close,
        )
        ResultScreen(shown, deeds)
    }

    @Composable
    private fun UnderWay(shown: Shown) {
        val isAloud by app.isAloud.collectAsStateWithLifecycle()
        // A touch of a wet sleeve must not cut a recording off: it goes on behind the launcher.
        val isRecording = shown.state?.phase == ProcedurePhase.RECORD && !shown.isPractice
        val leave: () -> Unit = { if (isRecording) moveTaskToBack(true) else model.leave() }
        BackHandler(onBack = leave)
        ProcedureScreen(shown, model, isAloud, { app.isAloud.value = it }, leave) { shown.folder?.let(::openResult) }
        if (shown.isListening) Notice()
    }

    /** Asks once for leave to show the notification. */
    @Composable
    private fun Notice() {
        var isAsking by rememberSaveable { mutableStateOf(mayAsk()) }
        if (!isAsking) return
        val answered = {
            getPreferences(MODE_PRIVATE).edit { putBoolean(ASKED, true) }
            isAsking = false
        }
        NoticeDialog(onAllow = { answered(); permission.launch(POST_NOTIFICATIONS) }, onRefuse = answered)
    }

    private fun mayAsk() = Build.VERSION.SDK_INT >= 33 &&
        checkSelfPermission(POST_NOTIFICATIONS) != PERMISSION_GRANTED && !getPreferences(MODE_PRIVATE).getBoolean(ASKED, false)

    @Composable
    private fun Setup(onLeave: () -> Unit) {
        BackHandler(onBack = onLeave)
        val planned by setup.planned.collectAsStateWithLifecycle()
        val usualLimits = remember { app.store.usualLimits() }
        SetupScreen(planned, usualLimits, setup::plan, onLeave) { task, limits ->
            model.measure(app.store.create(task.title, limits), task, phone())
            onLeave()
        }
    }

    @Composable
    private fun About(onLeave: () -> Unit) {
        BackHandler(onBack = onLeave)
        AboutScreen(packageManager.getPackageInfo(packageName, 0).versionName ?: "", libraryVersion(), onLeave)
    }

    @Composable
    private fun SessionsList(shown: Shown, onPlace: (Place) -> Unit) {
        LifecycleResumeEffect(Unit) {
            sessions.refresh()
            onPauseOrDispose {}
        }
        val listed by sessions.sessions.collectAsStateWithLifecycle()
        SessionsScreen(listed, shown.error, Actions(onPlace))
    }

    private inner class Actions(private val onPlace: (Place) -> Unit) : SessionActions {
        override fun measure() = onPlace(Place.SETUP)
        override fun about() = onPlace(Place.ABOUT)
        override fun practise() = practise(app.store.practiceAfresh())
        override fun goOnPractising() = practise(app.store.practice)
        override fun import() = chooser.launch(arrayOf("*/*"))
        override fun open(session: Listed) = openResult(session.folder)
        override fun goOn(session: Listed) = model.goOn(session.folder, phone())
        override fun share(session: Listed) = sessions.share(session) { shareFile(this@MainActivity, it, "application/zip") }
        override fun delete(session: Listed) = sessions.delete(session)
        override fun undo() = sessions.undo()
        override fun forget(session: Listed) = sessions.forget(session)
    }

    private fun openResult(folder: File) {
        app.store.measurable(folder)?.let { result.open(it, language()) }
    }

    /** The language of the app's own words, so that a report never has another. */
    private fun language() = Language.valueOf(getString(R.string.library_language))

    private fun phone() = PhoneSource(checkNotNull(getSystemService(SensorManager::class.java)))

    private fun practise(folder: File) {
        val rig = assets.open(PRACTICE_RIG).bufferedReader().use { it.readText() }
        model.practise(folder, rig, getString(R.string.practice_title), PRACTICE_SEED)
    }

    private companion object {
        const val PRACTICE_RIG = "keelboat.toml"
        const val PRACTICE_SEED = 1UL
        const val ASKED = "asked for notifications"
    }
}
