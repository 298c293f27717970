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
import rasterlab.grader.storage.Secrets
import rasterlab.grader.worker.Presence
import java.time.Duration
import java.util.concurrent.Executors
import java.util.concurrent.TimeUnit

/**
 * Calls a worker as often as submissions wait; whose turn it is then, [Leases] says. The scheduler's table is
 * only the doorbell: the submissions' rows say whether there is anything to do, and the sweep makes up for
 * rings that were lost. Where several processes share the table, each takes rings in one statement that passes over
 * those which another is taking. All of its times are of the steady clock, so that none is far off when the other is
 * set.
 *
 * @param workers how many submissions are graded at the same time
 * @param presence tells others that this process is here
 */
class GradingQueue(
    private val database: Database,
    private val submissions: Submissions,
    private val leases: Leases,
    private val attempts: Attempts,
    private val live: Live,
    private val clock: SteadyClock,
    workers: Int,
    private val name: String = Leases.ONE_SERVER,
    private val presence: Presence? = null,
) : AutoCloseable {
    private val log = LoggerFactory.getLogger(javaClass)
    private var wallAhead = Duration.ZERO
    private var failing = false
    private var named = true

    @Volatile
    private var ends = false
    private var counts = emptyList<String>()
    private val sweeper = Executors.newSingleThreadScheduledExecutor { Thread(it, "sweep").apply { isDaemon = true } }

    private val task =
        Tasks
            .custom("grade", Void::class.java)
            .onFailure(FailureHandler.OnFailureRetryLater(Leases.PAUSE))
            .onDeadExecution { _, operations -> operations.remove() }
            .execute { _, _ -> completion(attempts.attemptNext()) }

    private val scheduler: Scheduler =
        Scheduler
            .create(database.scheduling, task)
            .schedulerName(SchedulerName.Fixed(name))
            .threads(workers)
            .clock { clock.instant() }
            .apply { if (database.isShared) pollUsingLockAndFetch(LEAST, MOST) else pollUsingFetch(LEAST, MOST) }
            .pollingInterval(Duration.ofMillis(500))
            .enableImmediateExecution()
            .heartbeatInterval(Duration.ofSeconds(5))
            .missedHeartbeatsLimit(4)
            .shutdownMaxWait(STOP_WAIT)
            .alwaysPersistTimestampInUTC()
            .serializer(NothingToSerialize)
            .failureLogging(LogLevel.WARN, true)
            .build()

    /**
     * Takes up what an earlier process left, and goes on from there: everything where no other can use the database,
     * and else what one of this name had.
     *
     * @param due done before each sweep, as it may hand something in
     */
    fun start(due: () -> Unit = {}) {
        database.now()?.let(clock::follow)
        if (database.isShared) leases.releaseHeld() else leases.releaseAll()
        database.write {
            if (database.isShared) {
                it.execute("DELETE FROM scheduled_tasks WHERE picked_by = ?", name)
            } else {
                it.execute("DELETE FROM scheduled_tasks")
            }
        }
        presence?.begin()
        scheduler.start()
        sweeper.scheduleWithFixedDelay({ keepAndSweep(due) }, 0, SWEEP.toMillis(), TimeUnit.MILLISECONDS)
    }

    /**
     * There is something to grade, and it is stored already: a ring that fails is made up for by the sweep.
     *
     * @param id of the submission, the copy, or the regrade that begins
     */
    fun ring(id: String) {
        try {
            scheduler.scheduleIfNotExists(task.instance(id), clock.instant())
        } catch (failure: SQLRuntimeException) {
            log.warn("{} waits for the sweep", id, failure)
        }
        live.announce()
    }

    /**
     * Puts back what nobody grades any more, and rings as often as rings are missing for what waits: for all
     * submissions and some of those that are graded again, or else for one speed that is to be measured again.
     */
    fun sweep() {
        leases.releaseExpired()
        val again = minOf(leases.regrades.waiting() + leases.trials.waiting(), AGAIN)
        val wanted = if (leases.measurements.isDue()) 1 else submissions.waiting() + again
        repeat(wanted - rings()) {
            scheduler.scheduleIfNotExists(task.instance(Secrets.newId()), clock.instant())
        }
    }

    /**
     * The number of rings that are not answered yet. One whose answering was cut short by a locked database
     * looks answered for a while.
     */
    private fun rings(): Int =
        database.read {
            it
                .createQuery("SELECT count(*) FROM scheduled_tasks WHERE NOT picked")
                .mapTo(Int::class.javaObjectType)
                .one()
        }

    /** Whether it was asked to take nothing more, and grades nothing now. */
    fun isDrained(): Boolean = !attempts.takes && attempts.running() == 0

    private fun take(more: Boolean) {
        if (attempts.takes == more) return
        attempts.takes = more
        if (more) scheduler.resume() else scheduler.pause()
        log.info(if (more) "takes work" else "takes no more work")
    }

    /** Takes nothing more, and puts what is graded here back for others, who take it up at once. */
    fun putBack() {
        ends = true
        take(false)
        val end = System.nanoTime() + STOP_WAIT.toNanos()
        while (attempts.running() > 0 && System.nanoTime() < end) {
            attempts.interrupt()
            TimeUnit.NANOSECONDS.sleep(GLANCE.toNanos())
        }
        sweep()
    }

    /**
     * Lets the sweep that is made end, which needs the database, and running attempts finish for a while; then
     * interrupts these, which puts them back.
     */
    override fun close() {
        sweeper.shutdown()
        sweeper.awaitTermination(STOP_WAIT.toMillis(), TimeUnit.MILLISECONDS)
        scheduler.stop()
        leave()
    }

    /** A database that is away keeps no process from ending; others see by its silence that it has. */
    private fun leave() {
        try {
            presence?.end()
        } catch (failure: Exception) {
            log.warn("{} stays on the list of those who grade: {}", name, failure.toString())
        }
    }

    // The scheduled executor would never call again after an exception.
    private fun keepAndSweep(due: () -> Unit) {
        tellSteps()
        try {
            followDatabase()
            attempts.renew()
            take(!ends && hasItsName() && presence?.seen() != true)
            due()
            sweep()
            lookForMoves()
            if (failing) log.info("the sweep goes on")
            failing = false
        } catch (failure: Exception) {
            // Work that the last sweep could not do is left to the server's next start.
            if (sweeper.isShutdown) return
            if (!failing) log.error("the sweep failed and is made again each {}", SWEEP, failure)
            failing = true
        }
    }

    /**
     * Two of one name would take each other's leases: the later one takes nothing. A name is lost only with the connection
     * to the database, and taken again when that is back.
     */
    private fun hasItsName(): Boolean {
        val has = database.keepsName()
        if (has != named) log.warn(if (has) "has its name {} again" else "another process has its name {}", name)
        named = has
        return has
    }

    /** Rings that were to be answered by a clock that was set back since are made anew by the sweep. */
    private fun followDatabase() {
        val step = database.now()?.let(clock::follow) ?: return
        if (step > STEP.negated()) return
        log.warn("the database's clock was set by {}; what was due by it is due now", step)
        database.write { it.execute("DELETE FROM scheduled_tasks WHERE NOT picked") }
    }

    /** Tells those who watch here what other processes do, too. */
    private fun lookForMoves() {
        if (!database.isShared) return
        val now = submissions.counts()
        if (now != counts) live.announce()
        counts = now
    }

    private fun tellSteps() {
        val ahead = clock.wallAhead()
        val step = ahead - wallAhead
        if (step.abs() < STEP) return
        wallAhead = ahead
        log.warn("the system's clock was set by {}; nothing in the queue is moved by that", step)
    }

    private fun completion(outcome: AttemptOutcome): CompletionHandler<Void> =
        when (outcome) {
            AttemptOutcome.SETTLED -> {
                CompletionHandler { _, operations -> operations.remove() }
            }

            AttemptOutcome.TRY_AGAIN -> {
                CompletionHandler { done, operations ->
                    operations.reschedule(
                        done,
                        clock.instant() + Leases.PAUSE,
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
        /** Limits of the rings in work, as shares of the workers: below the one more are taken up, to the other at most. */
        const val LEAST = 0.5
        const val MOST = 1.0

        val GLANCE: Duration = Duration.ofMillis(50)
        val SWEEP: Duration = Duration.ofSeconds(2)

        /** The rings for what is graded again, by sweep: fewer are written than a whole course has submissions. */
        const val AGAIN = 100

        /** The smallest jump of the clock that counts, above what it is moved when kept right by and by. */
        val STEP: Duration = Duration.ofSeconds(2)

        /** The scheduler waits this long twice: for the attempts to end, then for them to notice the interrupt. */
        val STOP_WAIT: Duration = Duration.ofSeconds(7)
    }
}
