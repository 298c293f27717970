package rasterlab.grader.submission

import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.exercises.Grading
import rasterlab.exercises.score.GradingVerdict
import rasterlab.exercises.score.ScorePoints
import rasterlab.grader.Classroom
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Identity
import rasterlab.grader.course.Name
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.limits.IntakeLimits
import rasterlab.grader.postgres.TestDatabases
import rasterlab.grader.storage.Database
import java.nio.file.Path
import java.sql.SQLTransientConnectionException
import java.time.Duration
import java.time.Instant
import java.time.InstantSource
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit.SECONDS

open class AttemptsTest {
    @TempDir
    lateinit var folder: Path
    private lateinit var database: Database
    private lateinit var reports: Reports
    private lateinit var leases: Leases
    private lateinit var submissions: Submissions
    private var stopping = false
    private var now = Instant.parse("2026-03-29T00:59:59Z")
    private val clock = InstantSource { now }
    private val right = Classroom.report(GradingVerdict.OK, ScorePoints(6, 3, 1, 10))
    private val ours = Classroom.report(GradingVerdict.INTERNAL, ScorePoints(0, 0, 0, 10))

    @BeforeEach
    fun open() {
        database = TestDatabases.open(folder)
        reports = Reports(database)
        leases = Leases(database, reports, clock, steady = clock)
        submissions = Submissions(database)
    }

    @AfterEach
    fun close() = database.close()

    @Test
    fun gradesEachSubmissionOnce() {
        var calls = 0
        val attempts = attempts { _, _, _, _ -> right.also { calls++ } }
        val id = submission()
        repeat(3) { assertEquals(AttemptOutcome.SETTLED, attempts.attemptNext()) }
        assertEquals(1, calls)
        assertEquals(GradingVerdict.OK, reports.of(id)?.report?.verdict())
    }

    @Test
    fun gradesWithTheStoredSeed() {
        val seeds = mutableListOf<Grading.CaseSelection>()
        val attempts = attempts { _, _, cases, _ -> (if (seeds.size < 1) ours else right).also { seeds += cases } }
        val id = submission()
        attempts.attemptNext()
        now += Leases.PAUSE
        attempts.attemptNext()
        val seed = checkNotNull(submissions.find(id)).seed
        assertEquals(List(2) { Grading.CaseSelection.all(seed) }, seeds)
    }

    @Test
    @DisplayName("a process that starts takes the leases of others away, or waits for those that it had itself")
    fun releasesWhatItHeldItself() {
        val (one, other) = listOf("one", "one-more").map { Leases(database, reports, clock, clock, it) }
        val held = List(2) { submission() }
        val leases = listOf(checkNotNull(one.claimNext()), checkNotNull(other.claimNext()))
        one.releaseHeld()
        assertEquals(held[0], one.claimNext()?.submission?.id)
        assertEquals(listOf(false, true), leases.map { one.finish(it, "r1", right) })
    }

    @Test
    @DisplayName("a lease that the clock was set back behind lasts until the clock is there again")
    fun isNotHeldUpByAClockThatIsSetBack() {
        val id = submission()
        leases.claimNext()
        now -= Duration.ofHours(1)
        leases.releaseExpired()
        assertEquals(id, leases.claimNext()?.submission?.id)
        leases.releaseExpired()
        assertEquals(null, leases.claimNext())
    }

    @Test
    fun writesNothingOnceItsLeaseIsWithAnotherWorker() {
        val id = submission()
        val late = checkNotNull(leases.claimNext())
        now += Leases.LENGTH + Duration.ofMillis(1)
        leases.releaseExpired()
        val other = checkNotNull(leases.claimNext())
        assertFalse(leases.finish(late, "r1", ours), "the late worker wrote its result")
        assertEquals(null, reports.of(id))
        assertTrue(leases.finish(other, "r1", right))
        assertFalse(leases.finish(late, "r1", ours), "the late worker wrote a second result")
        assertEquals(GradingVerdict.OK, reports.of(id)?.report?.verdict())
    }

    @Test
    fun keepsALeaseThatIsRenewed() {
        submission()
        val lease = checkNotNull(leases.claimNext())
        now += Leases.LENGTH - Duration.ofMillis(1)
        leases.renew(lease)
        now += Duration.ofSeconds(2)
        leases.releaseExpired()
        assertTrue(leases.finish(lease, "r1", right), "the lease was taken away")
    }

