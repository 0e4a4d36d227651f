package org.gyradius

import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.flow.Flow
import kotlinx.coroutines.flow.flowOn
import kotlinx.coroutines.flow.map

/** Takes samples of the gyroscope or the accelerometer; the bias of the gyroscope says nothing of the swing. */
fun LiveEstimator.push(samples: Samples) {
    val sensor = when (samples.channel) {
        Channel.GYROSCOPE -> Sensor.GYROSCOPE
        Channel.ACCELEROMETER -> Sensor.ACCELEROMETER
        Channel.GYROSCOPE_BIAS -> return
    }
    push(sensor, blockOf(samples.stampsNs), blockOf(samples.values))
}

/** The estimate after each batch of samples. */
fun Flow<Samples>.estimates(estimator: LiveEstimator): Flow<LiveEstimate> = map {
    estimator.push(it)
    estimator.estimate()
}.flowOn(Dispatchers.Default)

/** Takes samples of one stream in the order they came. */
fun RecorderWriter.push(samples: Samples): Written =
    push(samples.channel, blockOf(samples.stampsNs), blockOf(samples.values))

/** Samples of every stream that has any, bit for bit as the phone gave them. */
fun RecorderFile.samples(): List<Samples> =
    tracks().map { Samples(it.channel, it.stampsNs.asStamps(), it.values.asDoubles()) }

/** Takes samples of one stream in the order they came. */
fun Procedure.push(samples: Samples) = push(samples.channel, blockOf(samples.stampsNs), blockOf(samples.values))

/** Does the work that is wanted, if there is any: seconds or minutes. Other calls go on meanwhile. */
suspend fun Procedure.work(onProgress: OnProgress? = null) = watched(onProgress) { workBlocking(it) }

/** Does the work that is wanted, if there is any: seconds or minutes. */
suspend fun Rehearsal.work(onProgress: OnProgress? = null) = watched(onProgress) { workBlocking(it) }
