package rasterlab.grader.web

import io.ktor.client.request.forms.FormPart
import io.ktor.client.request.forms.MultiPartFormDataContent
import io.ktor.client.request.forms.formData
import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.patch
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
import rasterlab.exercises.Exercise
import rasterlab.exercises.Grading
import rasterlab.exercises.catalogue.Catalogue
import rasterlab.exercises.predicting.HandedAnswers
import rasterlab.exercises.predicting.Question
import rasterlab.exercises.predicting.Sheet
import rasterlab.exercises.predicting.SheetGrading
import rasterlab.exercises.predicting.TypedValue
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.assertProblem
import rasterlab.grader.bearer
import rasterlab.grader.cookieOf
import rasterlab.grader.json
import rasterlab.grader.submission.SheetField
import rasterlab.grader.text
import java.nio.file.Path
import java.time.Duration
import java.time.Instant

/** Handing in on the server's page: the questions of a sheet, and what is refused. */
@Tag("slow")
class HandInTest {
    @TempDir
    lateinit var folder: Path

    private var now = Instant.parse("2026-03-28T10:00:00Z")

    private fun classroom(exercise: Exercise = Classroom.EXERCISE) =
        Classroom(
            folder,
            Grading { one, source, cases, progress ->
                if (one.predicting().isPresent) {
                    SheetGrading(one, cases, progress).report(source)
                } else {
                    Classroom.wrongReport()
                }
            },
            exercise = exercise,
            clock = { now },
        )

    private fun asking(id: String) = Catalogue.builtIn().named(id)

    @Test
    @DisplayName("a sheet can be answered in JSON alone")
    fun aSheetIsAnsweredInTheFieldsOfThePage() {
        for (id in listOf("predict-clip-segment", "predict-visible-faces", "predict-rotate-axis")) {
            classroom(asking(id)).open {
                val student = newStudent()
                val sheet = sheet(student, id)
                val answer = send(student, id, "seed" to "${sheet.seed()}", *typed(sheet).toTypedArray())
                assertEquals(302, answer.status.value, answer.bodyAsText())
                val submission = idOf(answer)
                eventsToTheEnd(student, submission)
                val seen = look(student, "/api/v1/submissions/$submission").json()
                assertEquals("ok", seen.text("verdict"), seen.toString())
            }
            folder.resolve("test.db").toFile().delete()
        }
    }

    @Test
    @DisplayName("a number with a comma or a real minus is refused, or an empty field is an answer")
    fun numbersAreTakenAsPeopleWriteThem() {
        val id = "predict-rotate-axis"
        classroom(asking(id)).open {
            val student = newStudent()
            val sheet = sheet(student, id)
            val fields = listOf("answer-1-points-1" to "−1,5", "answer-1-points-2" to " 2 ", "answer-1-points-3" to "0")
            val answer = send(student, id, "seed" to "${sheet.seed()}", *fields.toTypedArray())
            val submission = idOf(answer)
            eventsToTheEnd(student, submission)
            val source = look(student, "/api/v1/submissions/$submission/source").bodyAsText()
            val handed = HandedAnswers.of(asking(id), source)
            assertEquals("[[-1.5,2,0]]", handed.answers()[0]["points"].toString())
            assertTrue(handed.answers()[1]["points"].isNull)
        }
    }

