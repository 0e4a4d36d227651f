package org.gyradius

import kotlinx.coroutines.flow.asFlow
import kotlinx.coroutines.flow.last
import kotlinx.coroutines.runBlocking
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.io.File
import java.util.concurrent.atomic.AtomicBoolean
import java.util.concurrent.atomic.AtomicLong
import kotlin.concurrent.thread
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.random.Random

/** Samples from several threads: none is lost, none is changed. */
class SensorsTest {
    @TempDir
    lateinit var folder: File

    private val seed = System.nanoTime().also { println("seed $it") }

    /** A turn of 5 degrees with a period of 4 s, a phone's noise, and gravity on the accelerometer. */
    private fun swing(channel: Channel, seconds: Int, perBatch: Int): List<Samples> {
        val (random, omega) = Random(seed + channel.ordinal) to 2.0 * PI / 4.0
        val row = { i: Int ->
            val turn = if (channel == Channel.GYROSCOPE) Math.toRadians(5.0) * omega * cos(omega * i / 100.0) else 9.81
            List(3) { axis -> random.nextDouble(-1e-3, 1e-3) + if (axis == 2) turn else 0.0 }
        }
        return (0 until 100 * seconds).chunked(perBatch).map { rows ->
            Samples(channel, LongArray(rows.size) { 10_000_000L * rows[it] }, rows.flatMap(row).toDoubleArray())
        }
    }

    private fun inThreads(vararg acts: () -> Unit) {
        val failures = java.util.concurrent.ConcurrentLinkedQueue<Throwable>()
        val threads = acts.map { act -> thread { runCatching(act).onFailure(failures::add) } }
        threads.forEach(Thread::join)
        failures.firstOrNull()?.let { throw it }
    }

    @Test
    fun `the live estimator takes both sensors from threads of their own while a third reads`() {
        val live = LiveEstimator(1e-3, null, null)
        val pushers = listOf(Channel.GYROSCOPE, Channel.ACCELEROMETER).map { channel ->
            { swing(channel, 60, 20).forEach(live::push) }
        }
        val read = AtomicLong()
        val reader = { repeat(200) { read.addAndGet(live.estimate().sensors.size.toLong()) } }
        inThreads(pushers[0], pushers[1], reader)
        val estimate = live.estimate()
        assertEquals(400, read.get())
        assertEquals(listOf(6000uL, 6000uL), estimate.sensors.map { it.samples + it.leftOut })
        assertEquals(listOf(0uL, 0uL), estimate.sensors.map { it.leftOut })
    }

    @Test
    fun `estimates flow, and find the period`() = runBlocking {
        val estimate = swing(Channel.GYROSCOPE, 60, 20).asFlow().estimates(LiveEstimator(1e-3, null, null)).last()
        val swing = estimate.swing!!
        assertTrue(abs(swing.periodS - 4.0) < 5.0 * swing.periodUS, "$swing")
        assertEquals(5.0, swing.amplitudeDeg!!, 0.1)
        val texts = estimate.advice.map { liveSentence(it) }
        assertTrue(texts.any { it.key == "live.sensor_absent" && "accelerometer" in it.english }, "$texts")
    }

    @Test
    fun `half a megabyte of stack is enough for what comes with every batch`() {
        // As much as iOS gives the threads of an app.
        val (stack, live) = 512L * 1024 to LiveEstimator(1e-3, null, null)
        val batches = swing(Channel.GYROSCOPE, 60, 20) + swing(Channel.ACCELEROMETER, 60, 20)
        val small = Thread(null, { batches.sortedBy { it.stampsNs[0] }.forEach(live::push) }, "small", stack)
        small.start()
        small.join()
        assertEquals(4.0, live.estimate().swing!!.periodS, 0.01)
    }

    private val header = RecorderHeader(
        phone = "phone",
        sensors = listOf(RecorderSensor(Channel.GYROSCOPE, "LSM6DSO", 17.45)),
        notes = listOf(NamedText("operator", "A")),
    )

