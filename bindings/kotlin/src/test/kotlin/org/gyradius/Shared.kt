package org.gyradius

import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonElement
import java.io.File

/** The repository, and what Python made of the same input (`tests/faces/write_results.py`). */
object Shared {
    val root: File = File(System.getProperty("gyradius.root")).canonicalFile
    private val python: File = File(System.getProperty("gyradius.python")).canonicalFile

    /** A file of Python's; it is an error, not a skip, where there is none. */
    fun python(name: String): File {
        val file = File(python, name)
        check(file.exists()) { "$file is not there: `make test-kotlin` writes it" }
        return file
    }

    fun json(file: File): JsonElement = Json.parseToJsonElement(file.readText())

    fun session(name: String) = File(root, "python/gyradius/sessions/$name")

    fun rig(): Rig = Rig.read(File(root, "python/gyradius/rigs/keelboat.toml").path)

    const val AT_UTC = "2026-05-04T09:30:00Z"
    const val SEED = 20140101UL
}
