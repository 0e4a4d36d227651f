package org.gyradius.app

import androidx.compose.runtime.Composable
import androidx.compose.ui.test.junit4.createComposeRule
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performScrollTo
import androidx.compose.ui.test.performTextReplacement
import androidx.test.ext.junit.runners.AndroidJUnit4
import java.io.File
import java.time.Instant
import org.gyradius.Language
import org.gyradius.Placement
import org.gyradius.PlanRequest
import org.gyradius.ProcedurePhase
import org.gyradius.ProcedureState
import org.gyradius.Recommend
import org.gyradius.GapList
import org.gyradius.MeasuredDimensions
import org.gyradius.Sensor
import org.gyradius.SensorGap
import org.gyradius.Tilt
import org.gyradius.TiltAgainst
import org.gyradius.app.result.ResultShown
import org.gyradius.app.run.Planned
import org.gyradius.app.run.Shown
import org.gyradius.app.ui.AboutScreen
import org.gyradius.app.ui.Deeds
import org.gyradius.app.ui.ProcedurePage
import org.gyradius.app.ui.ResultDeeds
import org.gyradius.app.ui.ResultScreen
import org.gyradius.app.store.Listed
import org.gyradius.app.store.Sessions
import org.gyradius.app.ui.SessionActions
import org.gyradius.app.ui.SessionsScreen
import org.gyradius.app.ui.SetupScreen
import org.gyradius.libraryVersion
import org.gyradius.number
import org.junit.Assert.assertEquals
import org.junit.Rule
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.annotation.Config

/** Every screen in every look, with what the core makes of a simulated hull and of a session that ships. */
@RunWith(AndroidJUnit4::class)
@Config(qualifiers = "w1300dp-h2700dp-hdpi")
class LooksTest {
    @get:Rule
    val rule = createComposeRule()

    @Test
    fun `the list of sessions`() {
        val done = Listed(File("b"), "Finn", AT, ProcedurePhase.DONE, Core.byTheBook.last().result!!.quantities.filter { it.quantity.value.number != null })
        val sessions = Sessions(listOf(Listed(File("a"), "Laser", AT, ProcedurePhase.INTERRUPTED), done), isPracticeLeft = true)
        rule.looks("sessions") { SessionsScreen(sessions, null, noSessionActions) }
    }

    @Test
    fun `set-up before anything is known`() = rule.looks("setup") { SetupScreen(Planned(), emptyList(), {}, {}) { _, _ -> } }

    @Test
    fun `set-up with the planner's advice`() {
        val planned = Core.planned
        rule.looks("plan") { SetupScreen(planned, listOf("k_yaw_m>=1.1"), {}, {}) { _, _ -> } }
    }

    @Test
    fun `the beginning, and how the phone lies`() = procedure("start", first(ProcedurePhase.START), isPractice = false)

    @Test
    fun `practice begins`() = procedure("practice", first(ProcedurePhase.START), isPractice = true)

    @Test
    fun level() = procedure("level", Core.byTheBook.last { it.phase == ProcedurePhase.LEVEL && it.tilt != null })

    @Test
    fun `the bubble of a phone that knows where the bow is`() {
        val state = first(ProcedurePhase.LEVEL)
        val tilt = Tilt(TiltAgainst.PHONE_PLANE, angleDeg = 0.36, bowUpDeg = 0.34, starboardDownDeg = -0.12)
        procedure("level-bubble", state.copy(tilt = tilt), isPractice = false)
    }

    @Test
    fun `a rest that is being taken`() = procedure("rest", Core.byTheBook.middle { it.rest != null && it.rest?.found == null })

    @Test
    fun `a rest that is good`() = procedure("rest-found", Core.byTheBook.first { it.rest?.found != null })

    @Test
    fun hang() = procedure("hang", first(ProcedurePhase.HANG), isPractice = false)

    @Test
    fun ready() = procedure("ready", first(ProcedurePhase.READY))

    @Test
    fun `a swing that has not been let go`() = procedure("release", first(ProcedurePhase.RECORD))

    @Test
    fun `a swing on its way`() {
        val shown = Core.byTheBook.middle { it.recording?.live?.swing != null }
        procedure("swing", shown, isPractice = false)
    }

    @Test
    fun `every gap of a swing on its way`() {
        val state = Core.byTheBook.middle { it.recording?.live?.swing != null }
        val sensors = state.recording!!.live!!.sensors.map { it.copy(gaps = 2uL, longestGapS = 0.51) }
        val live = state.recording!!.live!!.copy(sensors = sensors, gaps = someGaps.copy(more = 0uL))
        gaps("gaps", state.copy(recording = state.recording!!.copy(live = live)))
    }

    @Test
    fun `every gap of a recording that has ended`() {
        val state = first(ProcedurePhase.JUDGE)
        gaps("judge-gaps", state.copy(judgement = state.judgement!!.copy(gaps = someGaps)))
    }

    @Test
    fun `a swing that somebody touched`() = procedure("touched", Core.touched.first { it.recording?.live?.advice.orEmpty().isNotEmpty() })

    @Test
    fun `a good recording`() = procedure("judge", first(ProcedurePhase.JUDGE))