    @Test
    fun `a recorder that three threads push to loses nothing and keeps every bit`() {
        val path = File(folder, "take.gyr").path
        val streams = Channel.entries.associateWith { swing(it, 30, 7) }
        RecorderWriter.create(path, header).use { writer ->
            inThreads(*streams.values.map { batches -> { batches.forEach { writer.push(it) } } }.toTypedArray())
            writer.mark(RecorderMark(29_000_000_000, "release"))
            writer.end(30_000_000_000)
            assertThrows(GyradiusException.BadArgument::class.java) { writer.flush() }
        }
        val file = RecorderFile.read(path)
        assertEquals(header, file.header())
        assertEquals(emptyList<RecorderDamage>(), file.damage())
        assertEquals(listOf("release", "end"), file.marks().map { it.key })
        for (track in file.samples()) {
            val pushed = streams.getValue(track.channel)
            assertArrayEquals(pushed.flatMap { it.stampsNs.asList() }.toLongArray(), track.stampsNs)
            assertBits(pushed.flatMap { it.values.asList() }.toDoubleArray(), track.values)
        }
        assertEquals(Channel.entries, file.samples().map { it.channel })
    }

    @Test
    fun `a block that nobody else holds stays until the call that reads it returns`() {
        val (random, over) = Random(seed) to AtomicBoolean()
        // Whole seconds: their nanoseconds are exact.
        val seconds = List(16) { DoubleArray(512) { random.nextInt(1_000_000).toDouble() } }
        val expected = seconds.map { block -> LongArray(block.size) { 1_000_000_000L * block[it].toLong() } }
        val caller = {
            try {
                repeat(10_000) {
                    val i = it % seconds.size
                    assertArrayEquals(expected[i], stampsFromCoreMotion(blockOf(seconds[i])).asStamps(), "call $it")
                }
            } finally {
                over.set(true)
            }
        }
        val collector = { while (!over.get()) System.gc() }
        inThreads(caller, caller, collector)
    }

    @Test
    fun `a recording that was cut off says so, goes on, and becomes a table`() {
        val path = File(folder, "cut.gyr")
        val batches = swing(Channel.GYROSCOPE, 4, 50)
        RecorderWriter.create(path.path, header).use { writer ->
            batches.take(4).forEach { writer.push(it) }
            writer.flush()
        }
        path.appendBytes(byteArrayOf(1, 2, 3))
        assertEquals(listOf(DamageKind.CUT_TAIL), RecorderFile.read(path.path).damage().map { it.kind })
        RecorderWriter.resume(path.path).use { writer ->
            batches.drop(4).forEach { writer.push(it) }
            writer.end(4_000_000_000)
        }
        val file = RecorderFile.read(path.path)
        assertEquals(400, file.samples().single().stampsNs.size)
        assertEquals(listOf(DamageKind.RESUMED), file.damage().map { it.kind })
        assertEquals(file.damage().map { it.text }, convertRecorderFile(path.path, folder.path, "cut"))
        assertEquals(401, File(folder, "cut.csv").readLines().size)
    }

    @Test
    fun `Core Motion's accelerations are specific forces of the other sign, its times stamps`() {
        // At rest, screen up, iOS gives -1 g along z; standard gravity is 9.80665 m/s² by definition.
        val forces = forcesFromCoreMotion(blockOf(doubleArrayOf(0.0, 0.0, -1.0, 0.5, -0.25, 0.0))).asDoubles()
        assertEquals(listOf(0.0, 0.0, 9.80665), forces.take(3).map { it + 0.0 })
        assertEquals(listOf(-4.903325, 2.4516625), forces.drop(3).take(2))
        val stamps = stampsFromCoreMotion(blockOf(doubleArrayOf(0.01, 345_678.123456789))).asStamps()
        assertArrayEquals(longArrayOf(10_000_000, 345_678_123_456_789), stamps)
    }
}
