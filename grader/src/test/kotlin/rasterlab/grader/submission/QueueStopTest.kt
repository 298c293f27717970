package rasterlab.grader.submission

import ch.qos.logback.classic.Logger
import ch.qos.logback.classic.spi.ILoggingEvent
import ch.qos.logback.core.read.ListAppender
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.io.TempDir
import org.slf4j.LoggerFactory
import rasterlab.exercises.Grading
import rasterlab.grader.Classroom
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.postgres.TestDatabases
import rasterlab.grader.storage.Database
import java.nio.file.Path
import java.time.Instant
import java.time.InstantSource
import java.util.concurrent.CompletableFuture
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit.MILLISECONDS
import java.util.concurrent.TimeUnit.SECONDS
import kotlin.concurrent.thread

/** The server is stopped in the middle of a sweep. */
class QueueStopTest {
    @TempDir
    lateinit var folder: Path
    private val logged = ListAppender<ILoggingEvent>().apply { start() }
    private val log = LoggerFactory.getLogger(GradingQueue::class.java) as Logger
    private val held = CompletableFuture<Thread>()
    private val closed = CountDownLatch(1)

    /** Holds the first sweep, which looks at it first, until the queue is closed or waits for the sweep. */
    private val clock =
        InstantSource {
            val now = Instant.now()
            val thread = Thread.currentThread()
            if (thread.name == "sweep" && !held.isDone) {
                held.complete(thread)
                closed.await(PATIENCE_MILLIS, MILLISECONDS)
            }
            now
        }

    @Test
    @Timeout(120)
    @DisplayName("a sweep that is on its way is told as failed when the server is stopped")
    fun stopsWithoutAnError() {
        log.addAppender(logged)
        try {
            stopInTheSweep()
        } finally {
            log.detachAppender(logged)
        }
        assertEquals(emptyList<String>(), logged.list.map { it.formattedMessage })
    }

    private fun stopInTheSweep() {
        val database = TestDatabases.open(folder)
        val queue = queue(database)
        queue.start()
        val sweep = held.get(60, SECONDS)
        val stopping =
            thread {
                queue.close()
                database.close()
                closed.countDown()
            }
        stopping.join()
        sweep.join()
    }

    private fun queue(database: Database): GradingQueue {
        val steady = SteadyClock(clock)
        val leases = Leases(database, Reports(database), clock, steady)
        val live = Live()
        val grading = Grading { _, _, _, _ -> throw AssertionError("nothing is handed in") }
        val attempts = Attempts(database, leases, Exercises(listOf(Classroom.EXERCISE)), grading, live) { true }
        return GradingQueue(database, Submissions(database), leases, attempts, live, steady, workers = 1)
    }

    private companion object {
        /** A queue that does not wait for the sweep is closed sooner. */
        const val PATIENCE_MILLIS = 2_000L
    }
}
