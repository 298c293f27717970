package rasterlab.grader.problem

import io.ktor.client.request.delete
import io.ktor.client.request.header
import io.ktor.client.request.post
import io.ktor.client.request.setBody
import io.ktor.client.statement.HttpResponse
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.async
import kotlinx.coroutines.awaitAll
import kotlinx.coroutines.withContext
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.jsonObject
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.Wire
import rasterlab.grader.api.describedApi
import rasterlab.grader.assertProblem
import rasterlab.grader.bearer
import rasterlab.grader.field
import rasterlab.grader.json
import rasterlab.grader.list
import rasterlab.grader.one
import rasterlab.grader.text
import java.nio.file.Path

/** A request that is sent again with its key is done once, and answered as before. */
@Tag("slow")
class RepeatedRequestsTest {
    @TempDir
    lateinit var folder: Path

    @Test
    @DisplayName("a roster sent again answers without tokens or corrections, adds somebody, or takes another's key")
    fun aRosterIsAnsweredAgain() =
        Classroom(folder).open(grades = false) {
            val path = "/api/v1/courses/${newCourse()}/roster"
            roster(path, "Name,ID number,Email\nAda,17,ada@example.org\nEve,18,\n", key = null)
            val second = "Name,ID number,Marks\nAda King,17,5\nGrace,19,\nAlan,20,\n"
            assertEquals(
                List(2) { "null" },
                roster("$path?dry=true", second).json().list("added").map { it.field("token") },
            )
            val answers = List(2) { roster(path, second).bodyAsText() }
            assertEquals(answers[0], answers[1])
            val change = roster(path, second).json()
            assertEquals(listOf("Grace", "Alan"), change.list("added").map { it.field("name") })
            for (added in change.list("added")) {
                assertEquals(200, look(added.field("token"), "/api/v1/exercises").status.value)
            }
            assertEquals(listOf("Ada Ada King ada@example.org"), change.list("corrected").map(::corrected))
            assertEquals(
                "4 2",
                one("SELECT count(*) || ' ' || (SELECT count(*) FROM audit WHERE action = 'roster') FROM students"),
            )
            roster(path, "Name\nBob\n").assertProblem(422, "idempotency-key-reused")
            val gone = change.list("missing")[0].field("student")
            assertEquals("1", one("SELECT count(*) FROM idempotency_keys WHERE owner LIKE 'roster %'"))
            client.delete("/api/v1/students/$gone") { bearer(instructor) }
            assertEquals("0", one("SELECT count(*) FROM idempotency_keys WHERE owner LIKE 'roster %'"))
        }

    @Test
    @DisplayName("a key without a character is taken for none")
    fun anEmptyKeyIsRefused() =
        Classroom(folder).listen {
            val course = """{"name":"Graphics"}""".toByteArray()
            val headers = arrayOf(Wire.JSON, "Idempotency-Key: ")
            assertEquals(422, course(course, *headers).statusCode())
            assertEquals(201, course(course, headers.first()).statusCode())
        }

    @Test
    @DisplayName("requests of one key that come at once make something twice, or one of them fails")
    fun whatComesAtOnceIsDoneOnce() =
        Classroom(folder).open(grades = false) {
            val course = newCourse()
            val exams = atOnce { send("/api/v1/courses/$course/exams", EXAM) }
            assertEquals(List(SENDERS) { 201 }, exams.map { it.status.value })
            assertEquals(1, exams.map { it.bodyAsText() }.distinct().size)
            val rosters = atOnce { roster("/api/v1/courses/$course/roster", "Name\nAda\nEve\n") }
            assertEquals(1, rosters.map { it.bodyAsText() }.distinct().size)
            assertEquals("1 2", one("SELECT (SELECT count(*) FROM exams) || ' ' || count(*) FROM students"))
        }

    private suspend fun atOnce(request: suspend () -> HttpResponse): List<HttpResponse> =
        withContext(Dispatchers.IO) { List(SENDERS) { async { request() } }.awaitAll() }

