package rasterlab.grader.student

import io.ktor.client.request.delete
import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.post
import io.ktor.client.request.setBody
import io.ktor.client.statement.bodyAsBytes
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
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.assertProblem
import rasterlab.grader.bearer
import rasterlab.grader.cookieOf
import rasterlab.grader.field
import rasterlab.grader.json
import rasterlab.grader.list
import rasterlab.grader.one
import rasterlab.grader.text
import java.nio.file.Path
import java.util.zip.ZipInputStream

/** The server gives out what it keeps about a student whole, and deletes it without a rest. */
@Tag("slow")
class StudentRecordsTest {
    @TempDir
    lateinit var folder: Path

    @Test
    @DisplayName("something that a student handed in is missing in the data, or what others handed in is there")
    fun givesOutEverythingOfOneStudent() =
        Classroom(folder).open {
            val (ada, student) = handedIn()
            val data = look(instructor, "/api/v1/students/$student/export").json()
            assertEquals("Ada" to "Graphics", data.text("name") to data.text("courseName"))
            val submission = data.list("submissions").single().jsonObject
            assertEquals(
                "class Dot { int mine; }" to "draw-dot",
                submission.text("source") to submission.text("exercise"),
            )
            assertEquals(
                "4",
                submission
                    .list("results")
                    .single()
                    .jsonObject
                    .text("accuracy"),
            )
            assertEquals("fine", submission.list("points").single().field("reason"))
            val said = data.list("comments").map { one -> listOf("name", "line", "lastLine", "text").map(one::field) }
            assertEquals(listOf(listOf("Ada", "1", "2", "why?"), listOf("", "null", "null", "so")), said)
            assertEquals(
                listOf("open-case" to "no"),
                data.list("complaints").map { it.field("case") to it.field("text") },
            )
            assertEquals("true", data.text("namedOnFront"))
            val files = unzipped(look(instructor, "/api/v1/students/$student/export?as=zip").bodyAsBytes())
            assertEquals(setOf("student.json", "draw-dot/attempt-1.java"), files.keys)
            assertEquals("class Dot { int mine; }", files["draw-dot/attempt-1.java"])
            assertFalse("theirs" in files.getValue("student.json"), "another's source is given out")
            assertEquals("2", one("SELECT count(*) FROM audit WHERE action = 'export' AND subject = '$student'"))
            look(instructor, "/api/v1/students/$student/export?as=pdf").assertProblem(400, "malformed-request")
            look(instructor, "/api/v1/students/nobody/export").assertProblem(404, "unknown-student")
            look(ada, "/api/v1/students/$student/export").assertProblem(403, "wrong-role")
        }

    @Test
    @DisplayName("a row about a deleted student stays, another's goes with it, or nobody notes who deleted it")
    fun deletesOneStudentWhole() =
        Classroom(folder).open {
            val (ada, student) = handedIn()
            val gone = tables().associateWith { one("SELECT count(*) FROM $it").toInt() }
            val cookie = cookieOf(ada)
            client.delete("/api/v1/students/$student") { bearer(ada) }.assertProblem(403, "wrong-role")
            assertEquals(
                "1",
                client.delete("/api/v1/students/$student") { bearer(instructor) }.json().text("submissions"),
            )
            client.delete("/api/v1/students/$student") { bearer(instructor) }.assertProblem(404, "unknown-student")
            look(ada, "/api/v1/exercises").assertProblem(401, "not-signed-in")
            assertEquals(401, client.get("/exercises") { header(HttpHeaders.Cookie, cookie) }.status.value)
            for ((table, before) in gone) {
                val left = one("SELECT count(*) FROM $table").toInt()
                assertTrue(before > 0 && left * 2 == before, "$table has $left rows of $before")
            }
            assertEquals(student, one("SELECT subject FROM audit WHERE action = 'delete'"))
            assertEquals("0", one("SELECT count(*) FROM audit WHERE detail LIKE '%Ada%'"))
        }

    @Test
    @DisplayName("a roster about another student, whose id is nearly the same, is forgotten along")
    fun keepsTheRostersOfOthers() =
        Classroom(folder).open(grades = false) {
            newStudent(newCourse())
            database.write { handle ->
                handle.execute("UPDATE students SET id = 'a_b'")
                for (id in listOf("a_b", "a-b", "a_bc")) {
                    handle.execute(
                        "INSERT INTO idempotency_keys VALUES ('roster c i', ?, '', ?, '')",
                        id,
                        """{"added":{"2":"$id"}}""",
                    )
                }
            }
            assertEquals(200, client.delete("/api/v1/students/a_b") { bearer(instructor) }.status.value)
            assertEquals("2", one("SELECT count(*) FROM idempotency_keys WHERE owner = 'roster c i'"))
            assertEquals("a-b", one("SELECT min(key_hash) FROM idempotency_keys WHERE owner = 'roster c i'"))
        }

