package rasterlab.grader.submission

import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.exercises.score.GradingVerdict
import rasterlab.exercises.score.ScorePoints
import rasterlab.grader.ClassOfStudents
import rasterlab.grader.Classroom
import rasterlab.grader.postgres.TestDatabases
import rasterlab.grader.storage.Database
import java.nio.file.Path
import java.time.Duration
import java.time.Instant
import java.time.InstantSource

/** Turns go round by student, and each round in the order of handing in. */
open class TurnsTest {
    @TempDir
    lateinit var folder: Path
    private lateinit var database: Database
    private lateinit var leases: Leases
    private lateinit var students: ClassOfStudents
    private var now = Instant.parse("2026-03-29T00:59:59Z")
    private val clock = InstantSource { now }
    private val names = mutableMapOf<String, String>()

    @BeforeEach
    fun open() {
        database = TestDatabases.open(folder)
        leases = Leases(database, Reports(database), clock, steady = clock)
        students = ClassOfStudents(database, clock)
    }

    @AfterEach
    fun close() = database.close()

    @Test
    @DisplayName("who hands in one waits for all five of another")
    fun oneOfEachComesBeforeTheSecondOfAny() {
        val (ada, bob, cyd) = listOf("Ada", "Bob", "Cyd").map(students::student)
        (1..5).forEach { names[students.handIn(ada)] = "Ada $it" }
        assertEquals("Ada 1", graded())
        names[students.handIn(bob)] = "Bob 1"
        names[students.handIn(bob)] = "Bob 2"
        assertEquals("Bob 1", graded())
        names[students.handIn(cyd)] = "Cyd 1"
        assertEquals(listOf("Cyd 1", "Ada 2", "Bob 2", "Ada 3", "Ada 4", "Ada 5"), List(6) { graded() })
    }

    @Test
    @DisplayName("who hands in again and again keeps the second one of another waiting without end")
    fun nobodyIsKeptWaitingByNewcomers() {
        val (ada, bob, cyd) = listOf("Ada", "Bob", "Cyd").map(students::student)
        listOf(ada, ada).forEachIndexed { i, it -> names[students.handIn(it)] = "Ada ${i + 1}" }
        val order = mutableListOf<String>()
        names[students.handIn(bob)] = "Bob"
        names[students.handIn(cyd)] = "Cyd"
        repeat(5) {
            order += graded()
            if (order.last() == "Bob") names[students.handIn(bob)] = "Bob"
            if (order.last() == "Cyd") names[students.handIn(cyd)] = "Cyd"
        }
        assertEquals(listOf("Ada 1", "Bob", "Cyd", "Ada 2", "Bob"), order)
    }

    @Test
    @DisplayName("who handed in often before anybody waited comes after all who hand in for the first time")
    fun earlierWorkIsNotHeldAgainstAnybody() {
        val (ada, bob, cyd, dan) = listOf("Ada", "Bob", "Cyd", "Dan").map(students::student)
        repeat(3) {
            names[students.handIn(ada)] = "Ada"
            graded()
        }
        listOf(bob to "Bob", ada to "Ada", cyd to "Cyd", dan to "Dan").forEach { (student, name) ->
            names[students.handIn(student)] = name
        }
        assertEquals(listOf("Bob", "Ada", "Cyd", "Dan"), List(4) { graded() })
    }

    @Test
    @DisplayName("one newcomer after the other overtakes who has waited for more than a minute")
    fun whoHasWaitedLongIsNotOvertaken() {
        val (ada, bob, cyd) = listOf("Ada", "Bob", "Cyd").map(students::student)
        names[students.handIn(ada)] = "Ada 1"
        names[students.handIn(bob)] = "Bob"
        assertEquals("Ada 1", graded())
        names[students.handIn(ada)] = "Ada 2"
        now += Duration.ofSeconds(61)
        names[students.handIn(cyd)] = "Cyd"
        assertEquals(listOf("Bob", "Ada 2", "Cyd"), List(3) { graded() })
    }

    @Test
    @DisplayName("the place in the queue is told as if the first to come were the first to be graded")
    fun thePlaceIsThatOfTheTurn() {
        val (ada, bob) = listOf("Ada", "Bob").map(students::student)
        val last = (1..3).map { students.handIn(ada) }.last()
        val bobs = students.handIn(bob)
        val submissions = Submissions(database)
        assertEquals(2 to 4, submissions.place(bobs).position to submissions.place(last).position)
    }

    @Test
    @DisplayName("who is the first to come after a pause is overtaken by the next, since they came before it too")
    fun theFirstAfterAPauseStaysTheFirst() {
        val (ada, bob) = listOf("Ada", "Bob").map(students::student)
        for (student in listOf(ada, ada, bob)) {
            names[students.handIn(student)] = student.name
            if (student == ada && names.size == 1) graded()
        }
        assertEquals(listOf("Ada", "Bob"), List(2) { graded() })
    }

    @Test
    @DisplayName("an hour in which nobody handed in counts as time for grading, or no wait is told")
    fun theWaitGoesByThePaceOfGrading() {
        val (ada, bob) = listOf("Ada", "Bob").map(students::student)
        val submissions = Submissions(database)
        val first = students.handIn(ada)
        assertEquals(null, submissions.place(first).waitSeconds)
        now += Duration.ofSeconds(4)
        names[first] = "Ada"
        graded()
        now += Duration.ofHours(1)
        listOf(ada, bob, ada).forEach { names[students.handIn(it)] = it.name }
        now += Duration.ofSeconds(4)
        graded()
        val last = submissions.place(students.handIn(bob))
        assertEquals(3 to 12, last.position to last.waitSeconds)
        assertEquals(null, submissions.place(first).waitSeconds)
    }

    private fun graded(): String {
        val lease = checkNotNull(leases.claimNext()) { "nothing waits" }
        leases.finish(lease, "r1", Classroom.report(GradingVerdict.OK, ScorePoints(6, 3, 1, 10)))
        return names.getValue(lease.submission.id)
    }
}
