package rasterlab.grader.trial

import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.post
import io.ktor.client.request.setBody
import io.ktor.client.statement.HttpResponse
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
import rasterlab.exercises.score.Report
import rasterlab.exercises.score.ScorePoints
import rasterlab.exercises.score.SpeedFigures
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.assertProblem
import rasterlab.grader.bearer
import rasterlab.grader.cookieOf
import rasterlab.grader.course.Name
import rasterlab.grader.course.Staff
import rasterlab.grader.course.StaffRole
import rasterlab.grader.json
import rasterlab.grader.one
import rasterlab.grader.submission.Leases
import rasterlab.grader.submission.Reports
import rasterlab.grader.text
import java.nio.file.Path
import java.time.InstantSource
import java.util.Optional

/** Staff change a copy of a submission and run it; nothing of the student knows. */
@Tag("slow")
class TrialsTest {
    @TempDir
    lateinit var folder: Path

    /** Tells a source right that says so, with a speed. */
    private val bySource =
        Grading { _, source, _, _ ->
            val right = "right" in source
            val points = if (right) ScorePoints(6, 3, 1, 10) else ScorePoints(4, 0, 0, 10)
            val report = Classroom.report(if (right) GradingVerdict.OK else GradingVerdict.WRONG, points)
            Report(report.verdict(), points, report.cases(), emptyList(), "", 6.0)
                .with(Optional.of(SpeedFigures(6.0, 2.0, 0.5, emptyList())))
        }

    @Test
    @DisplayName("a copy changes marks, result, chart, errors, likeness, data, statistics or the list of the student")
    fun aCopyCountsNowhere() =
        Classroom(folder, bySource).open {
            val course = newCourse()
            val student = newStudent(course)
            val id = submit(student).json().text("id")
            eventsToTheEnd(student, id)
            val before = everything(course, student, id)
            val copy = run(id, "class Dot { /* right */ }", newAssistant()).json()
            assertEquals(listOf(id, "Grace"), listOf("submission", "by").map(copy::text))
            assertEquals("ok", graded(copy.text("id")))
            val result = look(instructor, "/api/v1/trials/${copy.text("id")}").json().getValue("result").jsonObject
            assertEquals("10", result.getValue("points").jsonObject.text("total"))
            assertEquals(before, everything(course, student, id))
            assertEquals("2", one("SELECT count(*) FROM results"))
            assertEquals("1", one("SELECT count(*) FROM submissions"))
        }

    /** Everything from which somebody could learn of a copy. */
    private suspend fun Visit.everything(
        course: String,
        student: String,
        id: String,
    ): List<String> {
        val own = one("SELECT id FROM students")
        val pages =
            listOf(
                student to "/api/v1/submissions/$id",
                student to "/api/v1/exercises",
                student to "/api/v1/exercises/draw-dot/front",
                instructor to "/api/v1/courses/$course/grades.csv",
                instructor to "/api/v1/courses/$course/exercises/draw-dot/errors",
                instructor to "/api/v1/courses/$course/exercises/draw-dot/front",
                instructor to "/api/v1/courses/$course/exercises/draw-dot/stuck",
                instructor to "/api/v1/exercises/draw-dot/similarity",
                instructor to "/api/v1/students/$own/export",
            )
        val metrics = client.get("/metrics").bodyAsText().lines()
        return pages.map { (by, path) -> look(by, path).bodyAsText() } +
            metrics.filter { "verdict" in it && !it.startsWith("#") && "seconds" !in it }
    }

    @Test
    @DisplayName("a student runs a copy or sees one, a repeated request runs two, or one of the staff fills the queue")
    fun copiesAreForStaff() =
        Classroom(folder, bySource).open(grades = false) {
            val student = newStudent()
            val id = submit(student).json().text("id")
            val made = List(2) { run(id, "class Dot {}", instructor, key = "once").json().text("id") }
            assertEquals(made[0], made[1])
            run(id, "class Dot {}", student).assertProblem(403, "wrong-role")
            for (path in listOf("/submissions/$id/trials", "/trials/${made[0]}", "/trials/${made[0]}/source")) {
                look(student, "/api/v1$path").assertProblem(403, "wrong-role")
            }
            run(id, "", instructor).assertProblem(422, "empty-source")
            look(instructor, "/api/v1/trials/none").assertProblem(404, "unknown-trial")
            repeat(StaffCopies.MOST_WAITING - 1) { run(id, "class Dot { int i$it; }", instructor) }
            run(id, "class Dot { int more; }", instructor).assertProblem(422, "bad-trial")
            assertEquals(202, run(id, "class Dot {}", newAssistant()).status.value)
        }

