package rasterlab.grader.regrade

import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.exercises.Grading
import rasterlab.exercises.score.GradingVerdict
import rasterlab.exercises.score.Report
import rasterlab.exercises.score.ScorePoints
import rasterlab.grader.ClassOfStudents
import rasterlab.grader.Classroom
import rasterlab.grader.course.Course
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Identity
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.postgres.TestDatabases
import rasterlab.grader.problem.Rejection
import rasterlab.grader.storage.Database
import rasterlab.grader.student.StudentRecords
import rasterlab.grader.submission.AttemptOutcome
import rasterlab.grader.submission.Attempts
import rasterlab.grader.submission.GradingQueue
import rasterlab.grader.submission.Leases
import rasterlab.grader.submission.Live
import rasterlab.grader.submission.Reports
import rasterlab.grader.submission.SteadyClock
import rasterlab.grader.submission.Submissions
import java.nio.file.Path
import java.time.Duration
import java.time.Instant
import java.time.InstantSource
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit.SECONDS

/** Submissions are graded again behind new work, once each, and count all together or not at all. */
@Tag("slow")
open class RegradesTest {
    @TempDir
    lateinit var folder: Path
    private lateinit var database: Database
    private lateinit var leases: Leases
    private lateinit var students: ClassOfStudents
    private var now = Instant.parse("2026-03-29T00:59:59Z")
    private val clock = InstantSource { now }
    private var given = 4
    private val calls = ConcurrentHashMap<String, Int>()

    @BeforeEach
    fun open() {
        reopen()
        students = ClassOfStudents(database, clock)
    }

    @AfterEach
    fun close() = database.close()

    private fun reopen() {
        database = TestDatabases.open(folder)
        leases = Leases(database, Reports(database), clock, steady = clock)
    }

    @Test
    @DisplayName("a new submission waits behind those that are graded again")
    fun newWorkComesFirst() {
        val ada = students.student("Ada")
        val earlier = List(3) { students.handIn(ada) }
        gradeAll()
        start(dry = true)
        assertEquals(earlier[0], grade())
        val fresh = students.handIn(students.student("Bob"))
        assertEquals(1, Submissions(database).place(fresh).position)
        assertEquals(null, leases.regrades.claimNext(), "something is graded again while a new one waits")
        assertEquals(listOf(fresh, earlier[1], earlier[2]), List(3) { grade() })
    }

    @Test
    @DisplayName("a dry run changes what counts, or accepting or undoing it does not")
    fun countsWhenItIsAcceptedAndUntilItIsUndone() {
        val (ada, bob) = listOf("Ada", "Bob").map { students.handIn(students.student(it)) }
        gradeAll()
        given = 6
        val begun = start(dry = true)
        assertEquals(RegradeState.GRADING to 2, begun.state to begun.total)
        assertThrows(Rejection.RegradeStands::class.java) { regrades().accept(begun.id, "i") }
        gradeAll()
        assertEquals(RegradeState.GRADED, regrades().find(begun.id).state)
        assertEquals(listOf(4, 4), points(ada, bob))
        assertThrows(Rejection.RegradeStands::class.java) { regrades().undo(begun.id, "i") }
        regrades().accept(begun.id, "i")
        assertEquals(listOf(6, 6), points(ada, bob))
        val changes = regrades().changes(regrades().find(begun.id))
        assertEquals(listOf(2, 2), changes.map { it.gain })
        assertEquals(listOf("open-case", "hidden-case"), changes[0].cases.map { it.name })
        assertEquals("wrong" to 2, changes[0].cases[0].before)
        assertEquals("ok" to 2, changes[0].cases[0].after)
        regrades().undo(begun.id, "i")
        assertEquals(listOf(4, 4), points(ada, bob))
        assertEquals(listOf("1 1", "2 0", "1 1", "2 0"), runs())
        val notes = listOf("regrade", "regrade-accept", "regrade-undo")
        assertEquals(notes, texts("SELECT action FROM audit WHERE action <> 'course' ORDER BY noted_at, action"))
    }

    @Test
    @DisplayName("a regrade that is not dry counts before all is graded, or never")
    fun countsAtOnceWhenTheLastIsGraded() {
        val (ada, bob) = listOf("Ada", "Bob").map { students.handIn(students.student(it)) }
        gradeAll()
        given = 5
        val begun = start(dry = false)
        grade()
        assertEquals(listOf(4, 4), points(ada, bob))
        grade()
        assertEquals(listOf(5, 5), points(ada, bob))
        assertEquals(RegradeState.ACCEPTED, regrades().find(begun.id).state)
    }

