package org.gyradius.app

import android.Manifest.permission.POST_NOTIFICATIONS
import android.content.Intent
import android.content.pm.PackageManager.PERMISSION_GRANTED
import android.hardware.SensorManager
import android.os.Build
import android.os.Bundle
import androidx.activity.ComponentActivity
import androidx.activity.compose.BackHandler
import androidx.activity.compose.setContent
import androidx.activity.enableEdgeToEdge
import androidx.activity.result.contract.ActivityResultContracts.OpenDocument
import androidx.activity.result.contract.ActivityResultContracts.RequestPermission
import androidx.activity.viewModels
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.saveable.rememberSaveable
import androidx.compose.runtime.setValue
import androidx.core.content.FileProvider
import androidx.core.content.edit
import androidx.lifecycle.compose.collectAsStateWithLifecycle
import java.io.File
import org.gyradius.ProcedurePhase
import org.gyradius.ProcedureTask
import org.gyradius.app.run.PhoneSource
import org.gyradius.app.run.RunModel
import org.gyradius.app.run.SetupModel
import org.gyradius.app.run.Shown
import org.gyradius.app.store.Listed
import org.gyradius.app.store.ReadModel
import org.gyradius.app.store.SessionsModel
import org.gyradius.app.ui.GyradiusTheme
import org.gyradius.app.ui.NoticeDialog
import org.gyradius.app.ui.ProcedureScreen
import org.gyradius.app.ui.ReadScreen
import org.gyradius.app.ui.SessionActions
import org.gyradius.app.ui.SessionsScreen
import org.gyradius.app.ui.SetupScreen

/** The one activity: the sessions, one of them from a file, the set-up of a boat, or the procedure under way. */
class MainActivity : ComponentActivity() {
    private val app get() = application as GyradiusApp

    /** The procedure under way; it outlives the activity. */
    val model: RunModel get() = app.model
    private val sessions: SessionsModel by viewModels()
    private val setup: SetupModel by viewModels()
    private val read: ReadModel by viewModels()
    private val chooser = registerForActivityResult(OpenDocument()) { it?.let(sessions::import) }

    /** Whatever the answer is, the app works. */
    private val permission = registerForActivityResult(RequestPermission()) {}

    override fun onCreate(savedInstanceState: Bundle?) {
        super.onCreate(savedInstanceState)
        enableEdgeToEdge()
        setContent { GyradiusTheme { Screens() } }
    }

    @Composable
    private fun Screens() {
        val shown by model.shown.collectAsStateWithLifecycle()
        val opened by read.read.collectAsStateWithLifecycle()
        var isSetup by rememberSaveable { mutableStateOf(false) }
        val file = opened
        when {
            shown.state != null -> UnderWay(shown)
            file != null -> {
                BackHandler(onBack = read::close)
                ReadScreen(file, read::close)
            }
            isSetup -> Setup(onLeave = { isSetup = false })
            else -> SessionsList(shown) { isSetup = true }
        }
    }

    @Composable
    private fun UnderWay(shown: Shown) {
        // A touch of a wet sleeve must not cut a recording off: it goes on behind the launcher.
        val isRecording = shown.state?.phase == ProcedurePhase.RECORD && !shown.isPractice
        BackHandler { if (isRecording) moveTaskToBack(true) else model.leave() }
        ProcedureScreen(shown, model)
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
        SetupScreen(planned, setup) { task -> measure(task); onLeave() }
    }

    @Composable
    private fun SessionsList(shown: Shown, onMeasure: () -> Unit) {
        LaunchedEffect(Unit) { sessions.refresh() }
        val listed by sessions.sessions.collectAsStateWithLifecycle()
        SessionsScreen(listed, shown.error, Actions(onMeasure))
    }

    private inner class Actions(private val onMeasure: () -> Unit) : SessionActions {
        override fun measure() = onMeasure()
        override fun practise() = practise(app.store.practiceAfresh())
        override fun goOnPractising() = practise(app.store.practice)
        override fun import() = chooser.launch(arrayOf("*/*"))
        override fun open(session: Listed) = this@MainActivity.open(session)
        override fun share(session: Listed) = sessions.share(session, ::send)
        override fun delete(session: Listed) = sessions.delete(session)
        override fun undo() = sessions.undo()
        override fun forget(session: Listed) = sessions.forget(session)
    }

    private fun measure(task: ProcedureTask) = model.measure(app.store.create(task.title), task, phone())

    private fun open(session: Listed) {
        val file = app.store.fileOf(session.folder)
        if (file == null) model.goOn(session.folder, phone()) else read.open(file, session.title)
    }

    private fun phone() = PhoneSource(checkNotNull(getSystemService(SensorManager::class.java)))

    private fun practise(folder: File) {
        val rig = assets.open(PRACTICE_RIG).bufferedReader().use { it.readText() }
        model.practise(folder, rig, PRACTICE_SEED)
    }

    /** Hands a packed session to whatever app the operator chooses. */
    private fun send(file: File) {
        val uri = FileProvider.getUriForFile(this, "$packageName.files", file)
        val send = Intent(Intent.ACTION_SEND).setType("application/zip")
            .putExtra(Intent.EXTRA_STREAM, uri)
            .addFlags(Intent.FLAG_GRANT_READ_URI_PERMISSION)
        startActivity(Intent.createChooser(send, null))
    }

    private companion object {
        const val PRACTICE_RIG = "keelboat.toml"
        const val PRACTICE_SEED = 1UL
        const val ASKED = "asked for notifications"
    }
}