    @Test
    @DisplayName("the page deletes unasked, gives no data, or is a student's")
    fun thePageAsksBeforeItDeletes() =
        Classroom(folder).open {
            val (ada, student) = handedIn()
            val page = "/instructor/students/$student"
            assertTrue("I delete everything of Ada." in page(page, instructor).bodyAsText(), page)
            assertTrue("int mine" in page("$page/data.json", instructor).bodyAsText())
            assertEquals(2, unzipped(page("$page/data.zip", instructor).bodyAsBytes()).size)
            assertEquals(400, send("$page/delete", "", instructor).status.value)
            assertEquals(403, send("$page/delete", "sure=yes", ada).status.value)
            for (path in listOf(page, "$page/data.json", "$page/data.zip")) {
                assertEquals(403, page(path, ada).status.value, path)
            }
            assertEquals("2", one("SELECT count(*) FROM students"))
            assertEquals(302, send("$page/delete", "sure=yes", instructor).status.value)
            assertEquals("1", one("SELECT count(*) FROM students"))
        }

    /** Two students who have everything that can be kept of one; the token and the id of the first. */
    private suspend fun Visit.handedIn(): Pair<String, String> {
        val course = newCourse()
        val tokens = listOf("mine", "theirs").map { field -> newStudent(course) to field }
        for ((token, field) in tokens) {
            eventsToTheEnd(token, submit(token, "class Dot { int $field; }", key = "once").json().text("id"))
            cookieOf(token)
        }
        database.write { handle ->
            handle.execute("INSERT INTO hints SELECT id, 'draw-dot', 1, 2, '2026-03-01T12:00:00.000Z' FROM students")
            handle.execute(
                "INSERT INTO extensions SELECT id, 'draw-dot', '2026-03-04T00:00:00.000Z', 'ill' FROM students",
            )
            handle.execute("INSERT INTO roster_fields SELECT id, 'section', '1' FROM students")
            handle.execute(
                """INSERT INTO comments (id, submission_id, line, last_line, author_id, text, written_at)
                   SELECT 'c' || id, id, 1, 2, student_id, 'why?', '2026-03-01T12:00:00.000Z' FROM submissions""",
            )
            handle.execute(
                """INSERT INTO comments (id, submission_id, thread_id, author_id, text, written_at)
                   SELECT 'd' || id, id, 'c' || id, 'i', 'so', '2026-03-01T12:00:01.000Z' FROM submissions""",
            )
            handle.execute("INSERT INTO idempotency_keys SELECT 'comments', id, '', id, '' FROM comments")
            handle.execute(
                """INSERT INTO regrades (id, course_id, exercise, revision, choice, is_dry, state, account_id, begun_at)
                   SELECT 'g', id, 'draw-dot', 'r1', 'all', 1, 'graded', 'i', '2026-03-01T12:00:00.000Z' FROM courses""",
            )
            handle.execute(
                """INSERT INTO regrade_items (regrade_id, submission_id, position, state, result_id, former_id)
                   SELECT 'g', submission_id, 1, 'done', id, id FROM results""",
            )
            handle.execute(
                """INSERT INTO adjustments (id, submission_id, points, reason, total_before, account_id, given_at)
                   SELECT 'p' || id, id, 2, 'fine', 4, 'i', '2026-03-01T12:00:00.000Z' FROM submissions""",
            )
            handle.execute(
                """INSERT INTO complaints (id, submission_id, result_id, case_name, text, opened_at)
                   SELECT 'k' || id, submission_id, id, 'open-case', 'no', '2026-03-01T12:00:00.000Z' FROM results""",
            )
            handle.execute("INSERT INTO idempotency_keys SELECT 'complaints', id, '', id, '' FROM complaints")
            handle.execute(
                """INSERT INTO trials (id, submission_id, account_id, revision, source, begun_at, state, result_id)
                   SELECT 't' || id, submission_id, 'i', 'r1', 'class Copy {}', '2026-03-01T12:00:00.000Z', 'done', NULL
                   FROM results""",
            )
            handle.execute("INSERT INTO idempotency_keys SELECT 'trials', id, '', id, '' FROM trials")
            handle.execute("UPDATE students SET named_on_front = 1 WHERE number = 1")
            handle.execute("INSERT INTO diagnostics SELECT id, 0, 1, 1, 'm', '' FROM results")
            handle.execute(
                "INSERT INTO speed_methods (result_id, position, method, ratio) SELECT id, 0, 'naive', 1.0 FROM results",
            )
        }
        return tokens.first().first to one("SELECT id FROM students WHERE number = 1")
    }

    /** The tables that have rows about students. */
    private fun tables() =
        listOf(
            "students",
            "submissions",
            "results",
            "case_results",
            "case_pictures",
            "diagnostics",
            "speed_methods",
            "hints",
            "extensions",
            "roster_fields",
            "comments",
            "complaints",
            "trials",
            "regrade_items",
            "adjustments",
            "sessions",
            "idempotency_keys",
        )

    private fun unzipped(bytes: ByteArray): Map<String, String> =
        ZipInputStream(bytes.inputStream()).use { zip ->
            generateSequence { zip.nextEntry }.associate { it.name to zip.readBytes().decodeToString() }
        }

    private suspend fun Visit.page(
        path: String,
        by: String,
    ) = cookieOf(by).let { cookie -> client.get("$path?lang=en") { header(HttpHeaders.Cookie, cookie) } }

    private suspend fun Visit.send(
        path: String,
        body: String,
        by: String,
    ) = cookieOf(by).let { cookie ->
        client.post(path) {
            header(HttpHeaders.Cookie, cookie)
            header(HttpHeaders.Host, "localhost")
            header(HttpHeaders.Origin, "http://localhost")
            header(HttpHeaders.ContentType, "application/x-www-form-urlencoded")
            setBody(body)
        }
    }
}
