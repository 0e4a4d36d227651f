package org.gyradius.app.ui

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.safeDrawingPadding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.text.KeyboardOptions
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.FilterChip
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
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.input.KeyboardType
import androidx.compose.ui.unit.dp
import org.gyradius.ProcedureTask
import org.gyradius.app.R
import org.gyradius.app.run.Planned
import org.gyradius.app.run.SetupModel
import org.gyradius.boatTypes

/** The boat as it is roughly known, and what the planner advises. */
@Composable
fun SetupScreen(planned: Planned, model: SetupModel, onBegin: (ProcedureTask) -> Unit) {
    var name by rememberSaveable { mutableStateOf("") }
    var mass by rememberSaveable { mutableStateOf("") }
    var length by rememberSaveable { mutableStateOf("") }
    var beam by rememberSaveable { mutableStateOf("") }
    var type by rememberSaveable { mutableStateOf(boatTypes().first()) }
    Stack(Modifier.safeDrawingPadding().verticalScroll(rememberScrollState()).padding(16.dp)) {
        Text(
            stringResource(R.string.boat),
            Modifier.semantics { heading() },
            style = MaterialTheme.typography.headlineLarge,
        )
        Field(R.string.boat_name, name, KeyboardType.Text) { name = it }
        Field(R.string.boat_mass, mass) { mass = it }
        Field(R.string.boat_length, length) { length = it }
        Field(R.string.boat_beam, beam) { beam = it }
        Types(type) { type = it }
        WideButton(stringResource(R.string.plan), isMain = planned.task == null) {
            model.plan(name, numberIn(mass), numberIn(length), numberIn(beam), type)
        }
        PlanAdvice(planned)
        planned.task?.let { task -> WideButton(stringResource(R.string.to_the_boat)) { onBegin(task) } }
    }
}

@Composable
private fun Types(chosen: String, onType: (String) -> Unit) {
    FlowRow(horizontalArrangement = Arrangement.spacedBy(8.dp)) {
        for (one in boatTypes()) FilterChip(one == chosen, { onType(one) }, { Text(one) })
    }
}

@Composable
private fun PlanAdvice(planned: Planned) {
    if (planned.isPlanning) LinearProgressIndicator()
    planned.error?.let { Advice(it) }
    val plan = planned.plan ?: return
    plan.suspensions.forEach { Text(it.text, style = MaterialTheme.typography.bodyLarge) }
    plan.warnings.forEach { Advice(it.text) }
}

@Composable
private fun Field(label: Int, text: String, keyboard: KeyboardType = KeyboardType.Decimal, onText: (String) -> Unit) {
    OutlinedTextField(
        text,
        onText,
        Modifier.fillMaxWidth(),
        label = { Text(stringResource(label)) },
        keyboardOptions = KeyboardOptions(keyboardType = keyboard),
        singleLine = true,
    )
}

/** A number as people type it, with a comma or a point. */
internal fun numberIn(text: String): Double? = text.trim().replace(',', '.').toDoubleOrNull()
