package rasterlab.grader.problem

import io.ktor.client.request.forms.FormPart
import io.ktor.client.request.forms.MultiPartFormDataContent
import io.ktor.client.request.forms.formData
import io.ktor.client.request.header
import io.ktor.client.request.request
import io.ktor.client.request.setBody
import io.ktor.client.request.url
import io.ktor.client.statement.HttpResponse
import io.ktor.http.HttpHeaders
import io.ktor.http.HttpMethod
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.Arguments
import org.junit.jupiter.params.provider.Arguments.argumentSet
import org.junit.jupiter.params.provider.CsvSource
import org.junit.jupiter.params.provider.MethodSource
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.assertProblem
import rasterlab.grader.bearer
import rasterlab.grader.json
import rasterlab.grader.submission.LONGEST_SOURCE_BYTES
import rasterlab.grader.text
import java.nio.charset.Charset
import java.nio.file.Path
import kotlin.text.Charsets.ISO_8859_1
import kotlin.text.Charsets.UTF_16LE

private typealias Ask = suspend Visit.() -> HttpResponse

@Tag("slow")
class ProblemsTest {
    @TempDir
    lateinit var folder: Path

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("requests")
    fun answersWithAProblem(
        status: Int,
        type: String,
        ask: Ask,
    ) = Classroom(folder).open(grades = false) { ask().assertProblem(status, type) }

    @ParameterizedTest(name = "{0} {1} is not there")
    @CsvSource(
        "DELETE, /api/v1/submissions/x, GET",
        "PATCH, /api/v1/exercises/draw-dot/submissions, POST",
        "GET, /api/v1/exercises/draw-dot/submissions, POST",
        "POST, /api/v1/exercises/draw-dot/statement, GET",
        "PUT, /api/v1/join, POST",
        "DELETE, /api/v1/submissions/x/cases/y/z.png, GET",
        "POST, /healthz, GET",
    )
    fun namesTheMethodsOfAPath(
        method: String,
        path: String,
        allowed: String,
    ) = Classroom(folder).open(grades = false) {
        val answer = send(HttpMethod(method), path, newStudent())
        answer.assertProblem(405, "method-not-allowed")
        assertEquals(allowed, answer.headers[HttpHeaders.Allow])
    }

    @Test
    fun namesAllMethodsOfAPage() =
        Classroom(folder).open(grades = false) {
            val answer = send(HttpMethod.Delete, "/exercises/draw-dot", null)
            assertEquals(405, answer.status.value)
            assertEquals("GET, POST", answer.headers[HttpHeaders.Allow])
        }

    @Test
    fun tellsWhatAnAnswerAcceptsAndWhere() =
        Classroom(folder).open(grades = false) {
            suspend fun detail(answer: HttpResponse) = answer.json().text("detail")
            assertEquals(
                "the body is not JSON: line 1, column 19: Duplicate field 'name'",
                detail(course("""{"name":"a","name":"b"}""")),
            )
            assertEquals("the body, field 'name' is missing", detail(course("{}")))
            assertEquals(
                "the body, field 'nick' is not known here; known are [name]",
                detail(course("""{"name":"a","nick":"b"}""")),
            )
            assertEquals(
                "the body, field 'name' must be a text that is not blank, got 7",
                detail(course("""{"name":7}""")),
            )
            assertTrue("byte 10 of 12 is 0xE9" in detail(course("""{"name":"é"}""", ISO_8859_1)))
            assertTrue("en, ru" in detail(look(instructor, "/api/v1/exercises?lang=xx")))
            val short = detail(join("Ada", key = "1"))
            assertTrue("16 to 200" in short && "hard to guess" in short, short)
        }

    @Test
    fun tellsHowToSignIn() =
        Classroom(folder).open(grades = false) {
            assertNotNull(look("nobody's", "/api/v1/exercises").headers[HttpHeaders.WWWAuthenticate])
        }

