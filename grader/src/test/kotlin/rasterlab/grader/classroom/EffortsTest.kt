package rasterlab.grader.classroom

import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
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
import rasterlab.grader.Visit
import rasterlab.grader.assertProblem
import rasterlab.grader.cookieOf
import rasterlab.grader.course.Courses
import rasterlab.grader.hint.Hints
import rasterlab.grader.json
import rasterlab.grader.storage.Database
import rasterlab.grader.submission.Reports
import rasterlab.grader.text
import java.nio.file.Path
import java.time.InstantSource

/** Staff see who never passed an exercise, who is stuck, and what hints do. */
@Tag("slow")
class EffortsTest {
    @TempDir
    lateinit var folder: Path

    /** Gives the points that stand in the source; all ten of them pass. */
    private val bySource =
        Grading { _, source, _, _ -> report(source.filter { it.isDigit() }.toInt()) }

    private val clock = InstantSource.system()

    private fun report(points: Int): Report {
        val verdict = if (points == 10) GradingVerdict.OK else GradingVerdict.WRONG
        return Report(verdict, ScorePoints(points, 0, 0, 10), emptyList(), emptyList(), "", 1.0)
    }

    private suspend fun Visit.hand(
        course: String,
        vararg points: Int,
    ): String {
        val token = newStudent(course)
        points.forEach { eventsToTheEnd(token, submit(token, "class Dot { /* $it */ }").json().text("id")) }
        return token
    }

    @Test
    @DisplayName("who gained lately, or passed, is called stuck; or who is stuck for longest does not come first")
    fun tellsWhoIsStuck() =
        Database.open(folder.resolve("test.db")).use { database ->
            val students = ClassOfStudents(database, clock)
            val reports = Reports(database)
            val handed =
                listOf(
                    listOf(1, 2, 3, 4),
                    listOf(4, 4, 4, 4),
                    listOf(10, 3, 3, 3, 3),
                    listOf(6, 5, 2, 6, 6),
                    listOf(2, 4, 4, 4),
                )
            handed.forEachIndexed { number, all ->
                val student = students.student("Ada $number")
                all.forEach { points ->
                    val id = students.handIn(student)
                    database.write { handle ->
                        reports.insert(handle, id, "r1", report(points), clock.instant())
                        handle.execute("UPDATE submissions SET state = 'done'")
                    }
                }
            }
            val course = Courses(database, clock).all().single().id
            val found = Efforts(database, Hints(database, clock)).of(course, "draw-dot")
            assertEquals(5 to 4, found.efforts.size to found.open.size)
            assertEquals(
                listOf("5 6 4 true", "4 4 3 true", "4 4 2 false", "4 4 0 false"),
                found.open.map { "${it.attempts} ${it.best} ${it.withoutGain} ${it.stuck}" },
            )
        }

    @Test
    @DisplayName("a gain that hints or lateness took, or that staff gave, is not seen")
    fun countsWhatCounts() =
        Database.open(folder.resolve("test.db")).use { database ->
            val students = ClassOfStudents(database, clock)
            val reports = Reports(database)
            val student = students.student("Ada")
            val handed =
                listOf(4, 8, 8, 2).map { points ->
                    students.handIn(student).also { id ->
                        database.write { reports.insert(it, id, "r1", report(points), clock.instant()) }
                    }
                }
            database.write { handle ->
                handle.execute("UPDATE submissions SET state = 'done'")
                handle.execute("UPDATE submissions SET penalty = 50 WHERE id = ?", handed[1])
                handle.execute("UPDATE submissions SET hint_cost = 3 WHERE id = ?", handed[2])
            }
            val course = Courses(database, clock).all().single().id

            fun told() =
                Efforts(database, Hints(database, clock)).of(course, "draw-dot").efforts.single().let {
                    "${it.best} ${it.withoutGain}"
                }
            assertEquals("5 1", told())
            database.write {
                it.execute(
                    """INSERT INTO adjustments (id, submission_id, points, reason, total_before, account_id, given_at)
                       VALUES ('a', ?, 4, 'r', 2, 'i', '2026-01-01T00:00:00Z')""",
                    handed[3],
                )
            }
            assertEquals("6 0", told())
        }

    @Test
    @DisplayName("the page does not tell who is stuck, or a student sees it")
    fun pageTellsWhoIsStuck() =
        Classroom(folder, bySource).open {
            val course = newCourse()
            val ada = hand(course, 4, 4, 4, 4)
            look(ada, "/api/v1/courses/$course/$STUCK").assertProblem(403, "wrong-role")
            val cookie = cookieOf(instructor)

            suspend fun page(path: String) = client.get(path) { header(HttpHeaders.Cookie, cookie) }.bodyAsText()
            val html = page("/instructor/courses/$course/$STUCK")
            for (words in listOf("Ada", """<span class="loses">stuck""", "4 / 10", "Never passed", "/$ERRORS\"")) {
                assertTrue(words in html, "no $words in $html")
            }
            assertTrue("не\u00a0продвигается</span>" in page("/instructor/courses/$course/$STUCK?lang=ru"))
            assertTrue("/$STUCK\"" in page("/instructor/courses/$course/$ERRORS"), "no way to the page")
        }

    private companion object {
        const val STUCK = "exercises/draw-dot/stuck"
        const val ERRORS = "exercises/draw-dot/errors"
    }
}
