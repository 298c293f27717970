package rasterlab.grader.comparison

import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import kotlinx.serialization.json.jsonObject
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.exercises.Grading
import rasterlab.exercises.score.GradingVerdict
import rasterlab.exercises.score.ScorePoints
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.assertProblem
import rasterlab.grader.cookieOf
import rasterlab.grader.field
import rasterlab.grader.json
import rasterlab.grader.list
import rasterlab.grader.text
import java.nio.file.Path

/** Two submissions of a student stand beside each other, over HTTP and on the page. */
@Tag("slow")
class ComparisonTest {
    @TempDir
    lateinit var folder: Path

    /** Gives as many points as the source has lines. */
    private val byLines =
        Grading { _, source, _, _ ->
            val verdict = if ("right" in source) GradingVerdict.OK else GradingVerdict.WRONG
            Classroom.report(verdict, ScorePoints(source.lines().size, 0, 0, 10))
        }

    private suspend fun Visit.graded(
        student: String,
        source: String,
    ): String = submit(student, source).json().text("id").also { eventsToTheEnd(student, it) }

    @Test
    @DisplayName("the later one stands first, a line or a case is left out, or points are the other's")
    fun setsTheEarlierOneFirst() =
        Classroom(folder, byLines).open {
            val student = newStudent()
            val (first, second) = listOf("a\nb", "a\nright\nc").map { graded(student, it) }
            for (by in listOf(student, instructor)) {
                val pair = look(by, "/api/v1/submissions/$second/compare/$first").json()
                val points = listOf("first", "second").map { pair.getValue(it).jsonObject.text("total") }
                assertEquals(listOf("2", "3"), points)
                assertEquals(
                    listOf("same 1 1", "changed 2 2", "added null 3"),
                    pair.list("lines").map { one ->
                        listOf("kind", "first", "second").joinToString(" ", transform = one::field)
                    },
                )
                val cases =
                    pair.list("cases").map { one ->
                        listOf("first", "second").map { one.jsonObject.getValue(it).field("verdict") }
                    }
                assertEquals(List(2) { listOf("wrong", "ok") }, cases)
            }
        }

    @Test
    @DisplayName(
        "another student's work is compared, or that for another exercise or of another student with one's own",
    )
    fun comparesOnesOwnAlone() =
        Classroom(folder, byLines).open {
            val course = newCourse()
            val (student, other) = List(2) { newStudent(course) }
            val own = graded(student, "a")
            val theirs = graded(other, "b")
            for ((id, with) in listOf(own to theirs, theirs to own, theirs to theirs)) {
                look(student, "/api/v1/submissions/$id/compare/$with").assertProblem(404, "unknown-submission")
                assertEquals(404, page("/submissions/$id/compare?first=$with", student).first)
            }
            look(instructor, "/api/v1/submissions/$own/compare/$theirs").assertProblem(404, "unknown-submission")
        }

    @Test
    @DisplayName("a page shows no line that differs, no picture of one version, or a hidden one to a student")
    fun picturesStandBesideEachOther() =
        Classroom(folder, byLines).open {
            val student = newStudent()
            val first = graded(student, "a\n<script>")
            assertFalse("/compare" in page("/submissions/$first", student).second)
            assertTrue("There is one version only." in page("/submissions/$first/compare", student).second)
            val second = graded(student, "a\nright\nc")
            assertTrue("/submissions/$first/compare\"" in page("/submissions/$first", student).second)
            val shown = page("/submissions/$second/compare", student).second
            for (id in listOf(first, second)) {
                for (kind in listOf("expected", "actual", "difference")) {
                    assertTrue("/api/v1/submissions/$id/cases/open-case/$kind.png" in shown, "$kind of $id in $shown")
                }
                assertFalse("/api/v1/submissions/$id/cases/hidden-case/" in shown, shown)
                assertTrue(
                    "/api/v1/submissions/$id/cases/hidden-case/" in
                        page("/submissions/$second/compare", instructor).second,
                )
            }
            assertTrue("&lt;script&gt;" in shown && "<script>" !in shown, shown)
            assertTrue("""<tr class="changed">""" in shown && """<tr class="added">""" in shown, shown)
            val same = page("/submissions/$second/compare?first=$second&second=$first&lang=ru", student).second
            assertTrue("Ранняя версия" in same && """<option value="$first" selected""" in same, same)
        }

    private suspend fun Visit.page(
        path: String,
        by: String,
    ): Pair<Int, String> {
        val cookie = cookieOf(by)
        val asked = if ("lang=" in path) path else path + (if ('?' in path) "&" else "?") + "lang=en"
        val answer = client.get(asked) { header(HttpHeaders.Cookie, cookie) }
        return answer.status.value to answer.bodyAsText()
    }
}
