package org.gyradius.app.run

import org.gyradius.Channel
import org.gyradius.OnProgress
import org.gyradius.Procedure
import org.gyradius.ProcedureEvent
import org.gyradius.ProcedureState
import org.gyradius.Rehearsal
import org.gyradius.Samples
import org.gyradius.push
import org.gyradius.work

/** A procedure under way: on a real hull or on a simulated one. Everything but [state] keeps the thread that calls it. */
interface Run : AutoCloseable {
    /** Everything that a screen shows. */
    fun state(): ProcedureState

    /** Takes what the operator did. */
    fun handle(event: ProcedureEvent)

    /** Does the work that the state wants: seconds or minutes. */
    suspend fun work(onProgress: OnProgress)
}

/** A real hull: what the sensors give is pushed as it comes. */
class Measuring(private val procedure: Procedure) : Run {
    override fun state() = procedure.state()

    override fun handle(event: ProcedureEvent) = procedure.handle(event)

    override suspend fun work(onProgress: OnProgress) = procedure.work(onProgress)

    /** Takes samples of one stream in the order they came. */
    fun push(samples: Samples) = procedure.push(samples)

    override fun close() = procedure.close()
}

/** A simulated hull: time goes by as it is let. */
class Practising(private val rehearsal: Rehearsal) : Run {
    override fun state() = rehearsal.state()

    override fun handle(event: ProcedureEvent) = rehearsal.handle(event)

    override suspend fun work(onProgress: OnProgress) = rehearsal.work(onProgress)

    /** Lets so much time go by, s; returns what did. */
    fun advance(seconds: Double): Double = rehearsal.advance(seconds)

    /** What an operator who plays by the book does now. */
    fun byTheBook(atUtc: String): ProcedureEvent? = rehearsal.byTheBook(atUtc)

    override fun close() = rehearsal.close()
}

/** Which streams a trace shows. */
val Samples.isTurn: Boolean
    get() = channel == Channel.GYROSCOPE