    @Test
    fun `a recording to be repeated`() =
        procedure("judge-repeat", Core.badlyReleased.first { it.judgement?.recommend == Recommend.REPEAT })

    @Test
    fun `the end`() = procedure("done", Core.byTheBook.last())

    @Test
    fun `a result with verdicts`() {
        val shown = ResultShown("Boat", Core.boatPark.result(), Core.boatPark.recordings(Language.ENGLISH))
        rule.looks("result") { ResultScreen(shown, noResultDeeds) }
    }

    @Test
    fun `a result with its criticism`() {
        val shown = ResultShown("Boat", Core.boatPark.result(), critique = Core.dragged.result(), compared = Core.dragged.compared())
        rule.looks("criticism") { ResultScreen(shown, noResultDeeds) }
    }

    @Test
    fun about() = rule.looks("about") { AboutScreen("0.1.0", libraryVersion()) {} }

    @Test
    fun `how the phone lies is told to the procedure`() {
        var told: Placement? = null
        show(Shown(first(ProcedurePhase.START)), deeds(begin = { told = it }))
        rule.onNodeWithText("Any other way: level the hull by a spirit level").performScrollTo().performClick()
        rule.onNodeWithText("Begin").performScrollTo().performClick()
        assertEquals(Placement.ANY_WAY, told)
    }

    @Test
    fun `what was measured is told, commas and all`() {
        var told: MeasuredDimensions? = null
        val state = first(ProcedurePhase.HANG)
        show(Shown(state), deeds(measured = { told = it }))
        rule.onNodeWithText("Length of the lines, m").performScrollTo().performTextReplacement("3,25")
        rule.onNodeWithText("As typed").performScrollTo().performClick()
        assertEquals(3.25, told!!.lineLengthM!!.value, 0.0)
        assertEquals(state.step!!.hanging!!.lineLengthM!!.u, told!!.lineLengthM!!.u, 1e-9)
        assertEquals(state.step!!.hanging!!.spacingM!!.value, told!!.spacingM!!.value, 1e-5)
    }

    @Test
    fun `what is typed of a boat is asked of the planner`() {
        var asked: PlanRequest? = null
        rule.setContent { SetupScreen(Planned(), emptyList(), { asked = it }, {}) { _, _ -> } }
        rule.onNodeWithText("Mass of all that hangs, kg").performScrollTo().performTextReplacement("120,5")
        rule.onNodeWithText("Dinghy").performScrollTo().performClick()
        rule.onNodeWithText("How certain it must be").performScrollTo().performClick()
        rule.onNodeWithText("Yaw gyradius, %").performScrollTo().performTextReplacement("0.2")
        rule.onNodeWithText("Plan the swings").performScrollTo().performClick()
        assertEquals(120.5, asked!!.hull.massKg!!, 0.0)
        assertEquals("dinghy", asked!!.hull.boatType)
        assertEquals(listOf("k_yaw=0.2%"), asked!!.wanted)
    }

    private fun first(phase: ProcedurePhase) = Core.byTheBook.first { it.phase == phase }

    private fun procedure(name: String, state: ProcedureState, isPractice: Boolean = true) {
        val trace = if (state.recording != null && !isPractice) Core.trace else emptyList()
        rule.looks(name) { Procedure(Shown(state, trace, isPractice = isPractice)) }
    }

    /** With the list of gaps open. */
    private fun gaps(name: String, state: ProcedureState) {
        val open = { look: Look -> rule.onNodeWithText(if (look.language == "de") "Jede Lücke" else "Every gap").performScrollTo().performClick() }
        rule.looks(name, { open(it) }) { Procedure(Shown(state)) }
    }

    private val someGaps = GapList(
        listOf(
            SensorGap(Sensor.GYROSCOPE, fromS = 3.115, lengthS = 0.015),
            SensorGap(Sensor.ACCELEROMETER, fromS = 3.115, lengthS = 0.015),
            SensorGap(Sensor.GYROSCOPE, fromS = 41.87, lengthS = 0.51),
            SensorGap(Sensor.ACCELEROMETER, fromS = 104.2, lengthS = 12.305),
        ),
        more = 23uL,
    )

    private fun show(shown: Shown, deeds: Deeds) = rule.setContent { ProcedurePage(shown, deeds, isAloud = true) {} }

    @Composable
    private fun Procedure(shown: Shown) = ProcedurePage(shown, deeds(), isAloud = true) {}

    private fun deeds(begin: (Placement) -> Unit = {}, measured: (MeasuredDimensions) -> Unit = {}) =
        Deeds(begin, measured, record = {}, workAgain = {}, handle = {}, setPace = {}, leave = {}, openResult = {})

    private val noSessionActions = object : SessionActions {
        override fun measure() = Unit
        override fun about() = Unit
        override fun practise() = Unit
        override fun goOnPractising() = Unit
        override fun import() = Unit
        override fun open(session: Listed) = Unit
        override fun goOn(session: Listed) = Unit
        override fun share(session: Listed) = Unit
        override fun delete(session: Listed) = Unit
        override fun undo() = Unit
        override fun forget(session: Listed) = Unit
    }

    private val noResultDeeds = ResultDeeds({}, {}, {}, {}, {})

    private companion object {
        val AT: Instant = Instant.parse(Core.AT_UTC)
    }
}
