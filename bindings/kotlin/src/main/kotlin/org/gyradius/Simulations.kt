package org.gyradius

/** Outputs of one route of the paper; `evaluateRoute` of the library with named numbers in a row. */
fun evaluateRoute(name: String, vararg inputs: Pair<String, Double>): Map<String, Double> =
    evaluateRoute(name, mapOf(*inputs))

/** Simulates a swing as its phone samples it, or at the times given, s; [values] replace numbers by name. */
fun Rig.simulate(
    swing: String,
    values: Map<String, Double> = emptyMap(),
    derivatives: List<String> = emptyList(),
    tS: DoubleArray? = null,
    seed: ULong? = null,
): Simulation {
    val numbers = values.map { (name, value) -> NamedNumber(name, value) }
    return if (tS == null) simulate(swing, numbers, derivatives, seed)
    else simulateAt(swing, blockOf(tS), numbers, derivatives, seed)
}

/** The damped oscillations of channels that share one clock; times in s. */
fun decompose(tS: DoubleArray, channels: List<DoubleArray>): Decomposition {
    if (channels.any { it.size != tS.size }) {
        throw GyradiusException.BadArgument("argument `channels`: expected channels as long as the times", "channels")
    }
    val flat = DoubleArray(channels.sumOf { it.size })
    channels.fold(0) { at, channel -> channel.copyInto(flat, at); at + channel.size }
    return Decomposition.of(blockOf(tS), blockOf(flat))
}

/** The fitted oscillations at any times, s: one array for each channel. */
fun Decomposition.evaluate(tS: DoubleArray): List<DoubleArray> {
    val flat = evaluate(blockOf(tS)).asDoubles()
    return if (tS.isEmpty()) emptyList() else flat.asList().chunked(tS.size) { it.toDoubleArray() }
}
