package rasterlab.grader.complaint

import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.patch
import io.ktor.client.request.post
import io.ktor.client.statement.HttpResponse
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.exercises.Exercise
import rasterlab.exercises.Grading
import rasterlab.exercises.score.CaseReport
import rasterlab.exercises.score.Disclosure
import rasterlab.exercises.score.GradingVerdict
import rasterlab.exercises.score.Message
import rasterlab.exercises.score.Report
import rasterlab.exercises.score.ScorePoints
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.assertProblem
import rasterlab.grader.bearer
import rasterlab.grader.cookieOf
import rasterlab.grader.course.Name
import rasterlab.grader.course.Staff
import rasterlab.grader.course.StaffRole
import rasterlab.grader.field
import rasterlab.grader.json
import rasterlab.grader.list
import rasterlab.grader.one
import rasterlab.grader.sendForm
import rasterlab.grader.text
import java.nio.file.Path
import java.time.InstantSource
import java.util.concurrent.CountDownLatch
import java.util.concurrent.atomic.AtomicInteger

/** A student complains about the result for a case, and staff answer, over HTTP and on the pages. */
@Tag("slow")
class ComplaintsTest {
    @TempDir
    lateinit var folder: Path

    @Test
    @DisplayName("a complaint does not wait for staff, its answer is not read, or it is answered twice")
    fun aComplaintIsAnsweredOnce() =
        Classroom(folder).open {
            val course = newCourse()
            val student = newStudent(course)
            val id = graded(student)
            val grace = newAssistant()
            val opened = complain(id, CASE, student).json()
            val told = listOf("case", "state", "answer", "current").map(opened::text)
            assertEquals(listOf("open-case", "open", "null", "true"), told)
            assertEquals(listOf("Ada draw-dot 1 It is drawn."), waiting(course, "open"))
            assertEquals(emptyList<String>(), waiting(course, "settled"))
            val answered = answer(id, opened.text("id"), """{"state":"declined","text":"It is not."}""", grace).json()
            assertEquals(
                listOf("declined", "It is not.", "Grace", "null"),
                listOf("state", "answer", "answeredBy", "regrade").map(answered::text),
            )
            assertEquals(listOf("declined It is not."), read(id, student))
            assertEquals(listOf("Ada draw-dot 1 It is drawn."), waiting(course, "settled"))
            answer(id, opened.text("id"), ACCEPTED, instructor).assertProblem(422, "bad-complaint")
            assertEquals(
                "complaint-decline $id open-case",
                one("SELECT action || ' ' || subject || ' ' || detail FROM audit WHERE action LIKE 'complaint%'"),
            )
        }

    @Test
    @DisplayName("a result is complained of twice, a passed or unknown case is, or a repeated request complains again")
    fun aResultIsComplainedOfOnce() =
        Classroom(folder, grading = halfRight()).open {
            val student = newStudent()
            val id = graded(student)
            val made = List(2) { complain(id, CASE, student, key = "once").json().text("id") }
            assertEquals(made[0], made[1])
            complain(id, CASE, student).assertProblem(422, "bad-complaint")
            complain(id, """{"case":"right-case","text":"x"}""", student).assertProblem(422, "bad-complaint")
            complain(id, """{"case":"none","text":"x"}""", student).assertProblem(422, "bad-complaint")
            complain(id, """{"case":"open-case","text":""}""", student).assertProblem(422, "bad-comment")
            complain(id, """{"case":"open-case"}""", student).assertProblem(400, "malformed-request")
            complain(id, CASE, instructor).assertProblem(403, "wrong-role")
            assertEquals("1", one("SELECT count(*) FROM complaints"))
        }

    @Test
    @DisplayName("another student reads a complaint or writes one, or staff find it with another submission")
    fun anotherStudentsComplaintIsUnknown() =
        Classroom(folder).open {
            val course = newCourse()
            val (student, other) = List(2) { newStudent(course) }
            val id = graded(student)
            val complaint = complain(id, CASE, student).json().text("id")
            look(other, address(id)).assertProblem(404, "unknown-submission")
            complain(id, CASE, other).assertProblem(404, "unknown-submission")
            answer(id, complaint, ACCEPTED, student).assertProblem(403, "wrong-role")
            answer(graded(other), complaint, ACCEPTED, instructor).assertProblem(404, "unknown-complaint")
            look(instructor, "/api/v1/courses/${newCourse()}/complaints").json().also {
                assertEquals(0, it.list("complaints").size)
            }
        }

