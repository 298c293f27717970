package rasterlab.grader.submission

import com.github.kagkarlsson.scheduler.Scheduler
import com.github.kagkarlsson.scheduler.SchedulerName
import com.github.kagkarlsson.scheduler.logging.LogLevel
import com.github.kagkarlsson.scheduler.serializer.Serializer
import com.github.kagkarlsson.scheduler.task.CompletionHandler
import com.github.kagkarlsson.scheduler.task.FailureHandler
import com.github.kagkarlsson.scheduler.task.helper.Tasks
import com.github.kagkarlsson.shaded.jdbc.SQLRuntimeException
import org.slf4j.LoggerFactory
import rasterlab.grader.storage.Database
import java.time.Duration
import java.time.InstantSource
import java.util.concurrent.Executors
import java.util.concurrent.TimeUnit

/**
 * Calls the worker for each waiting submission. The scheduler's table is only the doorbell: the
 * submission's row says whether there is anything to do, and the sweep rings again for every row
 * whose ring was lost.
 *
 * @param workers how many submissions are graded at the same time
 */
class GradingQueue(
    private val database: Database,
    private val submissions: Submissions,
    private val leases: Leases,
    private val attempts: Attempts,
    private val live: Live,
    private val clock: InstantSource,
    workers: Int,
) : AutoCloseable {
    private val log = LoggerFactory.getLogger(javaClass)
    private val sweeper = Executors.newSingleThreadScheduledExecutor { Thread(it, "sweep").apply { isDaemon = true } }

    private val task =
        Tasks
            .custom("grade", Void::class.java)
            .onFailure(FailureHandler.maxRetries<Void>(FAILURES).withBackoff(PAUSE, 2.0).thenRemove())
            .onDeadExecutionRevive()
            .execute { instance, _ -> completion(attempts.attempt(instance.id)) }

    private val scheduler: Scheduler =
        Scheduler
            .create(database.scheduling, task)
            .schedulerName(SchedulerName.Fixed("grader"))
            .threads(workers)
            .clock { clock.instant() }
            .pollUsingFetch(0.5, 1.0)
            .pollingInterval(Duration.ofMillis(500))
            .enableImmediateExecution()
            .heartbeatInterval(Duration.ofSeconds(5))
            .missedHeartbeatsLimit(4)
            .shutdownMaxWait(STOP_WAIT)
            .alwaysPersistTimestampInUTC()
            .serializer(NothingToSerialize)
            .failureLogging(LogLevel.WARN, true)
            .build()

    /** Takes up what an earlier process left, and goes on from there. This process is alone on the database. */
    fun start() {
        leases.releaseAll()
        database.write { it.execute("DELETE FROM scheduled_tasks") }
        scheduler.start()
        sweeper.scheduleWithFixedDelay(::keepAndSweep, 0, SWEEP.toMillis(), TimeUnit.MILLISECONDS)
    }

    /** There is something to grade, and it is stored already: a ring that fails is made up for by the sweep. */
    fun ring(submission: String) {
        try {
            scheduler.scheduleIfNotExists(task.instance(submission), clock.instant())
        } catch (failure: SQLRuntimeException) {
            log.warn("submission {} waits for the sweep", submission, failure)
        }
        live.announce()
    }

    /** Rings for every waiting submission, and for those whose worker is gone. */
    fun sweep() {
        leases.releaseExpired()
        submissions.waiting().forEach { scheduler.scheduleIfNotExists(task.instance(it), clock.instant()) }
    }

    /** Lets running attempts finish for a while, then interrupts them, which puts them back. */
    override fun close() {
        sweeper.shutdown()
        scheduler.stop()
    }

    // The scheduled executor would never call again after an exception.
    private fun keepAndSweep() {
        try {
            attempts.renew()
            sweep()
        } catch (failure: Exception) {
            log.error("the sweep failed and is made again in {}", SWEEP, failure)
        }
    }

    private fun completion(outcome: Outcome): CompletionHandler<Void> =
        when (outcome) {
            Outcome.SETTLED -> {
                CompletionHandler { _, operations -> operations.remove() }
            }

            Outcome.TRY_AGAIN -> {
                CompletionHandler { done, operations ->
                    operations.reschedule(
                        done,
                        clock.instant() + PAUSE,
                    )
                }
            }
        }

    /** A task carries nothing but its id, so nothing is ever made from stored bytes. */
    private object NothingToSerialize : Serializer {
        override fun serialize(data: Any?): ByteArray? = null

        override fun <T> deserialize(
            type: Class<T>,
            bytes: ByteArray?,
        ): T? = null
    }

    private companion object {
        const val FAILURES = 5
        val PAUSE: Duration = Duration.ofSeconds(1)
        val SWEEP: Duration = Duration.ofSeconds(10)

        /** The scheduler waits this long twice: for the attempts to end, then for them to notice the interrupt. */
        val STOP_WAIT: Duration = Duration.ofSeconds(7)
    }
}