    @Test
    @DisplayName("what is wrong is not told at its field, the rest is lost, or it counts as an attempt")
    fun eachFieldThatIsWrongSaysSoAndAllIsKept() {
        val id = "predict-clip-segment"
        classroom(asking(id)).open {
            val student = newStudent()
            val seed = sheet(student, id).seed()
            val fields =
                arrayOf("answer-1-decision" to "four", "answer-2-decision" to "7", "answer-3-at" to "above")
            for ((language, word) in mapOf("en" to "This is not a number.", "ru" to "Это не число.")) {
                val answer = send(student, id, "seed" to "$seed", *fields, language = language)
                val page = answer.bodyAsText()
                assertEquals(422, answer.status.value, page)
                assertTrue(Regex("id=\"answer-1-decision-fault\">$word<").containsMatchIn(page), page)
                assertTrue("id=\"answer-3-at-fault\"" in page, page)
                assertFalse("id=\"answer-2-decision-fault\"" in page, page)
                assertTrue("value=\"four\"" in page && "value=\"7\"" in page, page)
                assertTrue(PageTexts.of(language).problem("bad-answers") in page, page)
            }
            assertEquals(seed, sheet(student, id).seed(), "it was taken for an attempt")
        }
    }

    @Test
    @DisplayName("a sheet whose fields are empty uses an attempt up, or what is wrong is not told")
    fun aSheetWithoutAnAnswerIsShownAgain() {
        val id = "predict-clip-segment"
        classroom(asking(id)).open(grades = false) {
            val student = newStudent()
            val seed = sheet(student, id).seed()
            for ((language, said) in mapOf("en" to "answer at least one", "ru" to "ответьте хотя бы на один")) {
                val answer = send(student, id, "seed" to "$seed", "answer-1-decision" to " ", language = language)
                assertEquals(422, answer.status.value)
                val page = answer.bodyAsText()
                assertTrue(said in page && PageTexts.of(language).problem("bad-sheet") in page, page)
                assertTrue("name=\"answer-1-decision\"" in page, page)
            }
            assertEquals(seed, sheet(student, id).seed(), "it was taken for an attempt")
        }
    }

    @Test
    @DisplayName("answers to a sheet that was handed in already answer the next one")
    fun answersToAnotherSheetAreNotTaken() {
        val id = "predict-clip-segment"
        classroom(asking(id)).open(grades = false) {
            val student = newStudent()
            val seed = sheet(student, id).seed()
            assertEquals(302, send(student, id, "seed" to "$seed", "answer-1-decision" to "1").status.value)
            val again = send(student, id, "seed" to "$seed", "answer-1-decision" to "3")
            assertEquals(422, again.status.value)
            val page = again.bodyAsText()
            assertTrue(
                "another attempt’s sheet" in page || "another attempt&#39;s sheet" in page ||
                    "another attempt's sheet" in page,
                page,
            )
            assertFalse("value=\"3\"" in page, page)
        }
    }

    @Test
    @DisplayName("another language empties the form, or hands it in")
    fun anotherLanguageKeepsWhatWasTyped() {
        val id = "predict-clip-segment"
        classroom(asking(id)).open(grades = false) {
            val student = newStudent()
            val seed = sheet(student, id).seed()
            val typed = arrayOf("seed" to "$seed", "answer-1-decision" to "four", "answer-2-decision" to "7")
            val refused = send(student, id, *typed).bodyAsText()
            val button = Regex("<button[^>]*formaction=\"/exercises/$id\\?lang=ru\"[^>]*>").find(refused)?.value
            assertTrue(button != null && "form=\"steps\"" in button && "name=\"again\"" in button, refused)
            val again = send(student, id, *typed, "again" to "true", language = "ru")
            val page = again.bodyAsText()
            assertEquals(200, again.status.value, page)
            assertTrue("lang=\"ru\"" in page && "value=\"four\"" in page && "value=\"7\"" in page, page)
            val document = send(student, id, "source" to "{\"typed\": 1}", "again" to "true").bodyAsText()
            assertTrue("{&quot;typed&quot;: 1}" in document || "{\"typed\": 1}" in document, document)
            assertTrue("form=\"whole\"" in document, document)
            assertEquals(seed, sheet(student, id).seed(), "it was handed in")
        }
    }

