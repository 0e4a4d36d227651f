package org.gyradius

import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.ensureActive
import kotlinx.coroutines.flow.Flow
import kotlinx.coroutines.flow.channelFlow
import kotlinx.coroutines.isActive
import kotlinx.coroutines.withContext

/** Told the share that is done, 0 to 1, and what is being done; called on threads of the library. */
typealias OnProgress = (share: Double, doing: String) -> Unit

/** Long work as it goes. */
sealed interface Working<out T> {
    /** It goes on: the share that is done, 0 to 1, and what is being done. */
    data class Going(val share: Double, val doing: String) : Working<Nothing>

    /** It is done, and this came of it. */
    data class Done<T>(val value: T) : Working<T>
}

/** Long work as a flow: `working { session.critique(it) }`. Whoever stops collecting stops the work. */
fun <T> working(work: suspend (OnProgress) -> T): Flow<Working<T>> = channelFlow {
    send(Working.Done(work { share, doing -> trySend(Working.Going(share, doing)) }))
}

/**
 * Runs blocking work of the library off the caller's thread; when the coroutine is cancelled, the work is told to stop.
 * What [onProgress] throws stops it too, and is thrown when it has stopped.
 */
internal suspend fun <T> watched(onProgress: OnProgress?, work: (ProgressListener) -> T): T =
    withContext(Dispatchers.Default) {
        var thrown: Throwable? = null
        val listener = object : ProgressListener {
            override fun onProgress(share: Double, doing: String): Boolean {
                if (isActive && thrown == null) thrown = runCatching { onProgress?.invoke(share, doing) }.exceptionOrNull()
                return isActive && thrown == null
            }
        }
        try {
            work(listener)
        } catch (stopped: GyradiusException.Cancelled) {
            thrown?.let { throw it }
            ensureActive()
            throw stopped
        }
    }
