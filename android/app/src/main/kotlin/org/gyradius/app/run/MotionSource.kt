package org.gyradius.app.run

import android.hardware.Sensor
import android.hardware.SensorEvent
import android.hardware.SensorEventListener
import android.hardware.SensorManager
import android.os.Handler
import android.os.HandlerThread
import org.gyradius.Channel
import org.gyradius.PhoneSensor
import org.gyradius.Samples

/** Where samples come from. They gather until they are taken, so that none is lost while the library is busy. */
interface MotionSource : AutoCloseable {
    /** The sensors behind it. */
    val sensors: List<PhoneSensor>

    /** Begins to gather. */
    fun open()

    /** What came since the last call: a batch for each stream that has any, in the order the samples came. */
    fun take(): List<Samples>

    /** Gathers no more; what came before can still be taken. */
    override fun close()
}

/** The phone's own sensors, with their own stamps: the gyroscope as uncalibrated as there is one, for the bias that a phone
 * takes off by itself moves while a hull swings. */
class PhoneSource(private val manager: SensorManager) : MotionSource {
    private val gatherers: Map<Sensor, Gatherer> = listOfNotNull(
        firstOf(Sensor.TYPE_GYROSCOPE_UNCALIBRATED, Sensor.TYPE_GYROSCOPE)?.let { it to Gatherer(Channel.GYROSCOPE) },
        firstOf(Sensor.TYPE_ACCELEROMETER)?.let { it to Gatherer(Channel.ACCELEROMETER) },
    ).toMap()

    /** Its own, so that a busy screen never holds up a sample. */
    private val thread = HandlerThread("sensors")

    private val listener = object : SensorEventListener {
        override fun onSensorChanged(event: SensorEvent) {
            synchronized(gatherers) { gatherers[event.sensor]?.add(event.timestamp, event.values) }
        }

        override fun onAccuracyChanged(sensor: Sensor, accuracy: Int) = Unit
    }

    override val sensors = gatherers.map { (sensor, gatherer) ->
        PhoneSensor(gatherer.channel, sensor.name ?: "", sensor.maximumRange.toDouble().takeIf { it > 0.0 })
    }

    override fun open() {
        thread.start()
        val handler = Handler(thread.looper)
        gatherers.keys.forEach { manager.registerListener(listener, it, PERIOD_US, latencyUs(it), handler) }
    }

    /** Streams are taken at the same moment and go hand in hand: after a hold-up none must seem to lag behind another. */
    override fun take(): List<Samples> {
        val taken = synchronized(gatherers) { gatherers.values.mapNotNull { it.take() } }
        return taken.flatMap { it.slices() }.sortedBy { it.stampsNs.last() }
    }

    override fun close() {
        manager.unregisterListener(listener)
        thread.quitSafely()
    }

    private fun firstOf(vararg types: Int): Sensor? =
        types.asList().firstNotNullOfOrNull { manager.getDefaultSensor(it) }

    /** A sensor with memory of its own need not wake the processor for each sample. */
    private fun latencyUs(sensor: Sensor): Int = if (sensor.fifoReservedEventCount > 0) LATENCY_US else 0

    private companion object {
        /** 200 samples per second; more would need a permission. */
        const val PERIOD_US = 5_000

        /** So long the sensor's own memory may hold samples back; the screen is drawn as often. */
        const val LATENCY_US = 100_000
    }
}

/** The same samples, a tenth of a second at a time. */
private fun Samples.slices(): List<Samples> = stampsNs.indices.step(SLICE).map { from ->
    val to = minOf(from + SLICE, stampsNs.size)
    Samples(channel, stampsNs.copyOfRange(from, to), values.copyOfRange(3 * from, 3 * to))
}

private const val SLICE = 20

/** Gathers samples of one stream: one call to the library for each sample would cost more than the sample does. Whoever has it
 * sees to it that one thread at a time fills or empties it. */
internal class Gatherer(val channel: Channel) {
    private var stampsNs = LongArray(ROOM)
    private var values = DoubleArray(3 * ROOM)
    private var count = 0

    fun add(stampNs: Long, xyz: FloatArray) {
        if (count == stampsNs.size) grow()
        stampsNs[count] = stampNs
        for (axis in 0 until 3) values[3 * count + axis] = xyz[axis].toDouble()
        count += 1
    }

    fun take(): Samples? {
        if (count == 0) return null
        return Samples(channel, stampsNs.copyOf(count), values.copyOf(3 * count)).also { count = 0 }
    }

    private fun grow() {
        stampsNs = stampsNs.copyOf(2 * count)
        values = values.copyOf(6 * count)
    }

    private companion object {
        /** More than half a second at 200 samples per second. */
        const val ROOM = 128
    }
}
