package rasterlab.grader.storage

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.sqlite.SQLiteDataSource
import rasterlab.exercises.score.PicturePart
import rasterlab.grader.Classroom
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.exercise.KeptExercises
import rasterlab.grader.submission.Attempts
import rasterlab.grader.submission.Leases
import rasterlab.grader.submission.Live
import rasterlab.grader.submission.Reports
import rasterlab.grader.submission.Submissions
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

    @Test
    @DisplayName("what was handed in before there were hints is charged for them")
    fun whatWasHandedInBeforeHintsKeepsItsPoints() {
        of("7")
        execute(
            """INSERT INTO submissions (id, student_id, exercise, revision, attempt, source, seed, received_at, state)
               VALUES ('s', 'a', 'draw-dot', 'r1', 1, 'class Dot {}', 1, '2026-03-29T00:59:59.000Z', 'done')""",
        )
        execute(
            """INSERT INTO results (submission_id, revision, verdict, accuracy, stability, speed, points_of, isolation,
                   nanos_per_item, graded_at)
               VALUES ('s', 'r1', 'ok', 6, 2, 1, 10, 'bubblewrap', 0, '2026-03-29T00:59:59.000Z')""",
        )
        Database.open(file).use { database ->
            assertEquals(mapOf("draw-dot" to 9), Submissions(database).bests("a"))
            assertEquals(0, Submissions(database).find("s")?.hintCost)
        }
    }

    @Test
    @DisplayName("what was late before deadlines were kept with it is in time, or the other way round")
    fun whatWasLateBeforeStaysLate() {
        of("11")
        execute(
            "INSERT INTO deadlines (course_id, exercise, due_at) VALUES ('c', 'draw-dot', '2026-03-29T01:00:00.000Z')",
        )
        for ((attempt, received) in listOf("2026-03-29T01:00:00.000Z", "2026-03-29T01:00:00.001Z").withIndex()) {
            execute(
                """INSERT INTO submissions (id, student_id, exercise, revision, attempt, source, seed, received_at, state)
                   VALUES ('s$attempt', 'a', 'draw-dot', 'r1', $attempt + 1, 'class Dot {}', 1, '$received', 'done')""",
            )
        }
        Database.open(file).use { database ->
            val listed = Submissions(database).ofStudent("a", "draw-dot")
            assertEquals(listOf("s1" to true, "s0" to false), listed.map { it.submission.id to it.late })
        }
    }

    @Test
    @DisplayName("what was graded before speeds had figures cannot be read, or has some")
    fun whatWasGradedBeforeSpeedsHadFiguresHasNone() {
        of("9")
        graded()
        Database.open(file).use { database ->
            val report = checkNotNull(Reports(database).of("s")).report
            assertEquals(10, report.points().total())
            assertTrue(report.figures().isEmpty)
        }
    }

    @Test
    @DisplayName("pictures of before are lost, or the texts of the three are not their own")
    fun picturesOfBeforeAreAList() {
        of("6")
        graded()
        val shown = """{"xmin":-3,"ymin":0,"xmax":1,"ymax":1}"""
        val part = """{"shown":$shown,"whole":${shown.replace(":1,", ":9,")},"pixel":{"x":0,"y":0}}"""
        val place = "columns -3..1 of -3..9, rows 0..1 of 0..1\n"
        drawn(0, "'#+-.#\n-+-..', '${part.replace("9", "1")}', x'01', x'02', x'03'")
        drawn(1, "'$place#+-.#\n-+-..', '$part', x'11', x'12', x'13'")
        drawn(2, "NULL, NULL, NULL, NULL, NULL")
        drawn(3, "'$place+-', NULL, x'31', x'32', x'33'")
        Database.open(file).use { database ->
            val cases =
                checkNotNull(Reports(database).of("s")).report.cases().map { case ->
                    case.pictures().map {
                        val text = it.text().`in`("ru").replace("\n", "/")
                        "${it.kind()} ${it.png().single()} $text ${it.part().map(PicturePart::isWhole)}"
                    }
                }
            val line = place.trim()
            assertEquals(
                listOf(
                    "expected 1 #.#.#/#.#.. Optional[true]",
                    "actual 2 ##..#/.#... Optional[true]",
                    "difference 3 #+-.#/-+-.. Optional[true]",
                ),
                cases[0],
            )
            assertEquals(
                listOf(
                    "expected 17 $line/#.#.#/#.#.. Optional[false]",
                    "actual 18 $line/##..#/.#... Optional[false]",
                    "difference 19 $line/#+-.#/-+-.. Optional[false]",
                ),
                cases[1],
            )
            assertEquals(emptyList<String>(), cases[2])
            assertEquals(
                listOf(
                    "expected 49 $line/.# Optional.empty",
                    "actual 50 $line/#. Optional.empty",
                    "difference 51 $line/+- Optional.empty",
                ),
                cases[3],
            )
        }
    }

    @Test
    @DisplayName("the rows of a large picture of before are cut")
    fun rowsOfALargePictureOfBeforeAreWhole() {
        of("6")
        graded()
        val rows = List(40) { "#+-.".repeat(20) }.joinToString("\n")
        drawn(0, "'$rows', NULL, x'01', x'02', x'03'")
        Database.open(file).use { database ->
            val case = checkNotNull(Reports(database).of("s")).report.cases().single()
            assertEquals(
                rows,
                case
                    .pictures()
                    .last()
                    .text()
                    .`in`("en"),
            )
        }
    }

    /** One submission with a result. */
    private fun graded() {
        execute(
            """INSERT INTO submissions (id, student_id, exercise, revision, attempt, source, seed, received_at, state)
               VALUES ('s', 'a', 'draw-dot', 'r1', 1, 'class Dot {}', 1, '2026-03-29T00:59:59.000Z', 'done')""",
        )
        execute(
            """INSERT INTO results (submission_id, revision, verdict, accuracy, stability, speed, points_of, isolation,
                   nanos_per_item, graded_at)
               VALUES ('s', 'r1', 'wrong', 6, 3, 1, 10, 'bubblewrap', 0, '2026-03-29T00:59:59.000Z')""",
        )
    }

    /** A case of it, with text, part and the three pictures. */
    private fun drawn(
        case: Int,
        pictures: String,
    ) = execute(
        """INSERT INTO case_results (submission_id, revision, position, name, visibility, verdict, points, points_of,
               message, scene, picture_text, picture_part, expected_png, actual_png, difference_png)
           VALUES ('s', 'r1', $case, 'case-$case', 'OPEN', 'WRONG', 0, 1, '', '', $pictures)""",
    )

    /** Makes the database as the server of that version left it, with the students a and b. */
    private fun of(version: String) {
        Tables(SQLiteDataSource().apply { url = "jdbc:sqlite:$file" }).migrate(version)
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
