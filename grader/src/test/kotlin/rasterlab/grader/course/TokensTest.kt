package rasterlab.grader.course

import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.post
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.jsonArray
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.assertProblem
import rasterlab.grader.bearer
import rasterlab.grader.commandLine
import rasterlab.grader.field
import rasterlab.grader.json
import rasterlab.grader.one
import rasterlab.grader.text
import java.io.PrintWriter
import java.io.StringWriter
import java.nio.file.Path
import java.time.InstantSource

/** Who lost a token gets another, and the lost one opens nothing. */
@Tag("slow")
class TokensTest {
    @TempDir
    lateinit var folder: Path

    @Test
    @DisplayName("a student's new token is none, or the lost one still lets in")
    fun anInstructorMakesAStudentsNewToken() =
        Classroom(folder).open(grades = false) {
            val lost = newStudent()
            val accounts = Accounts(database, InstantSource.system())
            val session = accounts.open(checkNotNull(accounts.holder(lost)))
            val answer = renew(studentId(), instructor)
            assertEquals(201, answer.status.value, answer.bodyAsText())
            val token = answer.json().text("token")
            assertEquals(200, look(token, "/api/v1/exercises").status.value)
            look(lost, "/api/v1/exercises").assertProblem(401, "not-signed-in")
            assertEquals(null, accounts.inSession(session), "the session that the lost token opened goes on")
        }

    @Test
    @DisplayName("repeating a request makes a second token")
    fun aRepeatedRequestGetsTheSameToken() =
        Classroom(folder).open(grades = false) {
            newStudent()
            val tokens = List(2) { renew(studentId(), instructor, key = "k1").json().text("token") }
            assertEquals(tokens[0], tokens[1])
            assertNotEquals(tokens[0], renew(studentId(), instructor, key = "k2").json().text("token"))
        }

    @Test
    @DisplayName("a student makes tokens, or a student who does not exist gets one")
    fun tokensAreTheInstructorsToMake() =
        Classroom(folder).open(grades = false) {
            val student = newStudent()
            renew(studentId(), student).assertProblem(403, "wrong-role")
            renew("nobody", instructor).assertProblem(404, "unknown-student")
            val students = look(instructor, "/api/v1/courses/${courseId()}/students")
            val listed = Json.parseToJsonElement(students.bodyAsText()).jsonArray
            assertEquals(listOf(studentId() to "Ada"), listed.map { it.field("student") to it.field("name") })
            look(student, "/api/v1/courses/${courseId()}/students").assertProblem(403, "wrong-role")
            look(instructor, "/api/v1/courses/none/students").assertProblem(404, "unknown-course")
        }

    @Test
    @DisplayName("the course desk has no button for a new token, or any site can press it")
    fun theCourseDeskMakesTokensToo() =
        Classroom(folder).open(grades = false) {
            val lost = newStudent()
            val accounts = Accounts(database, InstantSource.system())
            val cookie = "rasterlab=${accounts.open(checkNotNull(accounts.holder(instructor)))}"
            val form = "/instructor/students/${studentId()}/token"
            assertTrue(form in client.get("/instructor") { header(HttpHeaders.Cookie, cookie) }.bodyAsText())
            val foreign =
                client.post(form) {
                    header(HttpHeaders.Cookie, cookie)
                    header(HttpHeaders.Host, "localhost")
                    header(HttpHeaders.Origin, "http://elsewhere.invalid")
                }
            assertEquals(403, foreign.status.value)
            assertEquals(200, look(lost, "/api/v1/exercises").status.value)
            val page =
                client
                    .post(form) {
                        header(HttpHeaders.Cookie, cookie)
                        header(HttpHeaders.Host, "localhost")
                        header(HttpHeaders.Origin, "http://localhost")
                    }.bodyAsText()
            val token = checkNotNull(Regex("""<code class="token">([^<]+)""").find(page)) { page }.groupValues[1]
            assertEquals(200, look(token, "/api/v1/exercises").status.value)
            look(lost, "/api/v1/exercises").assertProblem(401, "not-signed-in")
        }

    @Test
    @DisplayName("an instructor who lost the token is shut out for good")
    fun theInstructorsTokenIsRenewedOnTheServersMachine() =
        Classroom(folder).open(grades = false) {
            newStudent()
            val printed = token()
            val token = printed.removePrefix("instructor token: ").trim()
            assertEquals("instructor token: $token", printed.trim())
            assertEquals(200, look(token, "/api/v1/courses/${courseId()}/students").status.value)
            look(instructor, "/api/v1/courses/${courseId()}/students").assertProblem(401, "not-signed-in")
            val students = token(studentId()).trim()
            assertTrue(students.startsWith("student token: "), students)
            assertEquals(200, look(students.substringAfter(": "), "/api/v1/exercises").status.value)
            assertTrue("no student has the id 'nobody'" in token("nobody", exit = 2))
        }

    private fun token(
        vararg who: String,
        exit: Int = 0,
    ): String {
        val printed = StringWriter()
        val commands = commandLine().setOut(PrintWriter(printed, true)).setErr(PrintWriter(printed, true))
        val database = "sqlite:${folder.resolve("test.db")}"
        assertEquals(exit, commands.execute("token", *who, "--db", database), "$printed")
        return "$printed"
    }

    private suspend fun Visit.renew(
        student: String,
        by: String,
        key: String? = null,
    ) = client.post("/api/v1/students/$student/token") {
        bearer(by)
        key?.let { header("Idempotency-Key", it) }
    }

    private fun Visit.studentId() = one("SELECT id FROM students")

    private fun Visit.courseId() = one("SELECT id FROM courses")
}
