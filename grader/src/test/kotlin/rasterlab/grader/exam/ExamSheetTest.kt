package rasterlab.grader.exam

import io.ktor.client.request.header
import io.ktor.client.request.post
import io.ktor.client.request.setBody
import io.ktor.client.statement.HttpResponse
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.exercises.Grading
import rasterlab.exercises.catalogue.Catalogue
import rasterlab.exercises.predicting.HandedAnswers
import rasterlab.exercises.predicting.Sheet
import rasterlab.exercises.predicting.SheetGrading
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.cookieOf
import rasterlab.grader.one
import rasterlab.grader.submission.SheetField
import java.nio.file.Path
import java.time.Duration
import java.time.Instant

/** The questions of a sheet are answered at an exam as elsewhere, by fields, and what is typed is kept. */
@Tag("slow")
class ExamSheetTest {
    @TempDir
    lateinit var folder: Path
    private var nanos = 0L

    private val exercise = Catalogue.builtIn().named("predict-line")

    private fun classroom() =
        Classroom(
            folder,
            Grading { exercise, source, cases, progress -> SheetGrading(exercise, cases, progress).report(source) },
            exercise = exercise,
            clock = { Instant.parse("2027-03-01T10:00:00Z") },
            nanos = { nanos },
        )

    @Test
    @DisplayName(
        "a sheet is a text to type at an exam, or what is typed is gone after a reload, above all what is no number",
    )
    fun asksByFieldsAndKeepsWhatIsTyped() =
        classroom().open(grades = false) {
            val (exam, cookie) = begun()
            val empty = seen(exam, cookie)
            assertFalse("<textarea" in empty, empty)
            val (sheet, names) = asked(empty)
            assertTrue(names.all { "name=\"$it\"" in empty }, empty)
            val typed = mapOf(names[0] to "12", names[1] to "1<2")
            assertEquals(302, send(exam, cookie, sheet, typed, to = "/draft").status.value)
            val shown = seen(exam, cookie)
            assertEquals("12" to "1&lt;2", value(shown, names[0]) to value(shown, names[1]))
            assertEquals("0", one("SELECT count(*) FROM submissions"))
            val refused = send(exam, cookie, sheet, typed)
            assertEquals(422, refused.status.value)
            val again = refused.bodyAsText()
            assertTrue("aria-invalid" in again && value(again, names[0]) == "12", again)
            assertTrue("id=\"clock\"" in again, "the exam is gone: $again")
            assertTrue("data-exam=\"/exams/$exam\"" in again, "the clock does not know where the exam is: $again")
        }

    @Test
    @DisplayName("answers that are typed at an exam are not graded, or the next attempt has the same questions")
    fun handsAnswersIn() =
        classroom().open {
            val (exam, cookie) = begun()
            val (sheet, _) = asked(seen(exam, cookie))
            repeat(2) { assertEquals(302, send(exam, cookie, sheet, right(sheet)).status.value) }
            assertEquals("opened draft hand-in", kinds(), "a second click is told as another one")
            val source = one("SELECT source FROM submissions")
            val handed = HandedAnswers.of(exercise, source).sheet()
            assertEquals(sheet.seed(), handed.seed())
            val next = seen(exam, cookie)
            assertFalse(asked(next).first.seed() == sheet.seed(), "the same questions again")
            assertTrue("submitted" in next, next)
            pass(Duration.ofHours(1))
            list(cookie)
            assertEquals("1", one("SELECT count(*) FROM submissions"))
            assertEquals("opened draft hand-in end", kinds())
        }

    @Test
    @DisplayName("a sheet on which nothing is answered is handed in, or the exam is gone from the page that says so")
    fun refusesASheetWithoutAnAnswer() =
        classroom().open(grades = false) {
            val (exam, cookie) = begun()
            val (sheet, _) = asked(seen(exam, cookie))
            val refused = send(exam, cookie, sheet, emptyMap())
            assertEquals(422, refused.status.value)
            val page = refused.bodyAsText()
            assertTrue("answer at least one" in page && "id=\"clock\"" in page, page)
            assertEquals("0", one("SELECT count(*) FROM submissions"))
        }

    @Test
    @DisplayName("answers that were kept are lost when time is over, or those that are none spoil the others")
    fun handsTheLastDraftInWhenTimeIsOver() =
        classroom().open(grades = false) {
            val (exam, cookie) = begun()
            val (sheet, names) = asked(seen(exam, cookie))
            val typed = right(sheet) + (names.last { it in right(sheet) } to "none")
            assertEquals("1800", send(exam, cookie, sheet, typed + ("quiet" to "yes"), to = "/draft").bodyAsText())
            pass(Duration.ofHours(1))
            list(cookie)
            assertEquals("opened draft hand-in end", kinds())
            val handed = HandedAnswers.of(exercise, one("SELECT source FROM submissions"))
            assertEquals(sheet.seed(), handed.sheet().seed())
            assertTrue("\"x\"" in one("SELECT source FROM submissions"), one("SELECT source FROM submissions"))
        }

    private fun pass(time: Duration) {
        nanos += time.toNanos()
    }

    private suspend fun Visit.begun(): Pair<String, String> {
        val course = newCourse()
        val cookie = cookieOf(newStudent(course))
        val exam = exam(course, "exercise" to "predict-line")
        assertEquals(302, open(exam, cookie).status.value)
        return exam to cookie
    }

    /** The sheet of the page's form, and the names of the fields for numbers. */
    private fun asked(page: String): Pair<Sheet, List<String>> {
        val seed = checkNotNull(Regex("name=\"seed\" value=\"(\\d+)\"").find(page)) { page }.groupValues[1].toLong()
        val sheet = Sheet.of(exercise.topic(), exercise.predicting().get(), seed)
        val fields = sheet.questions().flatMap { SheetField.of(it) }
        return sheet to fields.filter { it.choices.isEmpty() }.flatMap { it.names }
    }

    private fun right(sheet: Sheet): Map<String, String> =
        sheet
            .questions()
            .flatMap { question ->
                SheetField.of(question).filter { it.names.size == 1 }.map { part ->
                    part.names.single() to question.right().path(part.field).asText()
                }
            }.toMap()

    private fun value(
        page: String,
        name: String,
    ): String? =
        Regex("<input[^>]*name=\"$name\"[^>]*>")
            .find(page)
            ?.value
            ?.let { Regex("value=\"([^\"]*)\"").find(it) }
            ?.groupValues
            ?.get(1)

    private suspend fun Visit.send(
        exam: String,
        cookie: String,
        sheet: Sheet,
        typed: Map<String, String>,
        to: String = "",
    ): HttpResponse =
        client.post("/exams/$exam/exercises/predict-line$to") {
            header(HttpHeaders.Cookie, cookie)
            header(HttpHeaders.Host, "localhost")
            header(HttpHeaders.Origin, "http://localhost")
            header(HttpHeaders.ContentType, "multipart/form-data; boundary=b")
            val fields = mapOf("once" to "a page", "seed" to "${sheet.seed()}") + typed
            setBody(
                fields.entries.joinToString("") { (name, value) ->
                    "--b\r\nContent-Disposition: form-data; name=\"$name\"\r\n\r\n$value\r\n"
                } + "--b--\r\n",
            )
        }
}
