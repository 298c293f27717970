package rasterlab.grader.web

import io.ktor.client.request.forms.FormPart
import io.ktor.client.request.forms.MultiPartFormDataContent
import io.ktor.client.request.forms.formData
import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.post
import io.ktor.client.request.setBody
import io.ktor.client.statement.HttpResponse
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import io.ktor.http.encodeURLParameter
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.exercises.Grading
import rasterlab.exercises.score.Disclosure
import rasterlab.exercises.score.GradingVerdict
import rasterlab.exercises.score.Report
import rasterlab.exercises.score.ScorePoints
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.bearer
import rasterlab.grader.report.CaseWords
import rasterlab.grader.report.view
import java.nio.file.Path
import java.util.Properties
import java.util.concurrent.CountDownLatch

@Tag("slow")
open class PagesTest {
    @TempDir
    lateinit var folder: Path

    @Test
    fun exercisesStandUnderTheirTopicWithTheLabThatPrepares() =
        Classroom(folder).open {
            val cookie = session(form("/join", "course" to newCourse(), "name" to "Ada"))
            val list = page("/exercises", cookie)
            val places =
                listOf("Line segments</h2>", "tab “Lines”", "Draw a dot", "not tried yet").map { list.indexOf(it) }
            assertTrue(places.all { it >= 0 } && places == places.sorted(), "$places in $list")
        }

    @Test
    fun showsWhatPeopleWroteAsText() =
        Classroom(folder).open {
            val code = newCourse()
            val joined = form("/join", "course" to code, "name" to "<b>Ada+1</b> & \"co\"")
            val cookie = session(joined)
            val exercise = page("/exercises/draw-dot", cookie)
            assertTrue(
                "&lt;b&gt;Ada+1&lt;/b&gt; &amp; &quot;co&quot;" in exercise && "<b>Ada" !in exercise,
                "the name is markup in $exercise",
            )
            assertTrue(
                "<strong>one</strong>" in exercise && "<script>alert" !in exercise,
                "the statement is markup in $exercise",
            )
            val id =
                checkNotNull(
                    handIn(cookie, "class Dot { /* </li><script>alert(2)</script> */ }").headers[HttpHeaders.Location],
                )
            eventsToTheEnd(token(joined), idOf(id))
            val result = page(id, cookie)
            assertFalse("<script>alert" in result || "<img src=x" in result, "the result has foreign markup: $result")
            assertTrue("secret of open-case &lt;img" in result, result)
            assertFalse("secret of hidden-case" in result, "a hidden case is told")
            assertTrue("columns −2..1 of −2..99, rows 1..1 of 1..1" in result, "no part is told: $result")
            assertTrue(""">#+-.</pre>""" in result, "not the rows alone: $result")
        }

    @Test
    fun tellsScriptsNoNewVerdictOfACaseThatWasNotRun() {
        val case = Classroom.case("open-case", Disclosure.OPEN, GradingVerdict.NOT_RUN)
        val view = case.view("s1", CaseWords("en", title = { "one pixel" }, reason = { null }))
        assertEquals("no_result" to false, view.verdict.code to view.verdict.run)
        assertTrue(
            Classroom
                .case("open-case", Disclosure.OPEN, GradingVerdict.WRONG)
                .view("s1", CaseWords("en", title = { "one" }, reason = { null }))
                .verdict.run,
        )
    }

    @Test
    fun tellsScriptsNoNewVerdictOfASpeedWithoutPoints() {
        val case = Classroom.case("speed", Disclosure.OPEN, GradingVerdict.TOO_SLOW)
        val view = case.view("s1", CaseWords("en", title = { "speed" }, reason = { null }))
        assertEquals("ok" to true, view.verdict.code to view.verdict.run)
    }

    @Test
    fun callsACaseThatWasNotRunSo() =
        Classroom(folder, { _, _, _, _ -> stopped() }).open {
            val joined = form("/join", "course" to newCourse(), "name" to "Ada")
            val cookie = session(joined)
            val id = checkNotNull(handIn(cookie, "class Dot {}").headers[HttpHeaders.Location])
            eventsToTheEnd(token(joined), idOf(id))
            assertTrue("</span>не запускался" in page("$id?lang=ru", cookie), page("$id?lang=ru", cookie))
        }

