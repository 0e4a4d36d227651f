package org.gyradius.app

import android.hardware.SensorManager
import android.os.Bundle
import androidx.activity.ComponentActivity
import androidx.activity.compose.BackHandler
import androidx.activity.compose.setContent
import androidx.activity.enableEdgeToEdge
import androidx.activity.viewModels
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.saveable.rememberSaveable
import androidx.compose.runtime.setValue
import androidx.lifecycle.compose.collectAsStateWithLifecycle
import java.io.File
import java.time.Instant
import org.gyradius.ProcedureTask
import org.gyradius.app.run.PhoneSource
import org.gyradius.app.run.RunModel
import org.gyradius.app.run.SetupModel
import org.gyradius.app.ui.GyradiusTheme
import org.gyradius.app.ui.ProcedureScreen
import org.gyradius.app.ui.SessionsScreen
import org.gyradius.app.ui.SetupScreen

/** The one activity: the sessions, or the procedure under way. */
class MainActivity : ComponentActivity() {
    /** Kept over a turn of the screen. */
    val model: RunModel by viewModels()
    private val setup: SetupModel by viewModels()

    override fun onCreate(savedInstanceState: Bundle?) {
        super.onCreate(savedInstanceState)
        enableEdgeToEdge()
        setContent {
            GyradiusTheme {
                val shown by model.shown.collectAsStateWithLifecycle()
                var isSetup by rememberSaveable { mutableStateOf(false) }
                when {
                    shown.state != null -> {
                        BackHandler(onBack = model::leave)
                        ProcedureScreen(shown, model)
                    }
                    isSetup -> {
                        BackHandler { isSetup = false }
                        val planned by setup.planned.collectAsStateWithLifecycle()
                        SetupScreen(planned, setup::plan, onBack = { isSetup = false }) { task, _ -> measure(task); isSetup = false }
                    }
                    else -> SessionsScreen(shown.error, onMeasure = { isSetup = true }, onPractise = ::practise)
                }
            }
        }
    }

    private fun measure(task: ProcedureTask) {
        val folder = File(filesDir, "sessions/${Instant.now().toString().replace(':', '-')}").apply { mkdirs() }
        model.measure(folder, task, PhoneSource(checkNotNull(getSystemService(SensorManager::class.java))))
    }

    private fun practise() {
        val rig = assets.open(PRACTICE_RIG).bufferedReader().use { it.readText() }
        model.practise(File(filesDir, "practice").apply { mkdirs() }, rig, PRACTICE_SEED)
    }

    private companion object {
        const val PRACTICE_RIG = "keelboat.toml"
        const val PRACTICE_SEED = 1UL
    }
}
