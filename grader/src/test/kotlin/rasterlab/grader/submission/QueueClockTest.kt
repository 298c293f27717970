package rasterlab.grader.submission

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource
import rasterlab.exercises.Grading
import rasterlab.exercises.score.GradingVerdict
import rasterlab.exercises.score.ScorePoints
import rasterlab.grader.ClassOfStudents
import rasterlab.grader.Classroom
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.limits.IntakeLimits
import rasterlab.grader.postgres.TestDatabases
import rasterlab.grader.storage.Database
import java.nio.file.Path
import java.time.Duration
import java.time.Instant
import java.time.InstantSource
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit.SECONDS

/** The system's clock is set while submissions wait, are graded and are tried again. */
@Tag("slow")
class QueueClockTest {
    @TempDir
    lateinit var folder: Path

    @Volatile
    private var shift = Duration.ZERO
    private val clock = InstantSource { Instant.now() + shift }

    @ParameterizedTest(name = "a clock that is set by {0} h holds the queue up")
    @ValueSource(longs = [-1, 1, -24, 24, -24 * 400])
    fun gradesOn(hours: Long) {
        val graded = CountDownLatch(3)
        val rung = CountDownLatch(1)
        TestDatabases.open(folder).use { database ->
            var calls = 0
            val students = ClassOfStudents(database, clock)
            val ada = students.student("Ada")
            repeat(3) { students.handIn(ada) }
            queue(database) { _, _, _, _ ->
                rung.await()
                // In the first attempt, which is our fault, so that its turn comes again after a pause.
                shift = Duration.ofHours(hours)
                if (calls++ == 0) OURS else RIGHT.also { graded.countDown() }
            }.use { queue ->
                queue.start()
                queue.sweep()
                rung.countDown()
                assertTrue(graded.await(120, SECONDS), "after 120 s ${graded.count} of 3 are not graded")
            }
        }
    }

    @Test
    @DisplayName("a clock that is set back shuts out who handed in before")
    fun handingInIsNotTooFastForBeingInTheFuture() {
        TestDatabases.open(folder).use { database ->
            val students = ClassOfStudents(database, clock)
            val ada = students.student("Ada")
            val lease = Leases(database, Reports(database), clock, SteadyClock(clock))
            repeat(IntakeLimits().perMinute) {
                students.handIn(ada)
                lease.finish(checkNotNull(lease.claimNext()), "r1", RIGHT)
            }
            shift = Duration.ofDays(-1)
            assertEquals(1, Submissions(database).place(students.handIn(ada)).position)
        }
    }

    @Test
    @DisplayName("the steady clock follows the other when that one is set")
    fun theSteadyClockGoesByTimePassed() {
        var wall = Instant.parse("2026-10-25T00:59:59Z")
        var nanos = Long.MAX_VALUE - 10
        val steady = SteadyClock({ wall }) { nanos }
        wall -= Duration.ofHours(1)
        nanos += Duration.ofSeconds(3).toNanos()
        assertEquals(Instant.parse("2026-10-25T01:00:02Z"), steady.instant())
        assertEquals(Duration.ofSeconds(-3603), steady.wallAhead())
    }

    private fun queue(
        database: Database,
        grading: Grading,
    ): GradingQueue {
        val steady = SteadyClock(clock)
        val leases = Leases(database, Reports(database), clock, steady)
        val live = Live()
        val attempts = Attempts(database, leases, Exercises(listOf(Classroom.EXERCISE)), grading, live) { false }
        return GradingQueue(database, Submissions(database), leases, attempts, live, steady, workers = 1)
    }

    private companion object {
        val RIGHT = Classroom.report(GradingVerdict.OK, ScorePoints(6, 3, 1, 10))
        val OURS = Classroom.report(GradingVerdict.INTERNAL, ScorePoints(0, 0, 0, 10))
    }
}