    /** A mistake that all cases share is known, and paid for once, only when all were tried. */
    @Test
    fun showsNoVerdictOfACaseBeforeAllAreKnown() {
        val judged = CountDownLatch(1)
        val seen = CountDownLatch(1)
        val slow =
            Grading { _, _, _, progress ->
                Classroom.wrongReport().also {
                    it.cases().forEach(progress::accept)
                    judged.countDown()
                    seen.await()
                }
            }
        Classroom(folder, slow).open {
            try {
                val joined = form("/join", "course" to newCourse(), "name" to "Ada")
                val cookie = session(joined)
                val id = checkNotNull(handIn(cookie, "class Dot {}").headers[HttpHeaders.Location])
                judged.await()
                val running = page(id, cookie)
                assertTrue("2 cases judged so far" in running, running)
                assertFalse("secret of open-case" in running, "a verdict that may change is shown: $running")
                seen.countDown()
                eventsToTheEnd(token(joined), idOf(id))
                assertTrue("secret of open-case" in page(id, cookie), "no case is shown")
            } finally {
                seen.countDown()
            }
        }
    }

    private fun stopped(): Report {
        val cases = Classroom.report(GradingVerdict.NOT_RUN, ScorePoints(0, 0, 0, 10)).cases()
        return Report(GradingVerdict.TIME_LIMIT, ScorePoints(0, 0, 0, 10), cases, emptyList(), "", 0.0)
    }

