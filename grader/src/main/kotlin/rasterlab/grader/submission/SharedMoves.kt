package rasterlab.grader.submission

import org.slf4j.LoggerFactory
import rasterlab.grader.storage.Database
import java.sql.SQLException
import java.time.Duration
import java.util.concurrent.Executors
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicBoolean
import kotlin.concurrent.thread

/**
 * Tells the processes that share a database when the queue moves in one of them, so that those who watch at another learn
 * of it at once. What is lost on the way is found by the next sweep.
 *
 * @param name of this process
 */
class SharedMoves(
    private val database: Database,
    private val name: String,
) : AutoCloseable {
    private val log = LoggerFactory.getLogger(javaClass)
    private val untold = AtomicBoolean()
    private val teller = Executors.newSingleThreadExecutor { Thread(it, "moves-told").apply { isDaemon = true } }
    private var listener: Thread? = null

    /** Returns at once; moves that come while the others are told are told together. */
    fun tell() {
        if (!database.isShared || teller.isShutdown || untold.getAndSet(true)) return
        teller.execute {
            untold.set(false)
            try {
                database.tell(name)
            } catch (failure: SQLException) {
                log.debug("others learn of a move by their sweeps: {}", failure.toString())
            }
        }
    }

    /** Calls [heard] for each move in another process, until [close]. */
    fun listen(heard: () -> Unit) {
        if (!database.isShared) return
        listener = thread(name = "moves-heard", isDaemon = true) { while (hearSome(heard)) continue }
    }

    /** Listens as long as the connection lasts; false when there is nothing more to hear. */
    private fun hearSome(heard: () -> Unit): Boolean {
        try {
            database.listen { if (it != name) heard() }
            if (Thread.currentThread().isInterrupted) return false
        } catch (failure: SQLException) {
            log.debug("other processes are not heard for a while: {}", failure.toString())
        }
        try {
            TimeUnit.NANOSECONDS.sleep(PAUSE.toNanos())
        } catch (end: InterruptedException) {
            return false
        }
        return true
    }

    override fun close() {
        teller.shutdown()
        teller.awaitTermination(PATIENCE.toMillis(), TimeUnit.MILLISECONDS)
        listener?.interrupt()
        listener?.join(PATIENCE.toMillis())
    }

    private companion object {
        val PAUSE: Duration = Duration.ofSeconds(1)
        val PATIENCE: Duration = Duration.ofSeconds(2)
    }
}
