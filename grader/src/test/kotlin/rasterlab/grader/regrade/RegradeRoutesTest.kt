package rasterlab.grader.regrade

import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.post
import io.ktor.client.request.setBody
import io.ktor.client.statement.HttpResponse
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.exercises.Grading
import rasterlab.exercises.catalogue.Catalogue
import rasterlab.exercises.score.GradingVerdict
import rasterlab.exercises.score.ScorePoints
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.assertProblem
import rasterlab.grader.bearer
import rasterlab.grader.cookieOf
import rasterlab.grader.field
import rasterlab.grader.json
import rasterlab.grader.list
import rasterlab.grader.one
import rasterlab.grader.printedBy
import rasterlab.grader.sendForm
import rasterlab.grader.text
import java.nio.file.Path
import java.util.concurrent.atomic.AtomicInteger

/** A regrade is begun, watched and decided on by HTTP, on a page, and by the command. */
@Tag("slow")
class RegradeRoutesTest {
    @TempDir
    lateinit var folder: Path

    /** Each program is worth less the first time than later. */
    private val graded = AtomicInteger()
    private val grading =
        Grading { _, _, _, _ ->
            val first = graded.getAndIncrement() == 0
            val verdict = if (first) GradingVerdict.WRONG else GradingVerdict.OK
            Classroom.report(verdict, ScorePoints(if (first) 2 else 6, 0, 0, 10))
        }

    @Test
    @DisplayName("a dry run by HTTP tells nobody who gains, or counts before it is accepted")
    fun byHttp() =
        Classroom(folder, grading).open {
            val course = newCourse()
            val submission = handIn(course)
            val begun = begin(course, """{"of":"latest"}""", dry = true, key = "once")
            assertEquals(202, begun.status.value)
            val id = begun.json().text("regrade")
            assertEquals("/api/v1/regrades/$id", begun.headers[HttpHeaders.Location])
            assertEquals(id, begin(course, """{"of":"latest"}""", dry = true, key = "once").json().text("regrade"))
            begin(course, """{"of":"best"}""", dry = true, key = "once").assertProblem(422, "idempotency-key-reused")
            assertTrue("event: done" in look(instructor, "/api/v1/regrades/$id/events").bodyAsText())
            val whole = look(instructor, "/api/v1/regrades/$id").json()
            assertEquals("graded", whole.getValue("regrade").field("state"))
            val change = whole.list("changes").single().jsonObject
            assertEquals(listOf(submission, "Ada", "1"), listOf("submission", "name", "attempt").map(change::text))
            assertEquals(listOf("2", "6"), listOf("before", "after").map { change.getValue(it).field("points") })
            assertEquals(
                "wrong",
                change
                    .list("cases")[0]
                    .jsonObject
                    .getValue("before")
                    .field("verdict"),
            )
            assertEquals("2", pointsOf(submission))
            assertEquals("accepted", decide(id, "accept").json().text("state"))
            assertEquals("6", pointsOf(submission))
            decide(id, "discard").assertProblem(409, "regrade-stands")
            assertEquals("undone", decide(id, "undo").json().text("state"))
            assertEquals("2", pointsOf(submission))
            val listed = look(instructor, "/api/v1/courses/$course/regrades").bodyAsText()
            assertTrue(id in listed && "\"undone\"" in listed, listed)
        }

    @Test
    @DisplayName("a student begins or sees a regrade, or one that cannot be is begun")
    fun refusesWhatCannotBe() =
        Classroom(folder, grading).open {
            val course = newCourse()
            begin(course, "{}").assertProblem(422, "bad-regrade")
            val submission = handIn(course)
            val student = newStudent(course)
            begin(course, "{}", by = student).assertProblem(403, "wrong-role")
            begin(course, """{"of":"worst"}""").assertProblem(422, "bad-regrade")
            begin(course, """{"submissions":["none"]}""").assertProblem(422, "bad-regrade")
            begin(course, """{"of":"all","submissions":["$submission"]}""").assertProblem(400, "malformed-request")
            begin("none", "{}").assertProblem(404, "unknown-course")
            val other = newCourse()
            begin(other, """{"submissions":["$submission"]}""").assertProblem(422, "bad-regrade")
            val id = begin(course, """{"submissions":["$submission"]}""").json().text("regrade")
            for (path in listOf("regrades/$id", "regrades/$id/events", "courses/$course/regrades")) {
                look(student, "/api/v1/$path").assertProblem(403, "wrong-role")
            }
            for (name in DECISIONS.keys) {
                decide(id, name, by = student).assertProblem(403, "wrong-role")
                decide("none", name).assertProblem(404, "unknown-regrade")
            }
            look(instructor, "/api/v1/regrades/none").assertProblem(404, "unknown-regrade")
            assertEquals("1", one("SELECT count(*) FROM regrades"))
        }

    @Test
    @DisplayName("an unknown choice is answered with one that the description lacks, or a missing name is not told")
    fun tellsTheChoicesThereAre() =
        Classroom(folder, grading).open {
            val course = newCourse()
            handIn(course)
            val choices = choices()
            val wrong = begin(course, """{"of":"bset"}""").json().text("detail")
            val described =
                choices
                    .getValue("of")
                    .jsonObject
                    .list("enum")
                    .joinToString { it.jsonPrimitive.content }
            assertTrue(wrong.endsWith("allowed are $described"), wrong)
            val unnamed = begin(course, """{"of":"some"}""").json().text("detail")
            assertTrue("submissions" in unnamed && "nothing" !in unnamed, unnamed)
            begin(course, """{"submissions":[]}""").assertProblem(400, "malformed-request")
            assertEquals("1", choices.getValue("submissions").field("minItems"))
        }

