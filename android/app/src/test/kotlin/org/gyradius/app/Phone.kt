package org.gyradius.app

import android.hardware.Sensor
import android.hardware.SensorEventListener
import android.hardware.SensorManager
import android.os.Handler
import android.os.Looper
import androidx.test.core.app.ApplicationProvider
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit.SECONDS
import kotlin.random.Random
import org.gyradius.Simulation
import org.gyradius.asDoubles
import org.junit.Assert.assertNotEquals
import org.junit.Assert.assertTrue
import org.robolectric.annotation.Implementation
import org.robolectric.annotation.Implements
import org.robolectric.shadow.api.Shadow
import org.robolectric.shadows.SensorEventBuilder
import org.robolectric.shadows.ShadowSensor
import org.robolectric.shadows.ShadowSensorManager

/** Delivers events where Android does: on the handler that a listener was registered with. Robolectric's own uses the caller's
 * thread. */
@Implements(SensorManager::class)
class HandledSensors : ShadowSensorManager() {
    private val handlers = ConcurrentHashMap<SensorEventListener, Handler>()

    @Implementation
    public override fun registerListener(
        listener: SensorEventListener, sensor: Sensor, periodUs: Int, latencyUs: Int, handler: Handler,
    ): Boolean {
        assertNotEquals("samples must not be handled on the main thread", Looper.getMainLooper(), handler.looper)
        assertTrue("more than 200 Hz need a permission", periodUs >= 5_000)
        handlers[listener] = handler
        latenciesUs[sensor] = latencyUs
        return super.registerListener(listener, sensor, periodUs, latencyUs, handler)
    }

    @Implementation
    public override fun unregisterListener(listener: SensorEventListener) {
        handlers -= listener
        super.unregisterListener(listener)
    }

    /** So long each sensor's own memory may hold samples back. */
    val latenciesUs = ConcurrentHashMap<Sensor, Int>()

    /** How many listen. */
    val listening get() = handlers.size

    fun deliver(sensor: Sensor, stampNs: Long, xyz: FloatArray) {
        for ((listener, handler) in handlers) {
            if (hasListener(listener, sensor)) handler.post { listener.onSensorChanged(SensorEventBuilder.newBuilder(sensor, xyz).setTimestamp(stampNs).build()) }
        }
    }

    /** Returns once everything delivered so far was handled. */
    fun settle() {
        val left = CountDownLatch(handlers.size)
        handlers.values.forEach { it.post(left::countDown) }
        assertTrue("the sensors' thread stands still", left.await(120, SECONDS))
    }
}

/** A phone with a gyroscope and an accelerometer, whose events a test makes. */
class Phone {
    val gyroscope: Sensor = ShadowSensor.newInstance(Sensor.TYPE_GYROSCOPE_UNCALIBRATED)
    val accelerometer: Sensor = ShadowSensor.newInstance(Sensor.TYPE_ACCELEROMETER)

    /** How many events of each sensor were sent. */
    @Volatile
    var sent = 0
        private set

    private val app = ApplicationProvider.getApplicationContext<GyradiusApp>()
    private val sensors: HandledSensors = Shadow.extract(app.getSystemService(SensorManager::class.java))
    private val random = Random(1)
    private var nowNs = 7_000_000_000_000L

    val listening get() = sensors.listening
    val latenciesUs: Map<Sensor, Int> get() = sensors.latenciesUs

    init {
        sensors.addSensor(gyroscope)
        sensors.addSensor(accelerometer)
    }

    /** Lies still and level for so long. */
    fun rest(seconds: Double, of: List<Sensor> = listOf(gyroscope, accelerometer)) {
        repeat((seconds * RATE_HZ).toInt()) {
            send(of, floatArrayOf(noise(), noise(), noise()), floatArrayOf(noise(), noise(), 9.80665f + noise()))
        }
        sensors.settle()
    }

    /** Gives nothing for so long. */
    fun pause(seconds: Double) {
        nowNs += (seconds * 1e9).toLong()
    }

    /** Rides on a simulated hull; asked before each second of it whether to go on. */
    fun ride(swing: Simulation, isWanted: () -> Boolean = { true }) {
        val readings = swing.readings().asDoubles()
        for (row in readings.indices step 6) {
            if (row % (6 * RATE_HZ) == 0 && !isWanted()) break
            val six = FloatArray(6) { readings[row + it].toFloat() }
            send(listOf(gyroscope, accelerometer), six.copyOfRange(0, 3), six.copyOfRange(3, 6))
        }
        sensors.settle()
    }

    private fun send(of: List<Sensor>, rate: FloatArray, force: FloatArray) {
        if (gyroscope in of) sensors.deliver(gyroscope, nowNs, rate)
        if (accelerometer in of) sensors.deliver(accelerometer, nowNs, force)
        nowNs += 1_000_000_000L / RATE_HZ
        sent += 1
    }

    private fun noise() = random.nextDouble(-1e-3, 1e-3).toFloat()

    companion object {
        const val RATE_HZ = 200
    }
}