    @Test
    @DisplayName("an exam, a platform or a key is made twice, or answered otherwise when it is asked for again")
    fun othersAreMadeOnce() =
        Classroom(folder).open(grades = false) {
            val exams = "/api/v1/courses/${newCourse()}/exams"
            assertEquals(1, List(2) { send(exams, EXAM).bodyAsText() }.distinct().size)
            assertEquals(1, List(2) { send("/api/v1/lti/platforms", PLATFORM).bodyAsText() }.distinct().size)
            val keys = List(3) { send("/api/v1/lti/key", body = null, if (it < 2) "a" else "b").bodyAsText() }
            assertEquals(2, keys.distinct().size)
            assertEquals(
                "1 1",
                one("SELECT (SELECT count(*) FROM exams) || ' ' || (SELECT count(*) FROM lti_platforms)"),
            )
            send(exams, EXAM.replace("30", "40")).assertProblem(422, "idempotency-key-reused")
            send("/api/v1/lti/platforms", PLATFORM.replace("Moodle", "M")).assertProblem(422, "idempotency-key-reused")
            val platform = send("/api/v1/lti/platforms", PLATFORM).json().text("platform")
            client.delete("/api/v1/lti/platforms/$platform") { bearer(instructor) }
            send("/api/v1/lti/platforms", PLATFORM).assertProblem(404, "unknown-platform")
        }

    @Test
    @DisplayName("a decision on a regrade that is sent again is refused, or done twice")
    fun aDecisionIsAnsweredAgain() =
        Classroom(folder).open {
            val course = newCourse()
            val student = newStudent(course)
            eventsToTheEnd(student, submit(student).json().text("id"))
            val begun = send("/api/v1/courses/$course/exercises/draw-dot/regrade?dry=true", "{}").json().text("regrade")
            look(instructor, "/api/v1/regrades/$begun/events").bodyAsText()
            for (word in listOf("accept", "undo")) {
                val answers = List(2) { send("/api/v1/regrades/$begun/$word", body = null, key = word) }
                assertEquals(listOf(200, 200), answers.map { it.status.value })
                assertEquals(answers[0].bodyAsText(), answers[1].bodyAsText())
                assertEquals("1", one("SELECT count(*) FROM audit WHERE action = 'regrade-$word'"))
            }
            send("/api/v1/regrades/$begun/accept", body = null, key = "undo")
                .assertProblem(422, "idempotency-key-reused")
            send("/api/v1/regrades/$begun/undo", body = null, key = "another").assertProblem(409, "regrade-stands")
        }

    @Test
    @DisplayName("a request that makes something takes no key")
    fun whateverMakesSomethingTakesAKey() =
        Classroom(folder).open(grades = false) {
            val api = describedApi()
            val without =
                api.paths
                    .mapValues { it.value.jsonObject["post"]?.jsonObject }
                    .filter { (path, post) -> post != null && "Idempotency-Key" !in api.parameters(path, "post") }
            assertEquals(CHANGES_ONLY, without.keys)
            val made =
                without.filterValues { post ->
                    post
                        ?.get("responses")
                        ?.jsonObject
                        .orEmpty()
                        .keys
                        .any { it in MADE }
                }
            assertEquals(emptySet<String>(), made.keys)
        }

    private fun corrected(one: JsonElement) = listOf("from", "to", "email").joinToString(" ") { one.field(it) }

    private suspend fun Visit.roster(
        path: String,
        text: String,
        key: String? = "roster",
    ): HttpResponse =
        client.post(path) {
            bearer(instructor)
            header(HttpHeaders.ContentType, "text/csv")
            key?.let { header("Idempotency-Key", it) }
            setBody(text)
        }

    private suspend fun Visit.send(
        path: String,
        body: String?,
        key: String = "key",
    ): HttpResponse =
        client.post(path) {
            bearer(instructor)
            header("Idempotency-Key", key)
            body?.let { json(it) }
        }

    private companion object {
        const val SENDERS = 2
        val MADE = setOf("201", "202")

        /** The calls that leave the same behind when they are done twice, or are refused the second time. */
        val CHANGES_ONLY =
            listOf("drain", "resume").map { "/api/v1/workers/{worker}/$it" }.toSet() +
                "/api/v1/courses/{course}/lti/scores/send" +
                "/api/v1/submissions/{id}/comments/{comment}/answered" +
                "/api/v1/exams/{exam}/students/{student}/release"

        const val EXAM =
            """{"name":"Exam","exercises":["draw-dot"],"opens":"2037-03-01T10:00","closes":"2037-03-01T12:00",
               "minutes":30,"grace":30}"""

        const val PLATFORM =
            """{"name":"Moodle","issuer":"https://moodle.example.org","clientId":"d","deployment":"1",
               "loginUrl":"https://moodle.example.org/a","tokenUrl":"https://moodle.example.org/t",
               "keysUrl":"https://moodle.example.org/k"}"""
    }
}