    @Test
    @DisplayName("the pages begin no regrade, do not tell who gains, forget what was chosen, or let a student in")
    fun onPages() =
        Classroom(folder, grading).open {
            val course = newCourse()
            val submission = handIn(course)
            val begin = "/instructor/courses/$course/exercises/draw-dot/regrade"
            assertTrue("/exercises/draw-dot/regrade\"" in show(begin.substringBeforeLast('/')), "no way to the page")
            assertTrue("Ada, no. 1: 2 of 10" in show(begin))
            assertEquals(403, send(begin, "of=all", by = newStudent(course)).status.value)
            val nothing = send(begin, "of=some&dry=no")
            assertEquals(422, nothing.status.value)
            assertTrue("value=\"some\" checked=\"checked\"" in nothing.bodyAsText(), nothing.bodyAsText())
            val page = send(begin, "of=some&submission=$submission&dry=yes").headers[HttpHeaders.Location].orEmpty()
            val events = client.get("$page/events") { header(HttpHeaders.Cookie, cookieOf(instructor)) }.bodyAsText()
            assertTrue("event: done" in events, events)
            val tried = show(page)
            assertTrue("Gain: 1. Lose: 0. Same points: 0." in tried && ">+4</span>" in tried, tried)
            assertTrue("<li>one pixel: " in tried, tried)
            assertTrue("Выигрывают: 1." in show("$page?lang=ru"))
            assertEquals("2", pointsOf(submission))
            assertEquals(302, send("$page/accept", "").status.value)
            assertEquals("6", pointsOf(submission))
            assertEquals(409, send("$page/accept", "").status.value)
            assertEquals(302, send("$page/undo", "").status.value)
            assertEquals("2", pointsOf(submission))
            assertTrue(page in show(begin), "no list of regrades")
            val changes = show("/instructor/audit")
            for (word in listOf("grading again begun", "regrade accepted", "regrade undone")) {
                assertTrue("<div>$word</div>" in changes, changes)
            }
            assertTrue("""<a href="$page">Draw a dot</a>""" in changes, changes)
        }

    @Test
    @DisplayName("the command begins no regrade, or does not tell how it ends")
    fun byCommand() =
        Classroom(folder, grading, exercise = Catalogue.builtIn().named(LINE)).open {
            val course = newCourse()
            val submission = handIn(course, LINE)
            assertTrue("none" in command("start", course, "none", exit = 2))
            assertTrue("а можно all" in command("start", course, LINE, "--of", "worst", "--lang", "ru", exit = 2))
            val begun = command("start", course, LINE, "--submission", submission, "--dry-run")
            val id = checkNotNull(Regex("regrade\t(\\S+)\nsubmissions\t1\n").find(begun)) { begun }.groupValues[1]
            look(instructor, "/api/v1/regrades/$id/events").bodyAsText()
            assertTrue("$LINE\tsome\tgraded\t1/1" in command("list", course))
            val shown = command("show", id)
            assertTrue("graded: graded 1 of 1" in shown && "gain 1, lose 0" in shown, shown)
            assertTrue("$submission\tAda\t2\t6\topen-case: wrong > ok" in shown, shown)
            assertTrue("accepted: graded 1 of 1" in command("accept", id))
            assertEquals("6", pointsOf(submission))
            assertTrue("перепроверка уже принята" in command("accept", id, "--lang", "ru", exit = 2))
            assertTrue("undone" in command("undo", id))
            assertTrue("прежние результаты уже возвращены" in command("discard", id, "--lang", "ru", exit = 2))
            assertTrue("перепроверки «none» нет" in command("show", "none", "--lang", "ru", exit = 2))
        }

    private suspend fun Visit.handIn(
        course: String,
        exercise: String = "draw-dot",
    ): String {
        val student = newStudent(course)
        val handed =
            client.post("/api/v1/exercises/$exercise/submissions") {
                bearer(student)
                header(HttpHeaders.ContentType, "text/x-java-source")
                setBody("class Dot {}")
            }
        val id = handed.json().text("id")
        eventsToTheEnd(student, id)
        return id
    }

    private suspend fun Visit.begin(
        course: String,
        body: String,
        dry: Boolean = false,
        by: String = instructor,
        key: String? = null,
    ): HttpResponse =
        client.post("/api/v1/courses/$course/exercises/draw-dot/regrade?dry=$dry") {
            bearer(by)
            key?.let { header("Idempotency-Key", it) }
            json(body)
        }

    /** The fields of a request to begin, as the description of the server has them. */
    private suspend fun Visit.choices(): JsonObject {
        val address =
            listOf("paths", "/api/v1/courses/{course}/exercises/{id}/regrade", "post", "requestBody", "content") +
                listOf("application/json", "schema", "properties")
        return address.fold(client.get("/openapi.json").json()) { at, key -> at.getValue(key).jsonObject }
    }

    private suspend fun Visit.decide(
        id: String,
        name: String,
        by: String = instructor,
    ): HttpResponse = client.post("/api/v1/regrades/$id/$name") { bearer(by) }

    private suspend fun Visit.pointsOf(submission: String): String {
        val points = look(instructor, "/api/v1/submissions/$submission").json().getValue("points")
        return if (points == JsonNull) "" else points.field("total")
    }

    private suspend fun Visit.show(path: String): String {
        val cookie = cookieOf(instructor)
        val address = if ('?' in path) path else "$path?lang=en"
        return client.get(address) { header(HttpHeaders.Cookie, cookie) }.bodyAsText()
    }

    private suspend fun Visit.send(
        path: String,
        body: String,
        by: String = instructor,
    ): HttpResponse = sendForm("$path?lang=en", body, by)

    private fun command(
        vararg arguments: String,
        exit: Int = 0,
    ) = printedBy(folder, "regrade", *arguments, exit = exit)

    private companion object {
        const val LINE = "line-bresenham"
    }
}
