package org.gyradius

import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.double
import kotlinx.serialization.json.int
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestFactory
import java.io.File
import kotlin.math.abs

/** The vectors of `tests/vectors`, as every language runs them; and every output against Python's, bit by bit. */
class VectorsTest {
    private class Case(val algorithm: String, val json: JsonObject) {
        val id = json.text("id")
        val inputs = json.getValue("inputs").jsonObject.mapValues { (_, number) -> number.jsonPrimitive.double }
        val valid = json.text("result") == "valid"
    }

    private val files = File(Shared.root, "tests/vectors").listFiles()!!
        .filter { it.extension == "json" && it.nameWithoutExtension != "schema" }
        .associate { it.nameWithoutExtension to Shared.json(it).jsonObject }

    private val cases = files.flatMap { (name, file) ->
        file.getValue("tests").jsonArray.map { Case(name, it.jsonObject) }
    }

    @Test
    fun `every file is known and whole`() {
        val routes = Shared.json(Shared.python("routes.json")).jsonArray.map { it.jsonObject.text("name") }
        assertEquals(routes.toSet(), files.keys)
        assertEquals(Shared.python("routes.json").readText(), routesJson())
        for ((name, file) in files) {
            assertEquals(name, file.text("algorithm"))
            assertEquals(file.getValue("number_of_tests").jsonPrimitive.int, file.getValue("tests").jsonArray.size, name)
        }
        assertTrue(cases.map { it.id }.toSet().size == cases.size && cases.size > 200, "${cases.size} cases")
    }

    @TestFactory
    fun vectors(): List<DynamicTest> = cases.map { dynamicTest(it.id) { if (it.valid) holds(it) else isRefused(it) } }

    private fun holds(case: Case) {
        val found = evaluateRoute(case.algorithm, case.inputs)
        for ((name, text) in case.json.getValue("expected").jsonObject) {
            val expected = text.jsonPrimitive.content.toDouble()
            val tolerance = case.json.getValue("tolerance").jsonObject.getValue(name).jsonObject
            val (absolute, relative) = listOf("abs", "rel").map { tolerance[it]?.jsonPrimitive?.double ?: 0.0 }
            // Written so that a NaN fails.
            assertTrue(abs(found.getValue(name) - expected) <= absolute + relative * abs(expected)) {
                "$name: ${found[name]}, expected $expected"
            }
        }
    }

    private fun isRefused(case: Case) {
        val refused = when (case.json.text("error")) {
            "argument" -> GyradiusException.BadArgument::class.java
            else -> GyradiusException.NoResult::class.java
        }
        assertThrows(refused) { evaluateRoute(case.algorithm, case.inputs) }
    }

    /** Two faces of one core: the same bits, or the same sentence that refuses. */
    @TestFactory
    fun `python's bits`(): List<DynamicTest> {
        val python = Shared.json(Shared.python("vectors.json")).jsonObject
        assertEquals(cases.map { it.id }.toSet(), python.keys)
        return cases.map { dynamicTest(it.id) { sameAs(python.getValue(it.id).jsonObject, it) } }
    }

    private fun sameAs(python: JsonObject, case: Case) {
        val outputs = python["outputs"]?.jsonObject
        if (outputs == null) {
            val error = assertThrows(GyradiusException::class.java) { evaluateRoute(case.algorithm, case.inputs) }
            return assertEquals(python.text("text"), error.text)
        }
        val bits = evaluateRoute(case.algorithm, case.inputs).mapValues { (_, value) ->
            value.toRawBits().toULong().toString(16).padStart(16, '0')
        }
        assertEquals(outputs.mapValues { (_, hex) -> hex.jsonPrimitive.content }, bits)
    }
}

internal fun JsonObject.text(name: String): String = getValue(name).jsonPrimitive.content