    @Test
    @DisplayName("a result of which one case is graded again counts as one of the later version of the exercise")
    fun oneCaseLeavesTheVersion() {
        val ada = students.handIn(students.student("Ada"))
        gradeAll()
        given = 6
        val case = Classroom.EXERCISE.cases().single()
        regrades().start(course(), Classroom.EXERCISE, RegradeChoice.SOME, listOf(ada), dry = false, "i", null, case)
        val lease = checkNotNull(leases.regrades.claimNext())
        leases.regrades.finish(lease, "r2", report())
        assertEquals(
            listOf("1 0 r1", "2 1 r1"),
            texts("SELECT run || ' ' || is_current || ' ' || revision FROM results"),
        )
    }

    @Test
    @DisplayName("undoing takes away the results of a later regrade")
    fun undoesTheLatestFirst() {
        val ada = students.handIn(students.student("Ada"))
        gradeAll()
        val (first, second) =
            listOf(5, 6).map { points ->
                given = points
                start(dry = false).also { gradeAll() }
            }
        assertThrows(Rejection.RegradeStands::class.java) { regrades().undo(first.id, "i") }
        assertEquals(listOf(6), points(ada))
        regrades().undo(second.id, "i")
        regrades().undo(first.id, "i")
        assertEquals(listOf(4), points(ada))
    }

    @Test
    @DisplayName("after the server was killed in the middle, something is graded twice, or not at all")
    fun goesOnAfterARestart() {
        val ids = List(5) { students.handIn(students.student("Student $it"), "class Dot$it {}") }
        gradeAll()
        given = 6
        val begun = start(dry = false)
        grade()
        checkNotNull(leases.regrades.claimNext()) { "nothing is graded as the server is killed" }
        database.close()
        reopen()
        val graded = CountDownLatch(4)
        val live = Live()
        val attempts = attempts(live) { source -> report().also { count(source, graded) } }
        GradingQueue(database, Submissions(database), leases, attempts, live, SteadyClock(clock), workers = 2).use {
            it.start()
            assertTrue(graded.await(120, SECONDS), "after 120 s ${graded.count} of 4 are not graded")
        }
        assertEquals(RegradeState.ACCEPTED, regrades().find(begun.id).state)
        assertEquals(List(5) { 6 }, points(*ids.toTypedArray()))
        assertEquals(List(5) { listOf("1 0", "2 1") }.flatten(), runs())
        assertEquals(setOf(1), calls.values.toSet())
    }

    @Test
    @DisplayName("a worker whose lease was given to another writes a result, or a discarded regrade does")
    fun writesOnlyUnderItsLease() {
        students.handIn(students.student("Ada"))
        gradeAll()
        val begun = start(dry = true)
        val late = checkNotNull(leases.regrades.claimNext())
        now += Leases.LENGTH + Duration.ofMillis(1)
        leases.releaseExpired()
        val other = checkNotNull(leases.regrades.claimNext())
        assertFalse(leases.regrades.finish(late, "r1", report()), "the late worker wrote a result")
        leases.regrades.renew(other)
        regrades().discard(begun.id, "i")
        assertFalse(leases.regrades.finish(other, "r1", report()), "a discarded regrade wrote a result")
        assertEquals(listOf("1 1"), runs())
        assertEquals(null, leases.regrades.claimNext())
    }

    @Test
    @DisplayName("a fault of ours takes the place of a result")
    fun keepsAResultWhereOursFails() {
        val ada = students.handIn(students.student("Ada"))
        gradeAll()
        val begun = start(dry = false)
        val attempts = attempts { Classroom.report(GradingVerdict.INTERNAL, ScorePoints(0, 0, 0, 10)) }
        val outcomes = List(Attempts.TRIES) { attempts.attemptNext().also { now += Leases.PAUSE } }
        assertEquals(AttemptOutcome.SETTLED, outcomes.last())
        val ended = regrades().find(begun.id)
        assertEquals(listOf(RegradeState.ACCEPTED, 1, 1), listOf(ended.state, ended.done, ended.failed))
        assertEquals(listOf(4), points(ada))
        assertEquals(null, regrades().changes(ended).single().after)
    }

