package rasterlab.grader.submission

import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.exercises.score.CaseReport
import rasterlab.exercises.score.Disclosure
import rasterlab.exercises.score.GradingVerdict
import rasterlab.exercises.score.Report
import rasterlab.exercises.score.ScorePoints
import rasterlab.exercises.score.SpeedFigures
import rasterlab.exercises.score.SpeedPoints
import rasterlab.grader.ClassOfStudents
import rasterlab.grader.Classroom
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.postgres.TestDatabases
import rasterlab.grader.storage.Database
import java.nio.file.Path
import java.time.Instant
import java.time.InstantSource
import java.util.Optional
import java.util.OptionalInt
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit.SECONDS

/** A speed that a busy machine did not let be measured is measured again when the queue is empty. */
open class MeasurementsTest {
    @TempDir
    lateinit var folder: Path
    private lateinit var database: Database
    private lateinit var reports: Reports
    private lateinit var leases: Leases
    private lateinit var students: ClassOfStudents
    private var now = Instant.parse("2026-03-29T00:59:59Z")
    private val clock = InstantSource { now }
    private val given = mutableListOf<Report>()
    private val graded = mutableListOf<String>()
    private var stopping = false
    private val unsettled = report(GradingVerdict.OK, accuracy = 6, nanos = 0.0, SpeedPoints.unsettled(1, 0))
    private val figures = Optional.of(SpeedFigures(90.0, 9.0, 0.0, listOf(SpeedFigures.MethodSpeed("dda", 2.0, 0.0))))
    private val slow =
        report(GradingVerdict.WRONG, accuracy = 2, nanos = 90.0, tenTimesSlower())
            .with(figures)

    private fun tenTimesSlower(): CaseReport {
        val band = SpeedPoints.band(10.0, OptionalInt.empty())
        return SpeedPoints.measured({ it }, 90.0, 9.0, false, 1, band)
    }

    @BeforeEach
    fun open() {
        database = TestDatabases.open(folder)
        reports = Reports(database)
        leases = Leases(database, reports, clock, steady = clock)
        students = ClassOfStudents(database, clock)
    }

    @AfterEach
    fun close() = database.close()

    @Test
    @DisplayName("an unsettled speed stays so, or is measured before somebody who waits, or changes other points")
    fun isMeasuredOnceNobodyWaits() {
        val ada = students.student("Ada")
        val unmeasured = students.handIn(ada, "ada")
        grades(unsettled)
        assertEquals(listOf(6, 3, 1), points(unmeasured))
        attempts().attemptNext()
        now += Measurements.PAUSE
        val waiting = students.handIn(students.student("Bob"), "bob")
        grades(unsettled)
        grades(slow)
        assertEquals(listOf("ada", "bob", "ada"), graded)
        assertEquals(listOf(6, 3, 0), points(unmeasured))
        assertEquals(listOf(6, 3, 1), points(waiting))
        val now = checkNotNull(reports.of(unmeasured)).report
        assertEquals(GradingVerdict.OK to 90.0, now.verdict() to now.nanosPerItem())
        assertEquals(figures, now.figures())
        val cases = now.cases().associate { it.name() to it.verdict() }
        assertEquals(
            mapOf("open-case" to GradingVerdict.OK, "speed" to GradingVerdict.TOO_SLOW),
            cases,
        )
        assertTrue("90.00 ns per pixel" in now.speed().orElseThrow().message("en"))
    }

    @Test
    @DisplayName("a machine that is always busy measures one speed without end")
    fun isTriedAFewTimesOnly() {
        val id = students.handIn(students.student("Ada"), "ada")
        grades(unsettled)
        repeat(Measurements.TRIES) {
            now += Measurements.PAUSE
            grades(unsettled)
        }
        now += Measurements.PAUSE
        assertEquals(null, leases.measurements.claimNext())
        assertEquals(listOf(6, 3, 1), points(id))
    }

    @Test
    @DisplayName("a stop of the server uses a try up")
    fun aStopCountsAsNoTry() {
        students.handIn(students.student("Ada"), "ada")
        grades(unsettled)
        repeat(Measurements.TRIES) {
            now += Measurements.PAUSE
            val stopped =
                Attempts(database, leases, exercises(), { _, _, _, _ -> throw InterruptedException() }, Live()) { true }
            assertThrows(InterruptedException::class.java) { stopped.attemptNext() }
        }
        now += Measurements.PAUSE
        grades(slow)
        assertEquals(listOf("ada", "ada"), graded)
    }

    @Test
    @DisplayName("a worker that lost its lease writes the speed, or the speed is lost with it")
    fun aLostLeaseWritesNothing() {
        val id = students.handIn(students.student("Ada"), "ada")
        grades(unsettled)
        now += Measurements.PAUSE
        val late = checkNotNull(leases.measurements.claimNext())
        now += Leases.LENGTH.plusMillis(1)
        leases.releaseExpired()
        assertTrue(!leases.measurements.finish(late, slow), "the late worker wrote")
        assertEquals(listOf(6, 3, 1), points(id))
        grades(slow)
        assertEquals(listOf(6, 3, 0), points(id))
    }

    @Test
    @DisplayName("no bell rings for a speed after the server was started anew")
    fun isMeasuredByAServerStartedAnew() {
        students.handIn(students.student("Ada"), "ada")
        grades(unsettled)
        val measured = CountDownLatch(1)
        val live = Live()
        val attempts =
            Attempts(
                database,
                leases,
                exercises(),
                { _, _, _, _ -> slow.also { measured.countDown() } },
                live,
            ) { false }
        GradingQueue(database, Submissions(database), leases, attempts, live, SteadyClock(clock), workers = 1).use {
            it.start()
            assertTrue(measured.await(120, SECONDS), "not measured after 120 s")
        }
    }

    private fun grades(report: Report) {
        given += report
        attempts().attemptNext()
        assertEquals(0, given.size, "nothing was graded")
    }

    private fun attempts() =
        Attempts(database, leases, exercises(), { _, source, _, _ ->
            graded += source
            given.removeFirst()
        }, Live()) { stopping }

    private fun exercises() = Exercises(listOf(Classroom.EXERCISE))

    private fun points(id: String) =
        checkNotNull(reports.of(id)).report.points().let { listOf(it.accuracy(), it.stability(), it.speed()) }

    private fun report(
        verdict: GradingVerdict,
        accuracy: Int,
        nanos: Double,
        speed: rasterlab.exercises.score.CaseReport,
    ) = Report(
        verdict,
        ScorePoints(accuracy, 3, speed.points(), 10),
        listOf(Classroom.case("open-case", Disclosure.OPEN, verdict), speed),
        emptyList(),
        Report.PROCESS_LIMITS,
        nanos,
    )
}
