package org.gyradius.app.ui

import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.material3.LinearProgressIndicator
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.OutlinedTextField
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.saveable.rememberSaveable
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.res.stringResource
import org.gyradius.Orientation
import org.gyradius.PlanRequest
import org.gyradius.ProcedureTask
import org.gyradius.SuspensionKind
import org.gyradius.app.R
import org.gyradius.app.run.Planned
import org.gyradius.boatTypes
import org.gyradius.usualMeans

/** The boat as it is roughly known, what is at hand, and what the planner advises; class limits are offered as they were used
 * last. [onBegin] is also given them. */
@Composable
fun SetupScreen(
    planned: Planned,
    usualLimits: List<String>,
    onPlan: (PlanRequest) -> Unit,
    onBack: () -> Unit,
    onBegin: (task: ProcedureTask, limits: List<String>) -> Unit,
) {
    var form by rememberSaveable { mutableStateOf(SetupForm.of(usualMeans(), boatTypes().first(), usualLimits)) }
    Page {
        TopBar(stringResource(R.string.boat), onBack, R.string.back) { HelpButton(R.string.help_setup) }
        TwoColumns({ Form(form) { form = it } }) {
            WideButton(stringResource(R.string.plan), isMain = planned.task == null, isEnabled = !planned.isPlanning) {
                onPlan(form.request())
            }
            if (planned.isPlanning) LinearProgressIndicator(Modifier.fillMaxWidth())
            planned.error?.let { Advice(spoken(it), Tone.WRONG) }
            planned.task?.let { task ->
                WideButton(stringResource(R.string.to_the_boat)) { onBegin(task, form.limitTexts()) }
            }
            planned.plan?.let { PlanCards(it) }
            if (planned.plan == null) WhatToMeasure()
        }
    }
}

@Composable
private fun Form(form: SetupForm, onForm: (SetupForm) -> Unit) {
    OutlinedTextField(
        form.name,
        { onForm(form.copy(name = it)) },
        Modifier.fillMaxWidth(),
        label = { Text(stringResource(R.string.boat_name)) },
        singleLine = true,
    )
    Entries(HULL, form, onForm, isNeeded = true)
    Types(form.type) { onForm(form.copy(type = it)) }
    Fold(R.string.known_closer) { KnownCloser(form, onForm) }
    Fold(R.string.at_hand) { Entries(ROOM, form, onForm) }
    Fold(R.string.wanted) { Wanted(form, onForm) }
    Fold(R.string.class_limits) { Limits(form.limits) { onForm(form.with(it)) } }
    Fold(R.string.finer) {
        Entries(FINER, form, onForm)
        QuantityFields(R.string.gravity_m_s2, form.gravity) { onForm(form.copy(gravity = it)) }
    }
}

@Composable
private fun Entries(entries: List<Entry>, form: SetupForm, onForm: (SetupForm) -> Unit, isNeeded: Boolean = false) {
    for (one in entries) {
        val text = form.numbers[one].orEmpty()
        // An empty field is asked for, not complained about.
        NumberField(stringResource(one.label), text, isNeeded = isNeeded && text.isNotEmpty()) { onForm(form.with(one, it)) }
    }
}

@Composable
private fun Types(chosen: String, onType: (String) -> Unit) {
    SectionHead(stringResource(R.string.type))
    Chips {
        for (one in boatTypes()) {
            Chip(boatType(one), one == chosen) { onType(one) }
        }
    }
}

@Composable
private fun KnownCloser(form: SetupForm, onForm: (SetupForm) -> Unit) {
    Text(stringResource(R.string.known_closer_says), style = MaterialTheme.typography.bodyLarge)
    for (one in Known.entries) {
        QuantityFields(one.label, form.known[one] ?: Typed("", ""), isNeeded = false) { onForm(form.with(one, it)) }
    }
}

@Composable
private fun Wanted(form: SetupForm, onForm: (SetupForm) -> Unit) {
    Text(stringResource(R.string.wanted_says), style = MaterialTheme.typography.bodyLarge)
    for (goal in Goal.entries) {
        val label = "${quantityName(goal.measured)}, ${goal.unit}"
        NumberField(label, form.wanted[goal].orEmpty(), isNeeded = false) { onForm(form.with(goal, it)) }
    }
}

/** What will have to be measured, as pictures. */
@Composable
private fun WhatToMeasure() {
    SectionHead(stringResource(R.string.what_to_measure))
    Text(stringResource(R.string.what_to_measure_says), style = MaterialTheme.typography.bodyLarge)
    SuspensionSketch(SuspensionKind.BIFILAR, Orientation.ATHWARTSHIPS)
    Fold(R.string.other_ways) {
        SuspensionSketch(SuspensionKind.BIFILAR, Orientation.FORE_AND_AFT)
        FrameSketch(null)
        SuspensionSketch(SuspensionKind.COMPOUND, Orientation.ATHWARTSHIPS)
    }
}

private val HULL = listOf(Entry.MASS, Entry.LENGTH, Entry.BEAM)
private val ROOM = listOf(
    Entry.MOST_LINE, Entry.LEAST_LINE, Entry.MOST_SPACING, Entry.LEAST_SPACING, Entry.U_LINE, Entry.U_SPACING, Entry.U_LEVEL,
)
private val FINER = listOf(
    Entry.AMPLITUDE, Entry.LEAST_DURATION, Entry.MOST_DURATION, Entry.DECAY, Entry.RATE, Entry.GYRO_NOISE, Entry.ACC_NOISE,
)