    @Test
    @DisplayName("latest, best or some choose other submissions, or one that is being graded again is begun twice")
    fun choosesSubmissions() {
        val (ada, bob) = listOf("Ada", "Bob").map(students::student)
        val adas = listOf(3, 6, 5).map { handInFor(ada, it) }
        val bobs = listOf(2, 2).map { handInFor(bob, it) }
        assertEquals(listOf(adas[2], bobs[1]), chosen(RegradeChoice.LATEST))
        assertEquals(listOf(adas[1], bobs[0]), chosen(RegradeChoice.BEST))
        assertEquals(adas + bobs, chosen(RegradeChoice.ALL))
        assertEquals(listOf(adas[0], bobs[1]), chosen(RegradeChoice.SOME, bobs[1], adas[0]))
        assertThrows(Rejection.BadRegrade::class.java) { chosen(RegradeChoice.SOME, "nothing") }
        assertThrows(Rejection.BadRegrade::class.java) { chosen(RegradeChoice.SOME) }
        start(dry = true)
        assertThrows(Rejection.RegradeStands::class.java) { start(dry = true) }
    }

    @Test
    @DisplayName("a deleted student keeps a regrade from ending, or cannot be deleted")
    fun endsWithoutADeletedStudent() {
        val ada = students.student("Ada")
        students.handIn(ada)
        val bob = students.handIn(students.student("Bob"))
        gradeAll()
        given = 6
        val begun = start(dry = false)
        leases.regrades.claimNext()
        grade()
        StudentRecords(database, clock).delete(ada.id, "i")
        leases.releaseExpired()
        assertEquals(RegradeState.ACCEPTED, regrades().find(begun.id).state)
        assertEquals(listOf(6), points(bob))
    }

    private fun regrades() = Regrades(database, clock)

    private fun course(): Course = Courses(database, clock).all().single()

    private fun start(
        dry: Boolean,
        choice: RegradeChoice = RegradeChoice.ALL,
        some: List<String> = emptyList(),
    ): Regrade {
        now += Duration.ofSeconds(1)
        return regrades().start(course(), Classroom.EXERCISE, choice, some, dry, "i", key = null)
    }

    /** The submissions that a choice puts into the queue, which are taken out again. */
    private fun chosen(
        choice: RegradeChoice,
        vararg some: String,
    ): List<String> {
        val begun = start(dry = true, choice, some.toList())
        regrades().discard(begun.id, "i")
        return texts("SELECT submission_id FROM regrade_items WHERE regrade_id = '${begun.id}' ORDER BY position")
    }

    private fun handInFor(
        student: Identity.StudentIdentity,
        points: Int,
    ): String {
        given = points
        return students.handIn(student).also { gradeAll() }
    }

    private fun report(): Report {
        val verdict = if (given < 6) GradingVerdict.WRONG else GradingVerdict.OK
        return Classroom.report(verdict, ScorePoints(given, 0, 0, 10))
    }

    private fun count(
        source: String,
        graded: CountDownLatch,
    ) {
        calls.merge(source, 1, Int::plus)
        graded.countDown()
    }

    private fun attempts(
        live: Live = Live(),
        grade: (String) -> Report,
    ) = Attempts(
        database,
        leases,
        Exercises(listOf(Classroom.EXERCISE)),
        Grading { _, source, _, _ -> grade(source) },
        live,
    ) { false }

    private fun gradeAll() {
        repeat(9) { attempts { report() }.attemptNext() }
    }

    /** Grades what is next, and returns which submission that was. */
    private fun grade(): String {
        val fresh = leases.claimNext()
        val lease = checkNotNull(fresh ?: leases.regrades.claimNext()) { "nothing waits" }
        val keeper = if (fresh == null) leases.regrades else leases
        assertTrue(keeper.finish(lease, "r1", report()))
        return lease.submission.id
    }

    private fun points(vararg submissions: String) = submissions.map { Submissions(database).listed(it)?.points }

    private fun runs() =
        texts(
            """SELECT run || ' ' || is_current FROM results JOIN submissions s ON s.id = submission_id
               ORDER BY s.sequence, run""",
        )

    private fun texts(sql: String): List<String> =
        database.read { it.createQuery(sql).mapTo(String::class.java).list() }
}