    @Test
    @DisplayName("only the first mistake of a document is told")
    fun allMistakesOfADocumentAreToldAndItIsKept() {
        val id = "predict-clip-segment"
        classroom(asking(id)).open(grades = false) {
            val student = newStudent()
            val seed = sheet(student, id).seed()
            val json = """{"exercise":"$id","seed":$seed,"answers":[{"decision":"a"},{"at":"above","zz":1}]}"""
            val answer = send(student, id, "source" to json)
            val page = answer.bodyAsText()
            assertEquals(422, answer.status.value, page)
            for (place in listOf("decision", "zz", "at")) {
                assertTrue(Regex("<li>[^<]*field '$place'").containsMatchIn(page), "$place in $page")
            }
            assertTrue("{&quot;at&quot;:&quot;above&quot;" in page || """{"at":"above"""" in page, page)
        }
    }

    @Test
    @DisplayName("what is late is stored without consent, or no consent is asked for, or the text is lost")
    fun aLateHandInIsTakenWithConsentAlone() =
        classroom().open(grades = false) {
            val course =
                client
                    .post("/api/v1/courses") {
                        bearer(instructor)
                        json("""{"name":"Graphics"}""")
                    }.json()
            val student = newStudent(course.text("code"))
            client.patch("/api/v1/courses/${course.text("course")}/exercises/draw-dot") {
                bearer(instructor)
                json("""{"deadline":"$now"}""")
            }
            assertFalse("name=\"late\"" in page(student, "draw-dot"))
            assertEquals(302, send(student, "draw-dot", "source" to "class A {}").status.value)
            now += Duration.ofMillis(1)
            submit(student).assertProblem(409, "late")
            assertTrue("name=\"late\"" in page(student, "draw-dot"))
            for (language in listOf("en", "ru")) {
                val late = send(student, "draw-dot", "source" to "class Late {}", language = language)
                val page = late.bodyAsText()
                assertEquals(409, late.status.value, page)
                assertTrue(PageTexts.of(language).problem("late") in page, page)
                assertTrue(PageTexts.of(language).say("exercise.late") in page, page)
                assertTrue("class Late {}" in page, page)
            }
            val agreed = send(student, "draw-dot", "source" to "class Late {}", "late" to "accept")
            assertEquals(302, agreed.status.value, agreed.bodyAsText())
            assertEquals(202, submit(student, late = true).status.value)
            assertEquals(3, Regex("No\\. \\d").findAll(page(student, "draw-dot")).count())
        }

    /** A program by somebody who knows all types. */
    private fun typed(sheet: Sheet): List<Pair<String, String>> = sheet.questions().flatMap { typed(it) }

    private fun typed(question: Question) =
        SheetField.of(question).flatMap { part ->
            val right = question.right()[part.field]
            val texts = if (part.choices.isEmpty()) TypedValue.numbers(right) else listOf(right.asText())
            part.names.zip(texts)
        }

    private suspend fun Visit.sheet(
        student: String,
        id: String,
    ): Sheet = HandedAnswers.of(asking(id), look(student, "/api/v1/exercises/$id/starter").bodyAsText()).sheet()

    private suspend fun Visit.page(
        student: String,
        id: String,
    ): String {
        val cookie = cookieOf(student)
        return client.get("/exercises/$id?lang=en") { header(HttpHeaders.Cookie, cookie) }.bodyAsText()
    }

    private suspend fun Visit.send(
        student: String,
        id: String,
        vararg fields: Pair<String, String>,
        language: String = "en",
    ): HttpResponse {
        val cookie = cookieOf(student)
        return client.post("/exercises/$id") {
            header(HttpHeaders.Host, "localhost")
            header(HttpHeaders.Origin, "http://localhost")
            header(HttpHeaders.Cookie, cookie)
            header(HttpHeaders.AcceptLanguage, language)
            setBody(MultiPartFormDataContent(formData(*fields.map { FormPart(it.first, it.second) }.toTypedArray())))
        }
    }

    private fun idOf(answer: HttpResponse) = checkNotNull(answer.headers[HttpHeaders.Location]).substringAfterLast('/')
}
