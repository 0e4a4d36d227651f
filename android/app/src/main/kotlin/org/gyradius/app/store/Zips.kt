package org.gyradius.app.store

import java.io.File
import java.util.zip.ZipEntry
import java.util.zip.ZipFile
import java.util.zip.ZipOutputStream
import org.gyradius.app.run.JOURNAL

/** Where the procedure's own files are in a zip; the session's stand at its root, where every reader looks for them. */
private const val PROCEDURE = "procedure/"
private const val SESSION = "session/"

/** Packs a procedure's folder. */
internal fun pack(folder: File, zip: File) = ZipOutputStream(zip.outputStream().buffered()).use { out ->
    for (file in folder.walkTopDown().filter { it.isFile }.sorted()) {
        val inside = file.relativeTo(folder).invariantSeparatorsPath
        out.putNextEntry(ZipEntry(if (inside.startsWith(SESSION)) inside.removePrefix(SESSION) else PROCEDURE + inside))
        file.inputStream().use { it.copyTo(out) }
        out.closeEntry()
    }
}

/** Whether a file is what [pack] made. */
internal fun isPacked(file: File): Boolean =
    file.extension.lowercase() == "zip" && ZipFile(file).use { it.getEntry(PROCEDURE + JOURNAL) != null }

/** Undoes [pack]. */
internal fun unpack(zip: File, folder: File) = ZipFile(zip).use { packed ->
    for (entry in packed.entries().asSequence().filterNot { it.isDirectory }) {
        val inside = if (entry.name.startsWith(PROCEDURE)) entry.name.removePrefix(PROCEDURE) else SESSION + entry.name
        val file = File(folder, inside).canonicalFile
        // A name with `..` would be written anywhere.
        if (!file.startsWith(folder.canonicalFile)) throw BadZip(entry.name)
        file.parentFile?.mkdirs()
        packed.getInputStream(entry).use { from -> file.outputStream().use { from.copyTo(it) } }
    }
}
