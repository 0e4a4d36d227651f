package org.gyradius.app.run

import androidx.lifecycle.ViewModel
import androidx.lifecycle.viewModelScope
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.flow.asStateFlow
import kotlinx.coroutines.launch
import org.gyradius.GyradiusException
import org.gyradius.PlanRequest
import org.gyradius.PlanResult
import org.gyradius.ProcedureTask
import org.gyradius.app.Failure
import org.gyradius.app.failureOf
import org.gyradius.planSwings

/** What is known of a plan. */
data class Planned(
    val isPlanning: Boolean = false,
    val plan: PlanResult? = null,
    val task: ProcedureTask? = null,
    val error: Failure? = null,
)

/** A boat known roughly becomes a plan. */
class SetupModel : ViewModel() {
    private val flow = MutableStateFlow(Planned())

    /** The plan as far as it is. */
    val planned: StateFlow<Planned> = flow.asStateFlow()

    /** Asks the planner: seconds. */
    fun plan(request: PlanRequest) {
        flow.value = Planned(isPlanning = true)
        viewModelScope.launch {
            flow.value = try {
                planSwings(request).use { Planned(plan = it.result(), task = it.task()) }
            } catch (wrong: GyradiusException) {
                Planned(error = failureOf(wrong))
            }
        }
    }
}
