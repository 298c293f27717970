package rasterlab.grader.submission

import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.post
import io.ktor.client.request.setBody
import io.ktor.client.statement.HttpResponse
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import kotlinx.serialization.json.jsonObject
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.exercises.Grading
import rasterlab.exercises.catalogue.Catalogue
import rasterlab.exercises.predicting.HandedAnswers
import rasterlab.exercises.predicting.SheetGrading
import rasterlab.exercises.predicting.SheetText
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.assertProblem
import rasterlab.grader.bearer
import rasterlab.grader.cookieOf
import rasterlab.grader.field
import rasterlab.grader.json
import rasterlab.grader.list
import rasterlab.grader.text
import java.nio.file.Path

/** Each attempt of a student has a sheet of its own, and no other is taken. */
class SheetsTest {
    @TempDir
    lateinit var folder: Path

    private val exercise = Catalogue.builtIn().named("predict-line")

    private fun classroom() =
        Classroom(
            folder,
            Grading { exercise, source, cases, progress -> SheetGrading(exercise, cases, progress).report(source) },
            exercise = exercise,
        )

    private suspend fun Visit.sheet(who: String) = look(who, "/api/v1/exercises/predict-line/starter").bodyAsText()

    private fun answered(sheet: String): String {
        val drawn = HandedAnswers.of(exercise, sheet).sheet()
        return SheetText.written("predict-line", drawn) { it.right() }
    }

    private suspend fun Visit.handIn(
        student: String,
        sheet: String,
    ): HttpResponse =
        client.post("/api/v1/exercises/predict-line/submissions") {
            bearer(student)
            header(HttpHeaders.ContentType, "application/json")
            setBody(sheet)
        }

    @Test
    fun theSheetOfTheAttemptIsGraded() =
        classroom().open {
            val student = newStudent()
            val answer = handIn(student, answered(sheet(student)))
            assertEquals(202, answer.status.value)
            val id = answer.json().text("id")
            eventsToTheEnd(student, id)
            val seen = look(student, "/api/v1/submissions/$id").json()
            assertEquals("ok", seen.text("verdict"), seen.toString())
            assertEquals("100", seen.getValue("points").jsonObject.text("total"))
            val first = seen.list("cases").first()
            assertTrue("which is right; F(M) = " in first.field("message"), first.toString())
        }

    @Test
    fun aWrongStepIsToldWithTheDecisionValueInBothLanguages() =
        classroom().open {
            val student = newStudent()
            val sheet = HandedAnswers.of(exercise, sheet(student)).sheet()
            val asked = sheet.questions().first()
            val value = asked.reason().orElseThrow()
            val right = asked.right()
            val wrong = right.deepCopy().put("x", right["x"].intValue() + 5)
            val written = SheetText.written("predict-line", sheet) { if (it == asked) wrong else it.right() }
            val id = handIn(student, written).json().text("id")
            eventsToTheEnd(student, id)
            val russian = value.toString().replace('-', '−')
            for ((language, reason) in mapOf("en" to "here it is $value", "ru" to "здесь $russian")) {
                val told =
                    look(student, "/api/v1/submissions/$id?lang=$language")
                        .json()
                        .list("cases")
                        .first()
                        .field("message")
                assertTrue(reason in told && "F(M)" in told, told)
                val page = page(student, "/submissions/$id?lang=$language")
                val shown = reason.replace('-', '−')
                assertTrue(shown in page, "$language: not on the page")
                val mine = mapOf("en" to "Your answer", "ru" to "Ваш ответ").getValue(language)
                val x = wrong["x"].intValue()
                val answer = Regex("<dt>$mine</dt>\\s*<dd>x = ${if (x < 0) "−${-x}" else "$x"}[,;]")
                assertTrue(answer.containsMatchIn(page), "$language: what was answered is not on the page")
            }
        }

    private suspend fun Visit.page(
        student: String,
        path: String,
    ): String {
        val cookie = cookieOf(student)
        return client.get(path) { header(HttpHeaders.Cookie, cookie) }.bodyAsText()
    }

    @Test
    fun eachAttemptAndEachStudentHasAnotherSheet() =
        classroom().open {
            val student = newStudent()
            val first = sheet(student)
            assertEquals(first, sheet(student), "the same until it is answered")
            assertNotEquals(first, sheet(newStudent()))
            handIn(student, answered(first))
            assertNotEquals(first, sheet(student))
        }

    @Test
    fun aSheetThatWasChosenOrAnsweredBeforeIsNoAttempt() =
        classroom().open(grades = false) {
            val student = newStudent()
            handIn(student, SheetText.open(exercise, 7)).assertProblem(422, "bad-sheet")
            val first = answered(sheet(student))
            assertEquals(202, handIn(student, first).status.value)
            val again = handIn(student, first)
            assertTrue("another attempt's sheet" in again.bodyAsText())
            again.assertProblem(422, "bad-sheet")
            assertEquals(202, handIn(student, answered(sheet(student))).status.value)
        }

    @Test
    fun aSheetThatCannotBeReadIsNoAttemptAndIsToldWithItsPlace() =
        classroom().open(grades = false) {
            val student = newStudent()
            val sheet = sheet(student)
            val wrong = sheet.replaceFirst("\"x\": null", "\"x\": \"a\"")
            val answer = handIn(student, wrong)
            assertTrue("answers[0]" in answer.bodyAsText(), answer.bodyAsText())
            answer.assertProblem(422, "bad-sheet")
            assertEquals(sheet, sheet(student))
        }

    @Test
    @DisplayName("a sheet on which nothing is answered uses an attempt up")
    fun aSheetWithoutAnAnswerIsNoAttempt() =
        classroom().open(grades = false) {
            val student = newStudent()
            val sheet = sheet(student)
            for (empty in listOf(sheet, sheet.replace(Regex("(?s)\"answers\": \\[.*\\]"), "\"answers\": []"))) {
                val answer = handIn(student, empty)
                assertTrue("none of the 16 questions is answered; answer at least one" in answer.bodyAsText())
                answer.assertProblem(422, "bad-sheet")
            }
            assertEquals(sheet, sheet(student), "it was taken for an attempt")
            assertEquals(202, handIn(student, answered(sheet)).status.value)
        }

    @Test
    fun theInstructorSeesASheetToTry() =
        classroom().open(grades = false) {
            val first = HandedAnswers.of(exercise, sheet(instructor)).sheet()
            assertEquals(16, first.questions().size)
            assertNotEquals(first.seed(), HandedAnswers.of(exercise, sheet(instructor)).sheet().seed())
        }
}