    @Test
    fun triesOurFaultAgainThenKeepsItForAPerson() {
        var calls = 0
        val attempts =
            attempts { _, _, _, _ ->
                if (calls++ ==
                    0
                ) {
                    ours
                } else {
                    throw IllegalStateException("the box is broken")
                }
            }
        val id = submission()
        assertEquals(
            List(Attempts.TRIES - 1) { AttemptOutcome.TRY_AGAIN } + AttemptOutcome.SETTLED,
            List(Attempts.TRIES) { attempts.attemptNext().also { now += Leases.PAUSE } },
        )
        assertEquals(Attempts.TRIES, calls)
        assertEquals(GradingVerdict.INTERNAL, reports.of(id)?.report?.verdict())
        assertEquals(AttemptOutcome.SETTLED, attempts.attemptNext())
        assertEquals(Attempts.TRIES, calls, "tried again although a person has it")
    }

    @Test
    fun doesNotRunAgainWhatKilledTheServerAgainAndAgain() {
        val id = submission()
        repeat(Attempts.TRIES) {
            checkNotNull(leases.claimNext())
            leases.releaseAll()
        }
        var calls = 0
        assertEquals(AttemptOutcome.SETTLED, attempts { _, _, _, _ -> right.also { calls++ } }.attemptNext())
        assertEquals(0, calls)
        assertEquals(GradingVerdict.INTERNAL, reports.of(id)?.report?.verdict())
    }

    @Test
    @DisplayName("a submission is given up since the database was away while it was graded")
    fun countsNoTryOfWhichTheDatabaseWasTheEnd() {
        val id = submission()
        repeat(Attempts.TRIES + 1) {
            val away = IllegalStateException(SQLTransientConnectionException("the database is away"))
            assertThrows(IllegalStateException::class.java) { attempts { _, _, _, _ -> throw away }.attemptNext() }
        }
        val found = checkNotNull(submissions.find(id))
        assertEquals(State.QUEUED to 0, found.state to found.tries)
        assertEquals(null, reports.of(id))
    }

    @Test
    fun putsASubmissionBackWhenTheServerStops() {
        val id = submission()
        assertThrows(InterruptedException::class.java) {
            attempts {
                _,
                _,
                _,
                _,
                ->
                throw InterruptedException()
            }.attemptNext()
        }
        val found = checkNotNull(submissions.find(id))
        assertEquals(State.QUEUED to 0, found.state to found.tries)
    }

    @Test
    fun doesNotCountATryThatTheStopCutShort() {
        stopping = true
        val id = submission()
        repeat(Attempts.TRIES + 1) {
            assertEquals(AttemptOutcome.TRY_AGAIN, attempts { _, _, _, _ -> ours }.attemptNext())
            now += Leases.PAUSE
        }
        assertEquals(0, submissions.find(id)?.tries)
        assertEquals(null, reports.of(id))
    }

    @Test
    fun gradesAfterARestartWhatAnEarlierProcessLeft() {
        val left = submission()
        val waiting = submission()
        leases.claimNext()
        val graded = CountDownLatch(2)
        val live = Live()
        val attempts = attempts(live) { _, _, _, _ -> right.also { graded.countDown() } }
        GradingQueue(database, submissions, leases, attempts, live, SteadyClock(clock), workers = 1).use { queue ->
            queue.start()
            assertTrue(graded.await(120, SECONDS), "after 120 s ${graded.count} of 2 are not graded")
        }
        assertEquals(listOf(State.DONE, State.DONE), listOf(left, waiting).map { submissions.find(it)?.state })
    }

    @Test
    @DisplayName("without files to grade with, a submission uses up its tries")
    fun waitsForFiles() {
        var left = false
        val exercises = Exercises(listOf(Classroom.EXERCISE))
        val attempts =
            Attempts(database, leases, exercises, { _, _, _, _ -> right }, Live(), filesLeft = { left }) { false }
        val id = submission()
        repeat(Attempts.TRIES) { assertEquals(AttemptOutcome.TRY_AGAIN, attempts.attemptNext()) }
        assertEquals(0, submissions.find(id)?.tries)
        left = true
        assertEquals(AttemptOutcome.SETTLED, attempts.attemptNext())
        assertEquals(1, submissions.find(id)?.tries)
    }

    private fun attempts(
        live: Live = Live(),
        grading: Grading,
    ) = Attempts(database, leases, Exercises(listOf(Classroom.EXERCISE)), grading, live) { stopping }

    private fun submission(): String {
        val courses = Courses(database, clock)
        val course = courses.create(by = "i", Name.of("Graphics"), key = null)
        val token = courses.join(course.code, Name.of("Ada"), key = null).token
        val student = Accounts(database, clock).holder(token) as Identity.StudentIdentity
        return Intake(
            database,
            IntakeLimits(),
            clock,
        ).accept(student, Classroom.EXERCISE, "class Dot {}", key = null).id
    }
}
