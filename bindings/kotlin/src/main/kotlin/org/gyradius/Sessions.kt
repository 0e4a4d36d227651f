package org.gyradius

import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import java.io.File

/** Reads a session folder, a session's zip or a bare recording; [mapping] names the columns of a foreign CSV. */
suspend fun loadSession(path: File, mapping: List<String> = emptyList()): Session =
    withContext(Dispatchers.IO) { Session.load(path.path, mapping) }

/** Modes, inertia, uncertainty and consistency; each of the [limits] (`k_pitch_m>=1.100`) gets a verdict. */
suspend fun Session.measure(limits: List<String> = emptyList(), onProgress: OnProgress? = null): Analysis =
    watched(onProgress) { measureBlocking(limits, it) }

/** What the simulation gets wrong, why, and what mending it gains: minutes. */
suspend fun Session.critique(onProgress: OnProgress? = null): Criticism = watched(onProgress) { critiqueBlocking(it) }

/** The plan from what was measured so far. */
suspend fun Session.plan(request: PlanRequest = usualPlanRequest(), onProgress: OnProgress? = null): Plan =
    watched(onProgress) { planBlocking(request, it) }

/** The plan of the swing that tells two causes of the criticism apart: minutes. */
suspend fun Session.planToTellApart(
    one: String,
    other: String,
    request: PlanRequest = usualPlanRequest(),
    onProgress: OnProgress? = null,
): Plan = watched(onProgress) { planToTellApartBlocking(one, other, request, it) }

/** The plan for a hull of which rough figures are known. */
suspend fun planSwings(request: PlanRequest, onProgress: OnProgress? = null): Plan =
    watched(onProgress) { Plan.makeBlocking(request, it) }

/** The report: one self-contained HTML file in a language. */
suspend fun Analysis.reportHtml(
    criticism: Criticism? = null,
    measuredOn: String? = null,
    language: Language = Language.ENGLISH,
    onProgress: OnProgress? = null,
): String = watched(onProgress) { reportHtmlBlocking(criticism, measuredOn, language, it) }

/** A quantity of the result, e.g. `k_yaw_m`. */
fun InertiaResult.quantity(name: String): QuantityResult? = quantities.firstOrNull { it.name == name }?.quantity

/** The number, where the quantity is one. */
val QuantityValue.number: Double?
    get() = (this as? QuantityValue.Scalar)?.value

/** The swing of a step that is one. */
val PlanStep.swing: PlannedSwing?
    get() = (this as? PlanStep.Swing)?.v1

/** The incline of a step that is one. */
val PlanStep.incline: PlannedIncline?
    get() = (this as? PlanStep.Incline)?.v1
