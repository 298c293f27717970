package rasterlab.grader.storage

import org.flywaydb.core.Flyway
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.Classroom
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.exercise.KeptExercises
import rasterlab.grader.submission.Attempts
import rasterlab.grader.submission.Leases
import rasterlab.grader.submission.Live
import rasterlab.grader.submission.Reports
import java.nio.file.Path
import java.sql.DriverManager
import java.time.InstantSource

/** A database of an earlier version is opened by this one. */
class MigrationTest {
    @TempDir
    lateinit var folder: Path
    private val file get() = folder.resolve("course.db")

    @Test
    @DisplayName("what waited before turns went round by student is graded student after student, or not at all")
    fun whatWaitsTakesTurnsToo() {
        of("3")
        for ((number, student) in "aaabab".withIndex()) {
            val state = if (number == 0) "done" else "queued"
            execute(
                """INSERT INTO submissions (id, student_id, exercise, revision, attempt, source, seed, received_at, state)
                   VALUES ('$number', '$student', 'draw-dot', 'r1', $number + 1, 'class Dot {}', 1,
                       '2026-03-29T00:59:59.000Z', '$state')""",
            )
        }
        Database.open(file).use { database ->
            val clock = InstantSource.system()
            val leases = Leases(database, Reports(database), clock, clock)
            val order = generateSequence { leases.claimNext()?.submission?.id }.toList()
            assertEquals(listOf("1", "3", "2", "5", "4"), order)
        }
    }

    @Test
    @DisplayName("what was handed in before exercises were kept cannot be read, or not graded")
    fun whatWasHandedInBeforeExercisesWereKept() {
        of("4")
        execute(
            """INSERT INTO submissions (id, student_id, exercise, revision, attempt, source, seed, received_at, state)
               VALUES ('s', 'a', 'draw-dot', 'r0', 1, 'class Dot {}', 1, '2026-03-29T00:59:59.000Z', 'queued')""",
        )
        Database.open(file).use { database ->
            val clock = InstantSource.system()
            val kept = KeptExercises(database)
            val reports = Reports(database)
            val leases = Leases(database, reports, clock, clock)
            val exercises = Exercises(listOf(Classroom.EXERCISE), kept::find)
            Attempts(
                database,
                leases,
                exercises,
                { _, _, _, _ -> Classroom.wrongReport() },
                Live(),
            ) { false }.attemptNext()
            assertEquals("r1", reports.of("s")?.revision)
        }
    }

    @Test
    @DisplayName("what was graded before speeds were measured again is measured, or cannot be read")
    fun whatWasGradedBeforeSpeedsWereMeasuredAgain() {
        of("5")
        execute(
            """INSERT INTO submissions (id, student_id, exercise, revision, attempt, source, seed, received_at, state)
               VALUES ('s', 'a', 'draw-dot', 'r1', 1, 'class Dot {}', 1, '2026-03-29T00:59:59.000Z', 'done')""",
        )
        execute(
            """INSERT INTO results (submission_id, revision, verdict, accuracy, stability, speed, points_of, isolation,
                   nanos_per_item, graded_at)
               VALUES ('s', 'r1', 'ok', 6, 3, 1, 10, 'bubblewrap', 0, '2026-03-29T00:59:59.000Z')""",
        )
        Database.open(file).use { database ->
            val clock = InstantSource.system()
            val reports = Reports(database)
            assertEquals(null, Leases(database, reports, clock, clock).measurements.claimNext())
            assertEquals(
                10,
                reports
                    .of("s")
                    ?.report
                    ?.points()
                    ?.total(),
            )
        }
    }

    /** Makes the database as the server of that version left it, with the students a and b. */
    private fun of(version: String) {
        Flyway
            .configure()
            .dataSource("jdbc:sqlite:$file", null, null)
            .locations("classpath:rasterlab/grader/storage")
            .target(version)
            .load()
            .migrate()
        execute("INSERT INTO courses (id, name, code, created_at) VALUES ('c', 'Graphics', 'CODE', '')")
        for (student in listOf("a", "b")) {
            execute(
                """INSERT INTO students (id, course_id, name, token_hash, joined_at)
                   VALUES ('$student', 'c', 'Ada', 'hash of $student', '')""",
            )
        }
    }

    private fun execute(sql: String) =
        DriverManager.getConnection("jdbc:sqlite:$file").use { it.createStatement().use { one -> one.execute(sql) } }
}
