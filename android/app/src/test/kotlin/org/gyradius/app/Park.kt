package org.gyradius.app

import android.Manifest.permission.POST_NOTIFICATIONS
import android.hardware.SensorManager
import androidx.test.core.app.ApplicationProvider
import java.io.File
import kotlinx.coroutines.TimeoutCancellationException
import kotlinx.coroutines.flow.first
import kotlinx.coroutines.runBlocking
import kotlinx.coroutines.withTimeout
import org.gyradius.Channel
import org.gyradius.MeasuredDimensions
import org.gyradius.PhoneInfo
import org.gyradius.Placement
import org.gyradius.ProcedureEvent
import org.gyradius.ProcedurePhase
import org.gyradius.ProcedureTask
import org.gyradius.RecorderFile
import org.gyradius.Suspension
import org.gyradius.app.run.PhoneSource
import org.gyradius.app.run.Shown
import org.gyradius.planSwings
import org.gyradius.samples
import org.gyradius.usualPlanRequest
import org.robolectric.Shadows.shadowOf

/** A boat park: the app, a phone taped to a hull, and an operator who knows the procedure. */
class Park(mayNotify: Boolean = true) {
    val app: GyradiusApp = ApplicationProvider.getApplicationContext()
    val phone = Phone()
    val cues = RecordingCues()
    val model get() = app.model
    val state get() = model.shown.value.state

    /** The folder of the procedure under way. */
    lateinit var folder: File

    init {
        if (mayNotify) shadowOf(app).grantPermissions(POST_NOTIFICATIONS)
        app.cuesOf = { cues }
    }

    /** From nothing to a recording that has begun, without a screen. */
    fun record() {
        val task = task()
        folder = app.store.create(task.title)
        model.measure(folder, task, PhoneSource(app.getSystemService(SensorManager::class.java)!!))
        reach(ProcedurePhase.START)
        model.start(PhoneInfo("phone", model.sensors), Placement.FLAT_TOP_TO_BOW)
        reach(ProcedurePhase.LEVEL)
        phone.rest(3.0)
        await("the tilt") { it.state?.tilt?.bowUpDeg != null && it.state!!.actions.isNotEmpty() }
        model.handle(ProcedureEvent.Accept)
        reach(ProcedurePhase.REST)
        model.handle(ProcedureEvent.Skip)
        reach(ProcedurePhase.HANG)
        model.handle(ProcedureEvent.Measured(asPlanned(state!!.step!!.hanging!!)))
        reach(ProcedurePhase.READY)
        model.record()
        reach(ProcedurePhase.RECORD)
    }

    /** How many samples of each sensor the newest recording of a folder holds. */
    fun recorded(folder: File = this.folder): Map<Channel, Int> =
        RecorderFile.read(take(folder).path).use { file -> file.samples().associate { it.channel to it.stampsNs.size } }

    /** The folders of all sessions. */
    fun sessions(): List<File> = File(app.filesDir, "sessions").listFiles().orEmpty().toList()

    /** Marks in the newest recording. */
    fun marks(): List<String> = RecorderFile.read(take(folder).path).use { file -> file.marks().map { it.key } }

    /** The newest recording. */
    fun take(folder: File = this.folder): File = File(folder, "takes").listFiles()!!.maxBy { it.name }

    /** Waits for the model, by itself: nothing here needs the main thread. */
    fun await(what: String, holds: (Shown) -> Boolean): Shown = try {
        runBlocking { withTimeout(120_000) { model.shown.first(holds) } }
    } catch (late: TimeoutCancellationException) {
        throw AssertionError("waited in vain for $what; it is ${model.shown.value}", late)
    }

    fun reach(phase: ProcedurePhase) = await(phase.name) { it.state?.phase == phase }

    /** Leaves what is under way and waits until its files are closed. */
    fun leave() {
        model.leave()
        await("the end") { it.state == null }
    }

    private fun task(): ProcedureTask = runBlocking {
        val hull = usualPlanRequest().hull.copy(massKg = 120.0, lengthM = 4.5, beamM = 1.5, boatType = "dinghy")
        planSwings(usualPlanRequest().copy(title = "Finn", hull = hull)).use { it.task() }
    }

    private fun asPlanned(planned: Suspension) =
        MeasuredDimensions(planned.lineLengthM, planned.spacingM, null, null, null, null, null, null, null)
}
