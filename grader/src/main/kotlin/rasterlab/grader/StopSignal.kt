package rasterlab.grader

import java.time.Duration
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit

/** Holds a process that is told to end (SIGTERM, Ctrl-C) until [close], so that its work can be put away first. */
internal class StopSignal : AutoCloseable {
    private val asked = CountDownLatch(1)
    private val finished = CountDownLatch(1)

    init {
        Runtime.getRuntime().addShutdownHook(
            Thread {
                asked.countDown()
                finished.await()
            },
        )
    }

    fun isAsked(): Boolean = asked.count == 0L

    /** Returns when the process is told to end. */
    fun await() = asked.await()

    /** Returns when the process is told to end, with true, or after [patience]. */
    fun await(patience: Duration): Boolean = asked.await(patience.toMillis(), TimeUnit.MILLISECONDS)

    override fun close() = finished.countDown()
}
