package rasterlab.grader.exam

import io.ktor.client.request.patch
import io.ktor.client.statement.HttpResponse
import io.ktor.client.statement.bodyAsText
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonPrimitive
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.assertProblem
import rasterlab.grader.bearer
import rasterlab.grader.cookieOf
import rasterlab.grader.json
import rasterlab.grader.list
import rasterlab.grader.one
import java.nio.file.Path
import java.time.Duration
import java.time.Instant

/** Instructors change an exam before it begins and while it runs. */
@Tag("slow")
class ExamChangeTest {
    @TempDir
    lateinit var folder: Path
    private var nanos = 0L

    private fun classroom() =
        Classroom(
            folder,
            more = listOf(Classroom.another("b")),
            clock = { Instant.parse("2027-03-01T09:00:00Z") },
            nanos = { nanos },
        )

    private fun pass(minutes: Long) {
        nanos += Duration.ofMinutes(minutes).toNanos()
    }

    @Test
    @DisplayName("whoever works on an exam keeps its old end, or what begun students rely on is changed")
    fun changesAnExamThatRuns() =
        classroom().open(grades = false) {
            val course = newCourse()
            val ada = cookieOf(newStudent(course))
            val exam = exam(course)
            assertEquals("b", change(exam, """{"exercises":["b"],"starts":"fixed"}""").json().exercise())
            assertEquals("draw-dot", change(exam, """{"exercises":["draw-dot"],"starts":"first"}""").json().exercise())
            pass(61)
            open(exam, ada)
            pass(10)
            assertEquals("2400", left(change(exam, """{"minutes":50}"""), exam, ada))
            assertEquals("1140", left(change(exam, """{"closes":"2027-03-01T10:30"}"""), exam, ada))
            for (fixed in listOf(""""exercises":["b"]""", """"opens":"2027-03-01T09:30"""", """"starts":"fixed"""")) {
                val refused = change(exam, "{$fixed}")
                assertTrue("cannot be changed any more" in refused.bodyAsText(), refused.bodyAsText())
                refused.assertProblem(422, "bad-exam")
            }
            change(exam, """{"minutes":0}""").assertProblem(422, "bad-exam")
            change(exam, """{"closes":"2027-03-01T09:30"}""").assertProblem(422, "bad-exam")
            val noted = one("SELECT detail FROM audit WHERE action = 'exam-change' AND detail LIKE 'closes%'")
            assertEquals("closes: 2027-03-01T12:00:00.000Z → 2027-03-01T10:30:00.000Z", noted)
            assertEquals("4", one("SELECT count(*) FROM audit WHERE action = 'exam-change'"))
        }

    @Test
    @DisplayName("an exam that is ended for everybody goes on, or loses a text, or more minutes are taken away")
    fun endsForEverybody() =
        classroom().open(grades = false) {
            val course = newCourse()
            val (ada, eve) = List(2) { cookieOf(newStudent(course)) }
            val exam = exam(course)
            val staff = cookieOf(instructor)
            val early = send("/instructor/exams/$exam/end", staff)
            assertEquals(422, early.status.value)
            val extra = "/instructor/exams/$exam/students/${one("SELECT id FROM students WHERE number = 2")}/extra"
            send(extra, staff, "extra" to "10")
            pass(61)
            listOf(ada, eve).forEach { open(exam, it) }
            draft(exam, ada, "class Dot { int last; }")
            assertTrue("End it now for everybody" in page("/instructor/exams/$exam", staff).bodyAsText())
            assertEquals(302, send("/instructor/exams/$exam/end", staff).status.value)
            assertEquals("0", draft(exam, ada, "class Dot { int last; }", "quiet" to "yes").bodyAsText())
            pass(1)
            assertEquals(409, draft(exam, ada, "class Dot {}").status.value)
            list(ada)
            assertEquals("class Dot { int last; }", one("SELECT source FROM submissions"))
            assertEquals("540", draft(exam, eve, "class Dot {}", "quiet" to "yes").bodyAsText())
        }

    @Test
    @DisplayName("the page of a change does not hold what the exam has, loses what was typed, or takes from others")
    fun isChangedOnItsPage() =
        classroom().open(grades = false) {
            val course = newCourse()
            val exam = exam(course, "zone" to "Europe/Berlin", "second" to "end")
            val address = "/instructor/exams/$exam/change"
            val staff = cookieOf(instructor)
            val form = page(address, staff).bodyAsText()
            for (held in listOf("value=\"2027-03-01T10:00:00\"", "value=\"Europe/Berlin\"", "value=\"30\"")) {
                assertTrue(held in form, form)
            }
            assertTrue(Regex("value=\"draw-dot\" checked").containsMatchIn(form), form)
            val refused = send(address, staff, *(FIELDS + ("minutes" to "none")).toList().toTypedArray())
            assertEquals(422, refused.status.value)
            assertTrue("value=\"none\"" in refused.bodyAsText(), "what was typed is lost")
            val both = FIELDS.toList() + ("exercise" to "b") + ("name" to "Final")
            assertEquals(302, send(address, staff, *both.toTypedArray()).status.value)
            assertEquals("2", one("SELECT count(*) FROM exam_exercises"))
            assertEquals(403, send(address, cookieOf(newStudent(course)), *both.toTypedArray()).status.value)
        }

    @Test
    @DisplayName("a list in the place of a text opens the exam to all addresses")
    fun refusesAListOfAddresses() =
        classroom().open(grades = false) {
            val exam = exam(newCourse(), "addresses" to "10.0.0.0/8")
            change(exam, """{"addresses":["10.0.0.0/16"]}""").assertProblem(400, "malformed-request")
            assertEquals("10.0.0.0/8", one("SELECT addresses FROM exams"))
        }

    private suspend fun Visit.change(
        exam: String,
        body: String,
    ): HttpResponse =
        client.patch("/api/v1/exams/$exam") {
            bearer(instructor)
            json(body)
        }

    private fun JsonObject.exercise() = list("exercises").single().jsonPrimitive.content

    /** The seconds that a student has left after a change. */
    private suspend fun Visit.left(
        changed: HttpResponse,
        exam: String,
        cookie: String,
    ): String {
        assertEquals(200, changed.status.value, changed.bodyAsText())
        return draft(exam, cookie, "class Dot {}", "quiet" to "yes").bodyAsText()
    }
}
