package org.gyradius

import java.nio.ByteBuffer
import java.nio.ByteOrder

/**
 * Samples of one sensor in the order they came.
 *
 * @property stampsNs stamps, ns of the phone's clock.
 * @property values x, y, z of each sample in a row: three times as many; rad/s or m/s² of specific force, phone axes.
 */
class Samples(val channel: Channel, val stampsNs: LongArray, val values: DoubleArray)

/** A batch that the library gave, as one that it takes. */
fun SampleBatch.asSamples() = Samples(channel, stampsNs.toLongArray(), values.flatMap { listOf(it.x, it.y, it.z) }.toDoubleArray())

/** Numbers as the library takes them: little-endian, outside of the JVM's heap, read where they are. */
fun blockOf(numbers: DoubleArray): ByteBuffer =
    direct(numbers.size).apply { asDoubleBuffer().put(numbers) }

/** Stamps as the library takes them. */
fun blockOf(stampsNs: LongArray): ByteBuffer =
    direct(stampsNs.size).apply { asLongBuffer().put(stampsNs) }

/** The floats of a block that the library gave. */
fun ByteArray.asDoubles(): DoubleArray =
    DoubleArray(size / Double.SIZE_BYTES).also { little(this).asDoubleBuffer().get(it) }

/** The stamps of a block that the library gave. */
fun ByteArray.asStamps(): LongArray =
    LongArray(size / Long.SIZE_BYTES).also { little(this).asLongBuffer().get(it) }

private fun direct(numbers: Int): ByteBuffer =
    ByteBuffer.allocateDirect(numbers * Double.SIZE_BYTES).order(ByteOrder.LITTLE_ENDIAN)

private fun little(bytes: ByteArray): ByteBuffer = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN)
