package org.gyradius

import kotlinx.coroutines.CancellationException
import kotlinx.coroutines.CompletableDeferred
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.async
import kotlinx.coroutines.cancelAndJoin
import kotlinx.coroutines.flow.first
import kotlinx.coroutines.flow.takeWhile
import kotlinx.coroutines.flow.toList
import kotlinx.coroutines.runBlocking
import kotlinx.coroutines.withTimeout
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertInstanceOf
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.util.concurrent.CopyOnWriteArrayList

/** Long work tells how far it is, and stops when nobody wants it any more. */
class WorkTest {
    // Five swings with samples: its criticism takes a minute or more.
    private val session = Session.load(Shared.session("boat-park").path, emptyList())

    @Test
    fun `a criticism is cancelled half-way with its coroutine`() = runBlocking(Dispatchers.Default) {
        val (begun, shares) = CompletableDeferred<Unit>() to CopyOnWriteArrayList<Double>()
        val work = async {
            session.critique { share, doing ->
                shares += share
                assertTrue(doing.isNotEmpty())
                if (share > 0.0) begun.complete(Unit)
            }
        }
        begun.await()
        withTimeout(60_000) { work.cancelAndJoin() }
        assertThrows(CancellationException::class.java) { runBlocking { work.await() } }
        assertEquals(shares.sorted(), shares.toList())
        assertTrue(shares.last() < 1.0, "$shares")
        // The session is as good as before.
        assertEquals(5, session.swingIds().size)
    }

    @Test
    fun `what the listener throws stops the work and is thrown`() {
        val error = assertThrows(IllegalStateException::class.java) {
            runBlocking { session.critique { _, _ -> error("enough") } }
        }
        assertEquals("enough", error.message)
    }

    @Test
    fun `a listener that answers no gets Cancelled`() {
        val no = object : ProgressListener {
            override fun onProgress(share: Double, doing: String) = false
        }
        assertThrows(GyradiusException.Cancelled::class.java) { session.critiqueBlocking(no) }
        assertThrows(GyradiusException.Cancelled::class.java) { session.measureBlocking(emptyList(), no) }
    }

    @Test
    fun `a measurement stops between two swings`() {
        val told = CopyOnWriteArrayList<String>()
        val untilSecond = object : ProgressListener {
            override fun onProgress(share: Double, doing: String) = told.add(doing) && told.size < 2
        }
        assertThrows(GyradiusException.Cancelled::class.java) { session.measureBlocking(emptyList(), untilSecond) }
        assertEquals(listOf("reading yaw-sway", "reading surge-pitch"), told)
    }

    @Test
    fun `work as a flow ends with what came of it`() = runBlocking {
        val told = working { loadSession(Shared.session("keelboat")).measure(onProgress = it) }.toList()
        val shares = told.filterIsInstance<Working.Going>().map { it.share }
        assertTrue(shares.size > 3 && shares.first() == 0.0 && shares == shares.sorted(), "$shares")
        val done = assertInstanceOf(Working.Done::class.java, told.last()).value
        assertInstanceOf(Analysis::class.java, done)
        // Who stops collecting stops the work.
        withTimeout(60_000) { working { session.critique(it) }.takeWhile { it is Working.Going }.first() }
        Unit
    }
}
