package org.gyradius.app.run

import android.hardware.Sensor
import android.hardware.SensorEvent
import android.hardware.SensorEventListener
import android.hardware.SensorManager
import android.os.Handler
import android.os.HandlerThread
import kotlinx.coroutines.channels.Channel.Factory.UNLIMITED
import kotlinx.coroutines.channels.awaitClose
import kotlinx.coroutines.flow.Flow
import kotlinx.coroutines.flow.asFlow
import kotlinx.coroutines.flow.buffer
import kotlinx.coroutines.flow.callbackFlow
import org.gyradius.Channel
import org.gyradius.PhoneSensor
import org.gyradius.Samples

/** Where samples come from: the phone, or a recording that is played again. */
interface MotionSource {
    /** The sensors behind it. */
    val sensors: List<PhoneSensor>

    /** Batches in the order they came, for as long as they are collected. */
    fun samples(): Flow<Samples>
}

/** A recording, played as fast as it is taken. */
class ReplaySource(private val recorded: List<Samples>) : MotionSource {
    override val sensors = recorded.map { PhoneSensor(it.channel, "replay", null) }.distinct()

    override fun samples(): Flow<Samples> = recorded.asFlow()
}

/** The phone's own sensors, with their own stamps: the gyroscope as uncalibrated as there is one, for the bias that a phone
 * takes off by itself moves while a hull swings. */
class PhoneSource(private val manager: SensorManager) : MotionSource {
    private val streams: Map<Sensor, Channel> = listOfNotNull(
        firstOf(Sensor.TYPE_GYROSCOPE_UNCALIBRATED, Sensor.TYPE_GYROSCOPE)?.let { it to Channel.GYROSCOPE },
        firstOf(Sensor.TYPE_ACCELEROMETER)?.let { it to Channel.ACCELEROMETER },
    ).toMap()

    override val sensors = streams.map { (sensor, channel) ->
        PhoneSensor(channel, sensor.name ?: "", sensor.maximumRange.toDouble().takeIf { it > 0.0 })
    }

    override fun samples(): Flow<Samples> = callbackFlow {
        val thread = HandlerThread("sensors").apply { start() }
        val gatherers = streams.mapValues { (_, channel) -> Gatherer(channel) { trySend(it) } }
        val listener = object : SensorEventListener {
            override fun onSensorChanged(event: SensorEvent) {
                gatherers[event.sensor]?.take(event.timestamp, event.values)
            }

            override fun onAccuracyChanged(sensor: Sensor, accuracy: Int) = Unit
        }
        streams.keys.forEach { manager.registerListener(listener, it, PERIOD_US, LATENCY_US, Handler(thread.looper)) }
        awaitClose {
            manager.unregisterListener(listener)
            thread.quitSafely()
        }
        // No sample is dropped while the library looks at the swing anew.
    }.buffer(UNLIMITED)

    private fun firstOf(vararg types: Int): Sensor? =
        types.asList().firstNotNullOfOrNull { manager.getDefaultSensor(it) }

    private companion object {
        /** 200 samples per second. */
        const val PERIOD_US = 5_000

        /** So long the sensor's own memory may hold samples back; the screen is drawn about as often. */
        const val LATENCY_US = 100_000
    }
}

/** Gathers samples of one stream into batches: one call to the library for each would cost more than it does. */
internal class Gatherer(private val channel: Channel, private val give: (Samples) -> Unit) {
    private val stamps = LongArray(BATCH)
    private val values = DoubleArray(3 * BATCH)
    private var count = 0

    fun take(stampNs: Long, xyz: FloatArray) {
        stamps[count] = stampNs
        for (axis in 0 until 3) values[3 * count + axis] = xyz[axis].toDouble()
        count += 1
        if (count == BATCH) flush()
    }

    private fun flush() {
        give(Samples(channel, stamps.copyOf(), values.copyOf()))
        count = 0
    }

    private companion object {
        /** A tenth of a second at 200 samples per second. */
        const val BATCH = 20
    }
}