    @Test
    fun tellsWhenToTryAgain() =
        Classroom(folder).open(grades = false) {
            val student = newStudent()
            val answers = List(6) { submit(student, "class Dot { int a$it; }") }
            assertEquals(listOf(202, 202, 202, 202, 202, 429), answers.map { it.status.value })
            answers.last().assertProblem(429, "too-many-queued")
            assertNotNull(answers.last().headers[HttpHeaders.RetryAfter])
        }

    @Test
    fun limitsJoining() =
        Classroom(folder, settings = rasterlab.grader.ServerSettings(entriesPerMinute = 2)).open(grades = false) {
            val code = newCourse()
            newStudent(code)
            newStudent(code)
            val third = send(HttpMethod.Post, "/api/v1/join", null) { json("""{"course":"$code","name":"Ada"}""") }
            third.assertProblem(429, "too-many-requests")
            assertNotNull(third.headers[HttpHeaders.RetryAfter])
        }

    companion object {
        private const val SUBMIT = "/api/v1/exercises/draw-dot/submissions"

        private suspend fun Visit.send(
            method: HttpMethod,
            path: String,
            token: String?,
            more: io.ktor.client.request.HttpRequestBuilder.() -> Unit = {},
        ): HttpResponse =
            client.request {
                this.method = method
                url(path)
                token?.let(::bearer)
                more()
            }

        private suspend fun Visit.upload(
            body: Any,
            type: String? = "text/x-java-source",
            path: String = SUBMIT,
        ) = send(HttpMethod.Post, path, newStudent()) {
            type?.let { header(HttpHeaders.ContentType, it) }
            setBody(body)
        }

        private suspend fun Visit.course(
            body: String,
            encoding: Charset = Charsets.UTF_8,
        ) = send(HttpMethod.Post, "/api/v1/courses", instructor) {
            header(HttpHeaders.ContentType, "application/json")
            setBody(body.toByteArray(encoding))
        }

        private suspend fun Visit.join(
            name: String,
            key: String? = null,
        ): HttpResponse {
            val code = newCourse()
            return send(HttpMethod.Post, "/api/v1/join", null) {
                json("""{"course":"$code","name":"$name"}""")
                key?.let { header("Idempotency-Key", it) }
            }
        }

        private fun asked(
            mistake: String,
            status: Int,
            type: String,
            ask: Ask,
        ): Arguments = argumentSet(mistake, status, type, ask)

        @JvmStatic
        fun requests(): List<Arguments> = requestsAnywhere() + uploads() + names()

        private fun requestsAnywhere() =
            listOf(
                asked("unknown path", 404, "not-found") { send(HttpMethod.Get, "/api/v1/nothing", null) },
                asked(
                    "wrong method",
                    405,
                    "method-not-allowed",
                ) { send(HttpMethod.Delete, "/api/v1/courses", instructor) },
                asked("language that is not spoken", 422, "unknown-language") {
                    look(instructor, "/api/v1/exercises/draw-dot/statement?lang=xx")
                },
                asked(
                    "language in capitals",
                    422,
                    "unknown-language",
                ) { look(instructor, "/api/v1/exercises?lang=RU") },
                asked("no token", 401, "not-signed-in") { send(HttpMethod.Get, "/api/v1/exercises", null) },
                asked("made-up token", 401, "not-signed-in") { send(HttpMethod.Get, "/api/v1/exercises", "abc") },
                asked("token of another scheme", 401, "not-signed-in") {
                    send(
                        HttpMethod.Get,
                        "/api/v1/exercises",
                        null,
                    ) { header(HttpHeaders.Authorization, "Basic $instructor") }
                },
                asked("broken authorization header", 401, "not-signed-in") {
                    send(
                        HttpMethod.Get,
                        "/api/v1/exercises",
                        null,
                    ) { header(HttpHeaders.Authorization, "Bearer \u007f,=") }
                },
                asked("student makes a course", 403, "wrong-role") {
                    val student = newStudent()
                    send(HttpMethod.Post, "/api/v1/courses", student) { json("""{"name":"Mine"}""") }
                },
                asked("instructor hands in", 403, "wrong-role") {
                    send(HttpMethod.Post, SUBMIT, instructor) { header(HttpHeaders.ContentType, "text/x-java-source") }
                },
                asked("unknown exercise", 404, "unknown-exercise") { look(instructor, "/api/v1/exercises/nothing") },
                asked(
                    "unknown submission",
                    404,
                    "unknown-submission",
                ) { look(instructor, "/api/v1/submissions/nothing") },
                asked("unknown course code", 404, "unknown-course") {
                    send(HttpMethod.Post, "/api/v1/join", null) { json("""{"course":"XXXXXXXX","name":"Ada"}""") }
                },
            )

        private fun uploads() =
            listOf(
                asked("source of no type", 415, "wrong-media-type") { upload("class A {}", type = null) },
                asked("source as JSON", 415, "wrong-media-type") { upload("{}", type = "application/json") },
                asked("source of 10 MB", 413, "too-large") { upload(ByteArray(10_000_000) { 'a'.code.toByte() }) },
                asked(
                    "source one byte too long",
                    413,
                    "too-large",
                ) { upload(ByteArray(LONGEST_SOURCE_BYTES + 1) { 'a'.code.toByte() }) },
                asked("empty source", 422, "empty-source") { upload("") },
                asked("source of spaces", 422, "empty-source") { upload(" \n\t ") },
                asked(
                    "source in another encoding",
                    422,
                    "not-utf-8",
                ) { upload(byteArrayOf(0x63, 0xE9.toByte(), 0x20)) },
                asked(
                    "source in Windows-1251",
                    422,
                    "not-utf-8",
                ) { upload("// рисует отрезок".toByteArray(charset("windows-1251"))) },
                asked("Kotlin by its type", 415, "kotlin") { upload("fun main() {}", type = "text/x-kotlin") },
                asked(
                    "form without a source",
                    422,
                    "empty-source",
                ) { upload(form("other", "class A {}"), type = null) },
                asked(
                    "form with a huge source",
                    413,
                    "too-large",
                ) { upload(form("source", "a".repeat(1_000_000)), type = null) },
                asked("form without its boundary inside", 400, "malformed-request") {
                    upload("--x\r\nrubbish", type = "multipart/form-data; boundary=y")
                },
                asked(
                    "form without a boundary",
                    400,
                    "malformed-request",
                ) { upload("x", type = "multipart/form-data") },
                asked("upload to an unknown exercise", 404, "unknown-exercise") {
                    upload("class A {}", path = "/api/v1/exercises/nothing/submissions")
                },
            )

        private fun names() =
            listOf(
                asked("broken JSON", 400, "malformed-request") { course("{\"name\":") },
                asked("JSON of another shape", 400, "malformed-request") { course("[1]") },
                asked("JSON without the name", 400, "malformed-request") { course("{}") },
                asked("field that comes twice", 400, "malformed-request") { course("""{"name":"a","name":"b"}""") },
                asked("field that is not known", 400, "malformed-request") { course("""{"name":"a","nam":"b"}""") },
                asked("JSON in another encoding", 400, "malformed-request") { course("""{"name":"Адá"}""", UTF_16LE) },
                asked("name in another encoding", 400, "malformed-request") { course("""{"name":"é"}""", ISO_8859_1) },
                asked("JSON of another type", 415, "wrong-media-type") {
                    send(HttpMethod.Post, "/api/v1/courses", instructor) { setBody("name=x") }
                },
                asked("JSON too large", 413, "too-large") { course("{\"name\":\"${"x".repeat(20_000)}\"}") },
                asked("empty name", 422, "bad-name") { join("  ") },
                asked("name of 81 letters", 422, "bad-name") { join("я".repeat(81)) },
                asked("name with a control character", 422, "bad-name") { join("A\\u0007da") },
                asked("name that turns the text around", 422, "bad-name") { join("A\\u202Eda") },
                asked(
                    "key that can be guessed gets a token again",
                    422,
                    "bad-idempotency-key",
                ) { join("Ada", key = "1") },
            )

        private fun form(
            field: String,
            text: String,
        ) = MultiPartFormDataContent(formData(FormPart(field, text)))
    }
}