    @Test
    @DisplayName("an accepted complaint grades nothing again, more than its case, or an assistant begins that")
    fun whatIsAcceptedIsGradedAgain() {
        val times = AtomicInteger()
        val grading =
            Grading { _, source, _, _ ->
                if ("mine" in source && times.getAndIncrement() > 0) allRight() else Classroom.wrongReport()
            }
        Classroom(folder, grading = grading).open {
            val course = newCourse()
            val student = newStudent(course)
            val id = graded(student, "class Dot { int mine; }")
            graded(newStudent(course))
            val complaint = complain(id, CASE, student).json().text("id")
            answer(id, complaint, AGAIN, newAssistant()).assertProblem(403, "wrong-role")
            answer(id, complaint, AGAIN.replace("accepted", "declined"), instructor).assertProblem(422, "bad-complaint")
            val answered = answer(id, complaint, AGAIN, instructor).json()
            look(instructor, "/api/v1/regrades/${answered.text("regrade")}/events").bodyAsText()
            assertEquals(listOf("accepted Yes."), read(id, student))
            val result = look(student, "/api/v1/submissions/$id").json()
            assertEquals("7", result.getValue("points").jsonObject.text("total"))
            assertEquals(
                listOf("OK 5", "WRONG 2"),
                result.list("cases").map {
                    "${it.field("verdict")} ${it.field("points")}".uppercase()
                },
            )
            assertEquals("1", one("SELECT count(*) FROM regrade_items"))
            assertEquals(
                "open-case",
                look(
                    instructor,
                    "/api/v1/regrades/${answered.text("regrade")}",
                ).json().getValue("regrade").field("case"),
            )
            val cookie = cookieOf(instructor)
            val audit = client.get("/instructor/audit?lang=en") { header(HttpHeaders.Cookie, cookie) }.bodyAsText()
            assertTrue("chosen ones, submissions: 1, just one case: one pixel" in audit, audit)
            assertEquals("accepted", all(id, student).single().field("regradeState"))
            assertEquals("false", all(id, student).single().field("current"))
            assertEquals(201, complain(id, CASE.replace("open-case", "hidden-case"), student).status.value)
        }
    }

    @Test
    @DisplayName("one of two complaints has to wait for the regrade of the other, or takes its points back")
    fun twoCasesAreGradedAgainAtOnce() {
        val times = AtomicInteger()
        val bothAreAnswered = CountDownLatch(1)
        val grading =
            Grading { _, _, _, _ ->
                if (times.getAndIncrement() == 0) {
                    Classroom.wrongReport()
                } else {
                    bothAreAnswered.await()
                    allRight()
                }
            }
        Classroom(folder, grading = grading, exercise = ofTwoCases()).open {
            val student = newStudent()
            val id = graded(student)
            val bodies = listOf(CASE, CASE.replace("open-case", "hidden-case"))
            val complaints = bodies.map { complain(id, it, student).json().text("id") }
            val regrades = complaints.map { answer(id, it, AGAIN, instructor).json().text("regrade") }
            bothAreAnswered.countDown()
            regrades.forEach { look(instructor, "/api/v1/regrades/$it/events").bodyAsText() }
            val result = look(student, "/api/v1/submissions/$id").json()
            assertEquals("10", result.getValue("points").jsonObject.text("total"))
            val page = show("/instructor/regrades/${regrades[0]}", instructor)
            assertTrue("Chosen: the case “one pixel” alone." in page, page)
            val list =
                show("/instructor/courses/${one("SELECT id FROM courses")}/exercises/draw-dot/regrade", instructor)
            assertTrue("the case “one pixel” alone" in list, list)
        }
    }