    @Test
    @DisplayName("a copy goes before what a student handed in, or is graded as the original")
    fun studentsGoFirst() =
        Classroom(folder, bySource).open(grades = false) {
            val student = newStudent()
            val id = submit(student).json().text("id")
            val copy = run(id, "class Copy {}", instructor).json().text("id")
            val clock = InstantSource.system()
            val leases = Leases(database, Reports(database), clock, clock)
            assertEquals(null, leases.trials.claimNext())
            assertEquals(id, leases.claimNext()?.submission?.id)
            val lease = checkNotNull(leases.trials.claimNext())
            assertEquals(copy to "class Copy {}", lease.submission.id to lease.submission.source)
            assertEquals(null, leases.trials.claimNext())
            leases.releaseAll()
            assertEquals(false, leases.trials.finish(lease, "r1", Classroom.wrongReport()), "the lease is lost")
        }

    @Test
    @DisplayName("the page of a copy is another text, has no way to the original, or is on the student's page")
    fun theCopyIsChangedOnItsPage() =
        Classroom(folder, bySource).open {
            val student = newStudent()
            val id = submit(student, "class Dot { int mine; }").json().text("id")
            eventsToTheEnd(student, id)
            val editor = "/instructor/submissions/$id/trials"
            assertTrue(editor in show("/submissions/$id", instructor))
            assertFalse("trials" in show("/submissions/$id", student))
            assertTrue("class Dot { int mine; }</textarea>" in show(editor, instructor))
            val sent = send(editor, "class Dot { int right; }")
            val page = checkNotNull(sent.headers[HttpHeaders.Location]) { sent.bodyAsText() }
            graded(page.substringAfterLast('/'))
            val shown = show(page, newAssistant())
            assertTrue("class Dot { int right; }</textarea>" in shown && "href=\"/submissions/$id\"" in shown, shown)
            assertTrue("/api/v1$PICTURES".replace("ID", page.substringAfterLast('/')) in shown, shown)
            assertTrue("Copy: Ada: Draw a dot, no. 1" in shown && "status ok" in shown, shown)
            assertEquals(422, send(editor, " ").status.value)
            assertTrue(page in show(editor, instructor), "the other copies")
        }

    private suspend fun Visit.send(
        path: String,
        source: String,
    ): HttpResponse {
        val cookie = cookieOf(instructor)
        return client.post(path) {
            header(HttpHeaders.Cookie, cookie)
            header(HttpHeaders.Host, "localhost")
            header(HttpHeaders.Origin, "http://localhost")
            header(HttpHeaders.ContentType, "multipart/form-data; boundary=b")
            setBody("--b\r\nContent-Disposition: form-data; name=\"source\"\r\n\r\n$source\r\n--b--\r\n")
        }
    }

    private fun Visit.newAssistant(): String =
        Staff(database, InstantSource.system())
            .add(Name.of("Grace"), StaffRole.ASSISTANT, by = "test", key = null)
            .token

    private suspend fun Visit.run(
        submission: String,
        source: String,
        by: String,
        key: String? = null,
    ): HttpResponse =
        client.post("/api/v1/submissions/$submission/trials") {
            bearer(by)
            key?.let { header("Idempotency-Key", it) }
            header(HttpHeaders.ContentType, "text/x-java-source")
            setBody(source)
        }

    /** Waits until a copy is graded, and tells its verdict. */
    private suspend fun Visit.graded(trial: String): String {
        val cookie = cookieOf(instructor)
        client.get("/instructor/trials/$trial/events") { header(HttpHeaders.Cookie, cookie) }.bodyAsText()
        return look(instructor, "/api/v1/trials/$trial")
            .json()
            .getValue("trial")
            .jsonObject
            .text("verdict")
    }

    private suspend fun Visit.show(
        path: String,
        by: String,
    ): String {
        val cookie = cookieOf(by)
        return client.get("$path?lang=en") { header(HttpHeaders.Cookie, cookie) }.bodyAsText()
    }

    private companion object {
        const val PICTURES = "/trials/ID/cases/hidden-case/actual.png"
    }
}