    @Test
    fun showsThePicturesOfAStatement() =
        Classroom(folder).open(grades = false) {
            val joined = form("/join", "course" to newCourse(), "name" to "Ada")
            val cookie = session(joined)
            val place = "/exercises/draw-dot/pictures/dot.svg"
            assertTrue("""src="$place"""" in page("/exercises/draw-dot", cookie), "the page has no picture")
            val picture = client.get(place) { header(HttpHeaders.Cookie, cookie) }
            assertEquals(Classroom.DOT, picture.bodyAsText())
            assertEquals("image/svg+xml", picture.headers[HttpHeaders.ContentType])
            assertTrue(
                picture.headers
                    .getAll("Content-Security-Policy")
                    .orEmpty()
                    .any { "sandbox" in it },
            )
            val scripted = client.get("/api/v1$place") { bearer(token(joined)) }
            assertEquals(Classroom.DOT, scripted.bodyAsText())
            val unknown = client.get("/api/v1/exercises/draw-dot/pictures/other.svg") { bearer(token(joined)) }
            assertEquals(404, unknown.status.value)
            assertTrue("no picture 'other.svg' of 'draw-dot'" in unknown.bodyAsText(), unknown.bodyAsText())
            assertFalse(client.get(place).bodyAsText().contains("<svg xmlns='"), "strangers see it")
        }

    @Test
    fun showsTheFormulasOfAStatementWithoutScriptsAndStyles() =
        Classroom(folder).open(grades = false) {
            val cookie = session(form("/join", "course" to newCourse(), "name" to "Ada"))
            val page = page("/exercises/draw-dot", cookie)
            assertTrue("""aria-label="x_0"""" in page && " for 5 $." in page, page)
            assertTrue("""<code>${'$'}\includegraphics{/etc/hostname}${'$'}</code>""" in page, page)
            assertEquals(1, Regex("<svg").findAll(page).count(), page)
            assertFalse(Regex("<style|style=").containsMatchIn(page), page)
        }

    @Test
    fun takesADoubleClickForOneAttempt() =
        Classroom(folder).open(grades = false) {
            val cookie = session(form("/join", "course" to newCourse(), "name" to "Ada"))
            val page = "Content-Disposition: form-data; name=\"once\"\r\n\r\n${once(cookie)}"
            val source = "Content-Disposition: form-data; name=\"source\""

            suspend fun send(text: String) =
                handIn(cookie, "$page\r\n--b\r\n$source", text.toByteArray()).headers[HttpHeaders.Location]

            val first = send("class Dot {}")
            assertEquals(first, send("class Dot {}"), "the second click is another attempt")
            val changed = send("class Dot { int a; }")
            assertTrue(changed != null && changed != first, "another source is no attempt: $changed")
            assertTrue(once(cookie) != once(cookie), "two pages are one")
        }

    private suspend fun Visit.once(cookie: String) =
        checkNotNull(Regex("""name="once" value="([^"]+)""").find(page("/exercises/draw-dot", cookie))).groupValues[1]

    @Test
    fun saysHowToSaveARussianFile() =
        Classroom(folder).open(grades = false) {
            val cookie = session(form("/join", "course" to newCourse(), "name" to "Ada"))
            val head = "Content-Disposition: form-data; name=\"source\"; filename=\"Dot.java\""
            val answer = handIn(cookie, head, "// рисует точку".toByteArray(charset("windows-1251")))
            assertEquals(422, answer.status.value)
            assertTrue("Windows-1251 (CP1251), not UTF-8. Save it as UTF-8" in answer.bodyAsText(), answer.bodyAsText())
        }

    @Test
    fun refusesAKotlinFileByItsName() =
        Classroom(folder).open(grades = false) {
            val cookie = session(form("/join", "course" to newCourse(), "name" to "Ada"))
            val head = "Content-Disposition: form-data; name=\"source\"; filename=\"Dot.kt\""
            val answer = handIn(cookie, head, "class Dot".toByteArray())
            assertEquals(415, answer.status.value)
            assertTrue("Kotlin is not accepted; send Java" in answer.bodyAsText(), answer.bodyAsText())
        }

    @Test
    fun refusesFormsOfOtherSites() =
        Classroom(folder).open(grades = false) {
            val code = newCourse()
            val foreign = form("/join", "course" to code, "name" to "Ada", origin = "http://elsewhere.example")
            assertEquals(403, foreign.status.value)
            assertEquals(403, form("/join", "course" to code, "name" to "Ada", origin = null).status.value)
            val cookie = session(form("/sign-in", "token" to instructor))
            val stolen =
                client.post("/api/v1/courses") {
                    header(HttpHeaders.Cookie, cookie)
                    header(HttpHeaders.ContentType, "application/json")
                    setBody("""{"name":"x"}""")
                }
            assertEquals(401, stolen.status.value, "a cookie must not be enough to change anything through the API")
        }

    @Test
    fun runsNothingButItsOwnFiles() =
        Classroom(folder).open(grades = false) {
            val answer = client.get("/")
            assertTrue("default-src 'self'" in answer.headers["Content-Security-Policy"].orEmpty())
            assertEquals("nosniff", answer.headers["X-Content-Type-Options"])
            val body = answer.bodyAsText()
            assertFalse(Regex("<script(?![^>]*src=)|<style|style=|\\son\\w+=").containsMatchIn(body), body)
            for (file in listOf(
                "rasterlab.css",
                "follow.js",
                "icon.svg",
            )) {
                assertEquals(200, client.get("/assets/$file").status.value, file)
            }
        }

    @Test
    fun keepsTheSessionFromScriptsAndOtherSites() =
        Classroom(folder).open(grades = false) {
            val set = form("/sign-in", "token" to instructor).headers[HttpHeaders.SetCookie].orEmpty()
            assertTrue("HttpOnly" in set && "SameSite=Strict" in set, set)
            assertFalse(instructor in set, "the token itself is in the cookie")
            val cookie = set.substringBefore(';')
            form("/sign-out", cookie = cookie)
            assertEquals(401, get("/instructor", cookie).status.value, "the session outlives signing out")
        }

    @Test
    fun letsEachRoleSeeItsOwnPages() =
        Classroom(folder).open(grades = false) {
            val student = session(form("/sign-in", "token" to newStudent()))
            for (path in listOf("/instructor", "/instructor/latest", "/instructor/events")) {
                assertEquals(403, get(path, student).status.value, path)
                assertEquals(401, client.get(path).status.value, path)
            }
        }

    @Test
    fun showsTheInstructorWhatIsHandedIn() =
        Classroom(folder).open(grades = false) {
            val cookie = session(form("/sign-in", "token" to instructor))
            form("/instructor/courses", "name" to "Graphics <1>", cookie = cookie)
            val student = newStudent()
            val id = idOf(checkNotNull(submit(student).headers[HttpHeaders.Location]))
            val desk = page("/instructor", cookie)
            assertTrue("Graphics &lt;1&gt;" in desk && "Ada" in desk && "waiting" in desk, desk)
            assertTrue("Ada — " in page("/submissions/$id", cookie), "the instructor does not see whose it is")
        }

    @Test
    fun speaksTheLanguageOfTheReader() =
        Classroom(folder).open(grades = false) {
            val russian = client.get("/") { header(HttpHeaders.AcceptLanguage, "ru-RU,ru;q=0.9,en;q=0.5") }.bodyAsText()
            assertTrue("Добро пожаловать" in russian && "lang=\"ru\"" in russian, russian)
            val chosen = client.get("/?lang=ru")
            assertTrue("Добро пожаловать" in chosen.bodyAsText())
            val kept = chosen.headers[HttpHeaders.SetCookie].orEmpty().substringBefore(';')
            assertTrue("Добро пожаловать" in page("/", kept))
            assertTrue("Welcome" in client.get("/?lang=xx") { header(HttpHeaders.AcceptLanguage, "de") }.bodyAsText())
            assertTrue("ничего нет" in client.get("/none?lang=ru").bodyAsText())
        }

    @Test
    fun tellsTheReasonsOfAResultInTheLanguageOfTheReader() =
        Classroom(folder).open {
            val joined = form("/join", "course" to newCourse(), "name" to "Ada")
            val cookie = session(joined)
            val result = checkNotNull(handIn(cookie, "class Dot {}").headers[HttpHeaders.Location])
            eventsToTheEnd(token(joined), idOf(result))
            val russian = page("$result?lang=ru", cookie)
            assertTrue("нет пикселя (1; 2)" in russian && "неверные пиксели на скрытых данных" in russian, russian)
            val fragment = page("$result/fragment?lang=ru", cookie)
            assertTrue("нет пикселя (1; 2)" in fragment, fragment)
            assertTrue("<h3>один пиксель</h3>" in russian && "<h3>hidden-case</h3>" in russian, russian)
            assertTrue("pixel (1, 2) is missing" in page("$result?lang=en", cookie))
            val api = "/api/v1/submissions/${idOf(result)}"
            assertTrue("pixel (1, 2) is missing" in client.get(api) { bearer(token(joined)) }.bodyAsText())
            val told = client.get("$api?lang=ru") { bearer(token(joined)) }.bodyAsText()
            assertTrue("нет пикселя (1; 2)" in told && "\"title\":\"один пиксель\"" in told, told)
        }

    @Test
    fun hasEveryTextInEveryLanguage() {
        val english = texts("texts.properties")
        assertEquals(english.keys, texts("texts_ru.properties").keys)
    }

    @Test
    fun fillsTheSamePlacesInEveryLanguage() {
        val russian = texts("texts_ru.properties")
        for ((key, text) in texts("texts.properties")) {
            assertEquals(places(text), places(russian.getValue(key)), key)
        }
    }

    private fun places(text: String) = Regex("""\{(\d+)""").findAll(text).map { it.groupValues[1] }.toSortedSet()

    private fun texts(file: String): Map<String, String> =
        Properties()
            .apply {
                PageTexts::class.java.getResourceAsStream(file).use { load(it?.reader(Charsets.UTF_8)) }
            }.entries
            .associate { (key, text) -> key.toString() to text.toString() }

    private suspend fun Visit.form(
        path: String,
        vararg fields: Pair<String, String>,
        cookie: String? = null,
        origin: String? = "http://localhost",
    ): HttpResponse =
        client.post(path) {
            header(HttpHeaders.Host, "localhost")
            origin?.let { header(HttpHeaders.Origin, it) }
            cookie?.let { header(HttpHeaders.Cookie, it) }
            header(HttpHeaders.ContentType, "application/x-www-form-urlencoded")
            setBody(
                fields.joinToString("&") { (name, value) -> "$name=${value.encodeURLParameter(spaceToPlus = true)}" },
            )
        }

    private suspend fun Visit.handIn(
        cookie: String,
        source: String,
    ) = client.post("/exercises/draw-dot") {
        header(HttpHeaders.Host, "localhost")
        header(HttpHeaders.Origin, "http://localhost")
        header(HttpHeaders.Cookie, cookie)
        setBody(MultiPartFormDataContent(formData(FormPart("source", source))))
    }

    private suspend fun Visit.handIn(
        cookie: String,
        head: String,
        content: ByteArray,
    ) = client.post("/exercises/draw-dot") {
        header(HttpHeaders.Host, "localhost")
        header(HttpHeaders.Origin, "http://localhost")
        header(HttpHeaders.Cookie, cookie)
        header(HttpHeaders.ContentType, "multipart/form-data; boundary=b")
        setBody("--b\r\n$head\r\n\r\n".toByteArray() + content + "\r\n--b--".toByteArray())
    }

    private suspend fun Visit.get(
        path: String,
        cookie: String,
    ) = client.get(path) { header(HttpHeaders.Cookie, cookie) }

    private suspend fun Visit.page(
        path: String,
        cookie: String,
    ) = get(path, cookie).also { assertEquals(200, it.status.value, path) }.bodyAsText()

    private fun session(answer: HttpResponse) =
        checkNotNull(answer.headers[HttpHeaders.SetCookie]) {
            "${answer.status}: no cookie"
        }.substringBefore(';')

    private suspend fun token(joined: HttpResponse) =
        checkNotNull(
            Regex("""<code class="token">([^<]+)""").find(joined.bodyAsText()),
        ) { "no token is shown" }.groupValues[1]

    private fun idOf(address: String) = address.substringAfterLast('/')
}
