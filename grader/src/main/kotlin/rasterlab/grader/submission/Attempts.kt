package rasterlab.grader.submission

import org.slf4j.LoggerFactory
import rasterlab.exercises.Exercise
import rasterlab.exercises.Grading
import rasterlab.exercises.Grading.CaseSelection
import rasterlab.exercises.score.CaseReport
import rasterlab.exercises.score.Diagnostic
import rasterlab.exercises.score.GradingVerdict
import rasterlab.exercises.score.Message
import rasterlab.exercises.score.Report
import rasterlab.exercises.score.ScorePoints
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.isStorageFull
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicInteger
import java.util.function.Consumer

/** Whether the queue is done with a submission. */
enum class AttemptOutcome {
    SETTLED,
    TRY_AGAIN,
}

/**
 * Grades one submission at a time per thread, and sees that each gets one result.
 *
 * @param claimed told of each attempt as it begins
 * @param filesLeft whether there are files to grade with: an attempt without them would only use up a try
 * @param stopping whether the process ends, which may end a child before its time
 */
class Attempts(
    private val database: Database,
    private val leases: Leases,
    private val exercises: Exercises,
    private val grading: Grading,
    private val live: Live,
    private val claimed: (Submission) -> Unit = {},
    private val filesLeft: () -> Boolean = FreeFiles::areLeft,
    private val stopping: () -> Boolean,
) {
    private val log = LoggerFactory.getLogger(javaClass)
    private val held = ConcurrentHashMap<Lease, LeaseKeeper>()
    private val open = AtomicInteger()
    private val working = ConcurrentHashMap.newKeySet<Thread>()

    /** Whether something new is begun, or all that waits is left to others. */
    @Volatile
    var takes = true

    /** How many attempts there are now, those included that have yet to find something to do. */
    fun running(): Int = open.get()

    /**
     * Grades the submission whose turn it is, if one waits, and else a copy that staff run, or one that is to be graded again. A mistake of ours is tried again; the last
     * one stands as an `internal` result that a person has to look at.
     *
     * @throws InterruptedException when the server stops; the submission is back in the queue then
     */
    fun attemptNext(): AttemptOutcome {
        open.incrementAndGet()
        working += Thread.currentThread()
        try {
            return if (takes && filesLeft() && database.hasRoom()) takeNext() else AttemptOutcome.TRY_AGAIN
        } finally {
            working -= Thread.currentThread()
            open.decrementAndGet()
        }
    }

    /** Cuts off what is graded here, which is put back into the queue by that. */
    fun interrupt() = working.forEach(Thread::interrupt)

    private fun takeNext(): AttemptOutcome {
        leases.claimNext()?.let { lease ->
            claimed(lease.submission)
            return attempt(lease, leases) { live.judged(lease.submission.id, it) }
        }
        leases.trials.claimNext()?.let { lease ->
            return attempt(lease, leases.trials) { live.judged(lease.submission.id, it) }
        }
        leases.regrades.claimNext()?.let { return attempt(it, leases.regrades) {} }
        return measureNext()
    }

    private fun attempt(
        lease: Lease,
        keeper: LeaseKeeper,
        progress: Consumer<CaseReport>,
    ): AttemptOutcome {
        live.announce()
        held[lease] = keeper
        try {
            return settle(lease, keeper, progress)
        } catch (failure: Exception) {
            // That the database was away is no fault of the submission's, however often it happens.
            val counts = failure !is InterruptedException && !stopping() && !failure.isStorageFull()
            stored { keeper.giveUp(lease, counts) }
            throw failure
        } finally {
            held -= lease
            live.ended(lease.submission.id)
        }
    }

    /** Measures a speed again, if one is due. What else the same source is given now changes nothing. */
    private fun measureNext(): AttemptOutcome {
        val lease = leases.measurements.claimNext() ?: return AttemptOutcome.SETTLED
        held[lease] = leases
        try {
            val submission = lease.submission
            val exercise = exercises.at(submission.exercise, submission.revision)
            val report = exercise?.let { grade(it, submission) {} }
            val settled = stored { leases.measurements.finish(lease, report, counts = !stopping()) }
            if (settled) log.info("the speed of submission {} is measured", submission.id)
        } catch (failure: Exception) {
            leases.measurements.finish(lease, report = null, counts = failure !is InterruptedException && !stopping())
            throw failure
        } finally {
            held -= lease
            live.announce()
        }
        return AttemptOutcome.SETTLED
    }

    /** Keeps the leases of the attempts that run here. */
    fun renew() = held.forEach { (lease, keeper) -> keeper.renew(lease) }

    private fun settle(
        lease: Lease,
        keeper: LeaseKeeper,
        progress: Consumer<CaseReport>,
    ): AttemptOutcome {
        val submission = lease.submission
        val exercise = exercises.at(submission.exercise, submission.revision)
        val report =
            when {
                exercise == null -> {
                    ourFault(
                        Message.of("internal.exercise", submission.exercise),
                        of = 0,
                    )
                }

                submission.tries > TRIES -> {
                    ourFault(
                        Message.of("internal.tries", TRIES),
                        exercise.points().total(),
                    )
                }

                else -> {
                    grade(exercise, submission, progress)
                }
            }
        if (report.verdict() == GradingVerdict.INTERNAL && (submission.tries < TRIES || stopping())) {
            stored { keeper.giveUp(lease, counts = !stopping()) }
            return AttemptOutcome.TRY_AGAIN
        }
        val written = stored { keeper.finish(lease, exercise?.revision() ?: submission.revision, report) }
        if (written) {
            log.info("submission {} graded {} on try {}", submission.id, report.verdict().code(), submission.tries)
        } else {
            log.warn("submission {} was given to another worker; this result is dropped", submission.id)
        }
        return AttemptOutcome.SETTLED
    }

    /** Keeps at it while the disk is full or another process locks the database: a result is not lost by that. */
    private fun <T> stored(write: () -> T): T {
        var told = false
        while (true) {
            try {
                return write()
            } catch (failure: Exception) {
                if (stopping() || !failure.isStorageFull()) throw failure
                if (!told) log.warn("what came of an attempt waits for the database: {}", failure.toString())
                told = true
                TimeUnit.NANOSECONDS.sleep(Leases.PAUSE.toNanos())
            }
        }
    }

    // Anything that the grading throws is our fault, whatever its type: the student's faults are verdicts.
    private fun grade(
        exercise: Exercise,
        submission: Submission,
        progress: Consumer<CaseReport>,
    ): Report =
        try {
            grading.grade(
                exercise,
                submission.source,
                CaseSelection.all(submission.seed),
                progress,
            )
        } catch (stop: InterruptedException) {
            throw stop
        } catch (failure: Exception) {
            if (failure.isStorageFull()) throw failure
            log.error("grading submission {} failed on try {}", submission.id, submission.tries, failure)
            ourFault(Message.of("internal.grader"), exercise.points().total())
        }

    private fun ourFault(
        said: Message,
        of: Int,
    ) = Report(GradingVerdict.INTERNAL, ScorePoints(0, 0, 0, of), emptyList(), listOf(Diagnostic(0, 0, said)), "", 0.0)

    companion object {
        /** The number of tries: with 600 submissions and 200 random kills, three left a right one without its result. */
        const val TRIES = 6
    }
}
