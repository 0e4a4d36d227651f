package org.gyradius.app.store

import java.io.File
import java.io.IOException
import java.io.InputStream
import java.nio.file.Files
import java.time.Instant
import java.time.temporal.ChronoUnit
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import org.gyradius.GyradiusException
import org.gyradius.NamedQuantity
import org.gyradius.Procedure
import org.gyradius.ProcedurePhase
import org.gyradius.app.run.JOURNAL
import org.gyradius.loadSession
import org.gyradius.number
import org.gyradius.text

/** A session as the list shows it. */
data class Listed(
    val folder: File,
    val title: String,
    val at: Instant,
    /** Where its procedure stands; absent for a file that came from elsewhere. */
    val phase: ProcedurePhase?,
    /** The figures, once there are some. */
    val figures: List<NamedQuantity> = emptyList(),
    /** Why it cannot be read. */
    val damage: String? = null,
)

/** A session that can be measured. */
data class Measurable(
    /** The session's folder, or a file from elsewhere. */
    val session: File,
    val title: String,
    /** Class limits to judge it by. */
    val limits: List<String>,
    /** Where its limits are kept, and its criticism once there is one. */
    val folder: File,
)

/** The sessions on the disk: a folder each, named by the moment it was made. */
class SessionStore(filesDir: File, cacheDir: File, private val clock: () -> Instant = Instant::now) {
    private val root = File(filesDir, "sessions")

    /** The limits that were used last. */
    private val usual = File(filesDir, LIMITS)

    /** What was made to be shared; the folder that `res/xml/shared_files.xml` lets out. */
    val shared = File(cacheDir, "shared")

    /** Files from elsewhere until they are whole and read: the list never shows half of one, nor what was left when the app
     * was killed meanwhile. */
    private val arriving = File(cacheDir, "arriving")

    /** The one practice; begun afresh whenever it is not gone on with. */
    val practice = File(filesDir, "practice")

    /** Whether a practice was left that has not come to its end. */
    suspend fun isPracticeLeft(): Boolean = withContext(Dispatchers.IO) {
        File(practice, JOURNAL).exists() && phaseOf(practice) !in setOf(null, ProcedurePhase.DONE)
    }

    /** Throws the last practice away. */
    fun practiceAfresh(): File = practice.apply {
        deleteRecursively()
        mkdirs()
    }

    /** A folder for a new session, with the class limits that it will be judged by. */
    fun create(title: String, limits: List<String> = emptyList()): File {
        val folder = begin(root, title)
        if (limits.isNotEmpty()) keepLimits(folder, limits)
        return folder
    }

    private fun begin(within: File, title: String): File {
        val name = clock().truncatedTo(ChronoUnit.MILLIS).toString().replace(':', '-')
        return File(within, name).apply {
            mkdirs()
            File(this, TITLE).writeText(title)
        }
    }

    /** Keeps the class limits that a session is judged by; the next session is offered the same. */
    fun keepLimits(folder: File, limits: List<String>) =
        listOf(File(folder, LIMITS), usual).forEach { it.writeText(limits.joinToString("\n")) }

    /** Class limits that were used last. */
    fun usualLimits(): List<String> = limitsIn(usual)

    /** All sessions, the newest first. Must not be asked while one is under way: a procedure has one owner. */
    suspend fun list(): List<Listed> = withContext(Dispatchers.IO) {
        root.listFiles { one -> one.isDirectory }.orEmpty().sortedByDescending { it.name }.map(::listed)
    }

    /** Removes it for good. */
    suspend fun remove(folder: File) = withContext(Dispatchers.IO) { folder.deleteRecursively() }

    /** Packs a session for others: one that was measured is a session's zip as every `gyradius` reads it, with all that
     * the procedure knows beside it. */
    suspend fun share(session: Listed): File = withContext(Dispatchers.IO) {
        shared.mkdirs()
        val file = fileOf(session.folder)
        if (file != null) file.copyTo(File(shared, file.name), overwrite = true)
        else File(shared, "${plain(session.title)}.zip").also { pack(session.folder, it) }
    }

    /** Takes in a file from elsewhere: what [share] packed goes on here, anything else must be readable as a session or a
     * recording. */
    suspend fun import(name: String, content: InputStream): Listed = withContext(Dispatchers.IO) {
        val folder = begin(arriving, name.substringBeforeLast('.'))
        try {
            val file = File(folder, FILE + plain(name))
            file.outputStream().use { content.copyTo(it) }
            if (isPacked(file)) takeApart(file, folder)
            else loadSession(file).use { File(folder, TITLE).writeText(it.title()) }
            root.mkdirs()
            listed(Files.move(folder.toPath(), File(root, folder.name).toPath()).toFile())
        } catch (wrong: Exception) {
            folder.deleteRecursively()
            throw wrong
        }
    }

    /** What of a session's folder can be measured: an imported file, or what a procedure has gathered. */
    fun measurable(folder: File): Measurable? {
        val session = fileOf(folder) ?: File(folder, SESSION).takeIf { it.exists() } ?: return null
        return Measurable(session, titleOf(folder), limitsIn(File(folder, LIMITS)), folder)
    }

    private fun limitsIn(file: File) = if (file.exists()) file.readLines().filter { it.isNotEmpty() } else emptyList()

    private fun titleOf(folder: File) = File(folder, TITLE).takeIf { it.exists() }?.readText().orEmpty()

    /** The file that an imported session is. */
    private fun fileOf(folder: File): File? = folder.listFiles { one -> one.name.startsWith(FILE) }?.firstOrNull()

    private fun takeApart(file: File, folder: File) {
        unpack(file, folder)
        file.delete()
    }

    private fun listed(folder: File): Listed {
        val bare = Listed(folder, titleOf(folder), Instant.parse(stampOf(folder.name)), phase = null)
        if (fileOf(folder) != null) return bare
        return try {
            Procedure.open(folder.path).use { procedure ->
                val state = procedure.state()
                val figures = state.result?.quantities.orEmpty().filter { it.quantity.value.number != null }
                bare.copy(phase = state.phase, figures = figures)
            }
        } catch (wrong: GyradiusException) {
            bare.copy(damage = wrong.text)
        }
    }

    private fun phaseOf(folder: File): ProcedurePhase? = try {
        Procedure.open(folder.path).use { it.state().phase }
    } catch (_: GyradiusException) {
        null
    }

    private companion object {
        const val TITLE = "title.txt"

        /** A class limit in each line. */
        const val LIMITS = "limits.txt"

        /** The procedure's own. */
        const val SESSION = "session"
        const val FILE = "imported-"

        /** `2026-05-04T09-30-00.123Z` is `2026-05-04T09:30:00.123Z`. */
        fun stampOf(name: String) = name.substringBefore('T') + "T" + name.substringAfter('T').replace('-', ':')

        fun plain(name: String) = name.replace(Regex("[^\\p{L}\\p{N}._-]+"), "-").ifBlank { "session" }
    }
}

/** A file that is not what it says. */
class BadZip(message: String) : IOException(message)
