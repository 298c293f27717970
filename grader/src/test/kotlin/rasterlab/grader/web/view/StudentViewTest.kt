package rasterlab.grader.web.view

import io.ktor.client.request.get
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
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.cookieOf
import rasterlab.grader.json
import rasterlab.grader.one
import rasterlab.grader.text
import java.nio.file.Path

/** Staff see the pages as a student has them. */
@Tag("slow")
class StudentViewTest {
    @TempDir
    lateinit var folder: Path

    @Test
    @DisplayName("staff see more than the student, something else, or no longer their own pages")
    fun staffSeeWhatTheStudentSees() =
        Classroom(folder).open {
            val course = newCourse()
            val (ada, other) = List(2) { newStudent(course) }
            val (id, theirs) = listOf(ada, other).map { graded(it) }
            val student = one("SELECT id FROM students WHERE number = 1")
            val own = cookieOf(instructor)
            val begun = send("/instructor/students/$student/view", own, "submission=$id")
            assertEquals("/submissions/$id", begun.headers[HttpHeaders.Location])
            val cookie =
                "$own; " +
                    begun.headers
                        .getAll(HttpHeaders.SetCookie)
                        .orEmpty()
                        .last()
                        .substringBefore(';')
            for (path in listOf("/submissions/$id", "/exercises", "/exercises/draw-dot", "/exercises/draw-dot/front")) {
                assertEquals(
                    withoutKeys(page(path, cookieOf(ada))),
                    withoutKeys(page(path, cookie)).replace(BANNER, ""),
                    path,
                )
            }
            assertTrue("You see the pages as Ada has them." in page("/submissions/$id", cookie).bodyAsText())
            assertTrue("hidden-case/actual.png" in page("/submissions/$id", own).bodyAsText())
            assertEquals(404, page("/submissions/$theirs", cookie).status.value)
            assertEquals(200, page("/instructor/students/$student", cookie).status.value)
            assertEquals("1", one("SELECT count(*) FROM audit WHERE action = 'view' AND subject = '$student'"))
            val ended = send("/instructor/view/end", cookie, "")
            assertEquals("/instructor/students/$student", ended.headers[HttpHeaders.Location])
            assertTrue(
                ended.headers
                    .getAll(HttpHeaders.SetCookie)
                    .orEmpty()
                    .any { "Max-Age=0" in it },
            )
        }

    @Test
    @DisplayName("staff change something in a student's place, or a student gets another's view")
    fun nothingIsChangedInTheStudentsPlace() =
        Classroom(folder).open {
            val course = newCourse()
            val (ada, other) = List(2) { newStudent(course) }
            val id = graded(ada)
            val student = one("SELECT id FROM students WHERE number = 1")
            val view = "; rasterlab-view=$student"
            val staff = cookieOf(instructor) + view
            val forms =
                listOf(
                    "/submissions/$id/comments" to "text=x",
                    "/submissions/$id/complaints" to "case=open-case&text=x",
                    "/exercises/draw-dot" to "",
                    "/exercises/draw-dot/front" to "named=yes",
                    "/exercises/draw-dot/hints" to "step=1",
                    "/chosen" to "submission=$id",
                    "/exams/none/open" to "",
                )
            for ((path, body) in forms) assertEquals(403, send(path, staff, body).status.value, path)
            assertEquals(403, page("/exams/none", staff).status.value)
            assertEquals(
                "1 0 0",
                one(
                    "SELECT (SELECT count(*) FROM submissions) || ' ' || (SELECT count(*) FROM comments) || ' ' || (SELECT sum(named_on_front) FROM students)",
                ),
            )
            assertEquals(404, page("/submissions/$id", cookieOf(other) + view).status.value)
            assertEquals(401, page("/submissions/$id", view.removePrefix("; ")).status.value)
            assertEquals(403, send("/instructor/students/$student/view", cookieOf(ada), "").status.value)
            assertEquals(404, send("/instructor/students/none/view", staff, "").status.value)
            assertEquals(200, page("/submissions/$id", cookieOf(instructor) + "; rasterlab-view=none").status.value)
        }

    private suspend fun Visit.graded(student: String): String =
        submit(student).json().text("id").also { eventsToTheEnd(student, it) }

    /** Each form has a key of its own each time. */
    private suspend fun withoutKeys(answer: HttpResponse) =
        answer.bodyAsText().replace(Regex("name=\"once\" value=\"[^\"]*\""), "")

    private suspend fun Visit.page(
        path: String,
        cookie: String,
    ): HttpResponse = client.get("$path?lang=en") { header(HttpHeaders.Cookie, cookie) }

    private suspend fun Visit.send(
        path: String,
        cookie: String,
        body: String,
    ): HttpResponse =
        client.post(path) {
            header(HttpHeaders.Cookie, cookie)
            header(HttpHeaders.Host, "localhost")
            header(HttpHeaders.Origin, "http://localhost")
            header(HttpHeaders.ContentType, "application/x-www-form-urlencoded")
            setBody(body)
        }

    private companion object {
        val BANNER = Regex("""\s*<div class="viewing".*?</div>""", RegexOption.DOT_MATCHES_ALL)
    }
}
