package org.gyradius

import kotlinx.coroutines.runBlocking
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.io.File

/** What goes wrong arrives as the right exception, with what is wrong and where. */
class ErrorsTest {
    @TempDir
    lateinit var folder: File

    private inline fun <reified T : GyradiusException> thrown(noinline act: () -> Unit): T =
        assertThrows(T::class.java, act)

    @Test
    fun `a file that is not there, and one that is wrong in a line`() {
        val missing = thrown<GyradiusException.BadFile> { Session.load("/no/such/session", emptyList()) }
        assertEquals("/no/such/session", missing.file)
        assertEquals(null, missing.line)

        val toml = File(folder, "session.toml")
        toml.writeText(File(Shared.session("keelboat"), "session.toml").readText() + "\n[sight]\n")
        val wrong = thrown<GyradiusException.BadFile> { Session.load(folder.path, emptyList()) }
        assertEquals(toml.path, wrong.file)
        assertEquals(toml.readLines().indexOf("[sight]") + 1, wrong.line?.toInt())
        assertTrue("unknown key `sight`" in wrong.text && "`site`" in wrong.text, wrong.text)
        assertEquals(wrong.text, wrong.toString())
        assertTrue(wrong.text in wrong.message, wrong.message)
    }

    @Test
    fun `a file that is there already`() {
        val header = RecorderHeader("phone", emptyList(), emptyList())
        val path = File(folder, "take.gyr").path
        RecorderWriter.create(path, header).use { }
        val error = thrown<GyradiusException.Unwritable> { RecorderWriter.create(path, header) }
        assertEquals(path, error.file)
    }

    @Test
    fun `a bare recording cannot be criticised`() {
        val bare = Session.load(File(Shared.session("boat-park"), "yaw-sway.csv").path, emptyList())
        val error = thrown<GyradiusException.NoResult> { runBlocking { bare.critique() } }
        assertTrue("dimensions" in error.text, error.text)
        assertEquals(bare.title(), error.what)
    }

    @Test
    fun `arguments outside of their domain`() {
        val route = thrown<GyradiusException.BadArgument> { evaluateRoute("yaw_gyradus") }
        assertTrue("yaw_gyradius" in route.text, route.text)
        val limit = thrown<GyradiusException.BadArgument> {
            runBlocking { loadSession(Shared.session("keelboat")).measure(listOf("k_yaw")) }
        }
        assertTrue(limit.text.isNotEmpty())
        thrown<GyradiusException.BadArgument> { LiveEstimator(0.0, null, null) }
        thrown<GyradiusException.BadArgument> { decompose(doubleArrayOf(0.0, 1.0), listOf(doubleArrayOf(1.0))) }
    }

    @Test
    fun `a block that is not whole`() {
        val live = LiveEstimator(1e-4, null, null)
        val short = thrown<GyradiusException.BadArgument> {
            live.push(Samples(Channel.GYROSCOPE, longArrayOf(0, 1), doubleArrayOf(0.0, 0.0, 0.0)))
        }
        assertTrue("as many values as stamps" in short.text, short.text)
        val ragged = thrown<GyradiusException.BadArgument> {
            live.push(Samples(Channel.GYROSCOPE, longArrayOf(0), doubleArrayOf(0.0, 0.0)))
        }
        assertEquals("values", ragged.name)
    }

    @Test
    fun `no route gives NaN or breaks, whatever it is given`() {
        val odd = listOf(0.0, -0.0, Double.NaN, Double.POSITIVE_INFINITY, 1e300, -1.0, 1e-300)
        for (number in odd) {
            val outcome = runCatching {
                evaluateRoute("yaw_period", "gyradius_m" to number, "line_length_m" to number, "spacing_m" to number)
            }
            val error = outcome.exceptionOrNull()
            assertTrue(error == null || error is GyradiusException, "$error")
            assertTrue(outcome.getOrDefault(emptyMap()).values.all { it.isFinite() })
        }
    }
}
