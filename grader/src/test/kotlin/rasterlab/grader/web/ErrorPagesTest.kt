package rasterlab.grader.web

import io.ktor.client.request.header
import io.ktor.client.request.request
import io.ktor.client.request.setBody
import io.ktor.client.request.url
import io.ktor.client.statement.HttpResponse
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import io.ktor.http.HttpMethod
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource
import rasterlab.grader.Classroom
import rasterlab.grader.ServerSettings
import rasterlab.grader.Visit
import java.nio.file.Path

/** Checks what a browser shows when something goes wrong. */
class ErrorPagesTest {
    @TempDir
    lateinit var folder: Path

    @ParameterizedTest(name = "{0} {1}: the page for {2} does not help")
    @CsvSource(
        "GET,  /none,            404, not-found",
        "GET,  /instructor,      401, not-signed-in",
        "GET,  /join,            405, method-not-allowed",
        "POST, /join,            403, foreign-origin",
    )
    fun saysWhatHappenedAndWhatToDo(
        method: String,
        path: String,
        status: Int,
        code: String,
    ) = Classroom(folder).open(grades = false) {
        for (language in listOf("en", "ru")) {
            val answer = send(HttpMethod.parse(method), path, language)
            assertEquals(status, answer.status.value)
            assertHelps(answer, language, code)
        }
    }

    @Test
    fun tellsWhatToCheckInATokenThatIsNotKnown() =
        Classroom(folder).open(grades = false) {
            for (language in listOf("en", "ru")) {
                val answer = send(HttpMethod.Post, "/sign-in", language, form = "token=abc")
                assertEquals(401, answer.status.value)
                val page = answer.bodyAsText()
                assertTrue(PageTexts.of(language).problem("bad-token") in page, page)
                assertTrue("action=\"/sign-in\"" in page, "there is no form to try again")
            }
        }

    @Test
    fun tellsWhyAFormWasRefused() =
        Classroom(folder, settings = ServerSettings(entriesPerMinute = 4)).open(grades = false) {
            for (language in listOf("en", "ru")) {
                assertHelps(
                    send(HttpMethod.Post, "/join", language, form = "course=X&name=Ada"),
                    language,
                    "unknown-course",
                )
                val long = "token=" + "x".repeat(20_000)
                assertHelps(send(HttpMethod.Post, "/sign-in", language, form = long), language, "too-large")
            }
            assertHelps(send(HttpMethod.Post, "/join", "ru", form = "course=X"), "ru", "too-many-requests")
        }

    @Test
    fun tellsThatTheServerFailed() =
        Classroom(folder).open(grades = false) {
            database.write { it.execute("DROP TABLE sessions") }
            val answer = send(HttpMethod.Get, "/exercises", "ru", cookie = "rasterlab=x")
            assertEquals(503, answer.status.value)
            assertHelps(answer, "ru", "storage")
        }

    @Test
    fun leadsBackToThePageWithTheForm() =
        Classroom(folder).open(grades = false) {
            val page =
                send(
                    HttpMethod.Post,
                    "/join",
                    "en",
                    form = "course=X&name=A",
                    from = "http://localhost/?x",
                ).bodyAsText()
            assertTrue("<a href=\"/?lang=ru\"" in page, "the other language would ask for the form's address: $page")
            val foreign = send(HttpMethod.Get, "/none", "en", from = "http://elsewhere.example/trap").bodyAsText()
            assertFalse("trap" in foreign, foreign)
            val twice =
                send(
                    HttpMethod.Get,
                    "/none",
                    "en",
                    from = "http://localhost//elsewhere.example/",
                ).bodyAsText()
            assertFalse("href=\"//" in twice, twice)
        }

    private suspend fun assertHelps(
        answer: HttpResponse,
        language: String,
        code: String,
    ) {
        val page = answer.bodyAsText()
        assertTrue("lang=\"$language\"" in page, page)
        assertTrue(PageTexts.of(language).problem(code) in page, page)
        assertTrue("<a href=\"/\">" in page, "no way back: $page")
    }

    private suspend fun Visit.send(
        method: HttpMethod,
        path: String,
        language: String,
        form: String? = null,
        from: String? = null,
        cookie: String? = null,
    ) = client.request {
        this.method = method
        url(path)
        header(HttpHeaders.AcceptLanguage, language)
        header(HttpHeaders.Host, "localhost")
        from?.let { header(HttpHeaders.Referrer, it) }
        cookie?.let { header(HttpHeaders.Cookie, it) }
        form?.let {
            header(HttpHeaders.Origin, "http://localhost")
            header(HttpHeaders.ContentType, "application/x-www-form-urlencoded")
            setBody(it)
        }
    }
}