    @Test
    @DisplayName(
        "a page does not show the form below the failed case, its words are markup, or they are lost when refused",
    )
    fun complaintsStandBelowTheirCase() =
        Classroom(folder, grading = halfRight()).open {
            val course = newCourse()
            val student = newStudent(course)
            val id = graded(student)
            val page = "/submissions/$id"
            assertEquals(1, show(page, student).split(FORM).size - 1)
            assertFalse(FORM in show(page, instructor))
            val refused = sendForm("$page/complaints?lang=en", "case=open-case&text=" + "x".repeat(2001), student)
            assertEquals(422, refused.status.value)
            assertTrue("x".repeat(2001) + "</textarea>" in refused.bodyAsText())
            assertEquals(
                302,
                sendForm("$page/complaints", "case=open-case&text=%3Cb%3Eno%3C/b%3E", student).status.value,
            )
            val complaint = one("SELECT id FROM complaints")
            for (shown in listOf(show(page, student), show(page, instructor), show("$page/fragment", student))) {
                assertTrue("""id="complaint-$complaint"""" in shown && "&lt;b&gt;no&lt;/b&gt;" in shown, shown)
            }
            assertFalse(FORM in show(page, student))
            val list = "/instructor/courses/${one("SELECT id FROM courses")}/complaints"
            assertTrue("Complaints (1)" in show("/instructor", instructor))
            assertTrue("""href="$page#complaint-$complaint"""" in show(list, instructor))
            assertFalse("name=\"regrade\"" in show(list, newAssistant()))
            val answered = sendForm("$page/complaints/$complaint", "state=accepted&text=Yes&list=$course", instructor)
            assertEquals(list, answered.headers[HttpHeaders.Location])
            assertTrue("Принята" in show("$page?lang=ru", student))
            assertTrue("No complaint waits." in show(list, instructor))
        }

    /** Both cases are right, so that a look at what counts tells how many were graded again. */
    private fun allRight(): Report {
        val cases =
            listOf("open-case" to Disclosure.OPEN, "hidden-case" to Disclosure.VERDICT_ONLY).map { (name, visibility) ->
                CaseReport(name, visibility, GradingVerdict.OK, 5, 5, Message.NONE, emptyList(), "")
            }
        return Report(GradingVerdict.OK, ScorePoints(5, 5, 0, 10), cases, emptyList(), Report.BUBBLEWRAP, 0.0)
    }

    private fun ofTwoCases(): Exercise {
        val one = Classroom.EXERCISE
        val open = one.cases().single()
        val hidden =
            Exercise.Case("hidden-case", open.title(), open.kind(), Disclosure.VERDICT_ONLY, 5, open.input(), false)
        return Exercise(
            one.id(),
            one.topic(),
            one.title(),
            one.statement(),
            emptyMap(),
            one.starter(),
            one.revision(),
            one.tolerance(),
            one.points(),
            listOf(open, hidden),
        )
    }

    private fun halfRight() =
        Grading { _, _, _, _ ->
            val report = Classroom.wrongReport()
            val cases =
                listOf(GradingVerdict.WRONG, GradingVerdict.OK).zip(report.cases()).map { (verdict, case) ->
                    val right = verdict == GradingVerdict.OK
                    CaseReport(
                        if (right) "right-case" else case.name(),
                        case.visibility(),
                        verdict,
                        if (right) 5 else 0,
                        5,
                        case.explanation(),
                        emptyList(),
                        "",
                    )
                }
            Report(
                report.verdict(),
                report.points(),
                cases,
                emptyList(),
                report.isolation(),
                report.nanosPerItem(),
            )
        }

    private suspend fun Visit.graded(
        student: String,
        source: String = "class Dot {}",
    ): String = submit(student, source).json().text("id").also { eventsToTheEnd(student, it) }

    private fun Visit.newAssistant(): String =
        Staff(database, InstantSource.system())
            .add(Name.of("Grace"), StaffRole.ASSISTANT, by = "test", key = null)
            .token

    private fun address(submission: String) = "/api/v1/submissions/$submission/complaints"

    private suspend fun Visit.complain(
        submission: String,
        body: String,
        by: String,
        key: String? = null,
    ): HttpResponse =
        client.post(address(submission)) {
            bearer(by)
            key?.let { header("Idempotency-Key", it) }
            json(body)
        }

    private suspend fun Visit.answer(
        submission: String,
        complaint: String,
        body: String,
        by: String,
    ): HttpResponse =
        client.patch("${address(submission)}/$complaint") {
            bearer(by)
            json(body)
        }

    private suspend fun Visit.all(
        submission: String,
        by: String,
    ) = Json.parseToJsonElement(look(by, address(submission)).bodyAsText()).jsonArray

    private suspend fun Visit.read(
        submission: String,
        by: String,
    ): List<String> = all(submission, by).map { "${it.field("state")} ${it.field("answer")}" }

    private suspend fun Visit.waiting(
        course: String,
        state: String,
    ): List<String> =
        look(instructor, "/api/v1/courses/$course/complaints?state=$state").json().list("complaints").map { one ->
            val said = one.jsonObject.getValue("complaint").field("text")
            (listOf("student", "exercise", "attempt").map(one::field) + said).joinToString(" ")
        }

    private suspend fun Visit.show(
        path: String,
        by: String,
    ): String {
        val cookie = cookieOf(by)
        val asked = if ("lang=" in path) path else "$path?lang=en"
        return client.get(asked) { header(HttpHeaders.Cookie, cookie) }.bodyAsText()
    }

    private companion object {
        const val CASE = """{"case":"open-case","text":"It is drawn."}"""
        const val ACCEPTED = """{"state":"accepted","text":"Yes."}"""
        const val AGAIN = """{"state":"accepted","text":"Yes.","regrade":true}"""
        const val FORM = "Complain about this result"
    }
}
