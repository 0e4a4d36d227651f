package org.gyradius.app

import android.system.ErrnoException
import android.system.OsConstants.EDQUOT
import android.system.OsConstants.ENOSPC
import org.gyradius.GyradiusException
import org.gyradius.text

/** What went wrong, for a screen to say. */
sealed interface Failure {
    /** No room is left on the phone: the app has its own words for it. */
    data object DiskFull : Failure

    /** What the library or the system says of it. */
    data class Told(val text: String) : Failure
}

/** What an error comes to, whether the library or the system has met it. */
fun failureOf(wrong: Exception): Failure = when {
    wrong is GyradiusException.DiskFull -> Failure.DiskFull
    wrong is GyradiusException -> Failure.Told(wrong.text)
    generateSequence<Throwable>(wrong) { it.cause }.any { it is ErrnoException && it.errno in FULL } -> Failure.DiskFull
    else -> Failure.Told(wrong.message.orEmpty())
}

private val FULL = setOf(ENOSPC, EDQUOT)
