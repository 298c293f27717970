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
import rasterlab.grader.text
import java.nio.file.Path

/** The page of a course's students, and the roster that is taken there. */
@Tag("slow")
class RosterPagesTest {
    @TempDir
    lateinit var folder: Path

    @Test
    @DisplayName("a roster changes something before that is confirmed, or what is confirmed is another than was shown")
    fun changesWhatWasShownAndNoSooner() =
        Classroom(folder).open(grades = false) {
            val course = newCourse()
            newStudent(course)
            val page = "/instructor/courses/$course/students"
            val roster = "Имя;Фамилия;Группа\nАда;Лавлейс;<b>1\n".toByteArray(charset("windows-1251"))
            val preview = take(page, FormPart("roster", roster)).bodyAsText()
            assertTrue("To be added: 1" in preview && "<li>Ада Лавлейс</li>" in preview, preview)
            assertTrue("left as they are: 1" in preview && "<li>Ada</li>" in preview, preview)
            assertEquals("1", count("students"))
            val done = take(page, FormPart("seen", seen(preview))).bodyAsText()
            assertEquals("2", count("students"))
            val token = checkNotNull(Regex("""<code class="token">([^<]*)</code>""").find(done)).groupValues[1]
            assertEquals(200, look(token, "/api/v1/exercises").status.value, "the token lets nobody in")
            assertFalse(token in show(page), "a token is shown again")
            val again = take(page, FormPart("roster", roster)).bodyAsText()
            assertTrue("The roster changes nothing." in again && "name=\"seen\"" !in again, again)
        }

    @Test
    @DisplayName("what a field was is not shown, or what was done is told as something to do")
    fun showsWhatEachFieldWas() =
        Classroom(folder).open(grades = false) {
            val course = newCourse()
            val page = "/instructor/courses/$course/students"
            val first = take(page, FormPart("roster", "Name;Group;Email\nAda;1;a@x\n")).bodyAsText()
            take(page, FormPart("seen", seen(first)))
            val preview =
                take(
                    page,
                    FormPart("roster", "Name;Email;Group;Login;Mark\nAda King;a@x;2;ada;7\n"),
                ).bodyAsText()
            val done = take(page, FormPart("seen", seen(preview))).bodyAsText()
            for (told in listOf(preview, done)) {
                val lines = Regex("<li>([^<]*)").findAll(told).map { it.groupValues[1].trim() }.toList()
                assertTrue(lines.containsAll(listOf("Ada", "name: Ada → Ada King", "section: 1 → 2")), told)
                assertTrue("username: ada (not known before)" in lines, told)
                assertTrue("not used: Mark" in told, told)
            }
            assertTrue("To be corrected: 1" in preview && "To be corrected" !in done && "Corrected: 1" in done, done)
        }

    @Test
    @DisplayName("a second click on the button that applies a roster loses the tokens, or applies it again")
    fun showsTheTokensOfAFormThatIsSentTwice() =
        Classroom(folder).open(grades = false) {
            val page = "/instructor/courses/${newCourse()}/students"
            val preview = take(page, FormPart("roster", "Name\nAda\nEmmy\n")).bodyAsText()
            val once = checkNotNull(Regex("""name="once" value="([^"]+)"""").find(preview)) { preview }.groupValues[1]
            val form = arrayOf(FormPart("seen", seen(preview)), FormPart("once", once))
            val (first, second) = List(2) { tokens(take(page, *form).bodyAsText()) }
            assertEquals(2, first.size)
            assertEquals(first, second)
            assertEquals("2", count("students"))
            assertEquals("1", count("audit WHERE action = 'roster'"))
            val other = take(page, FormPart("roster", "Name\nAda\nEmmy\n")).bodyAsText()
            assertFalse(once in other, "another form has the same key")
        }

    private fun tokens(page: String): List<String> =
        Regex("""<code class="token">([^<]+)</code>""").findAll(page).map { it.groupValues[1] }.toList()

    @Test
    @DisplayName("a roster that is too long is refused with the limit of a source, or with words for one")
    fun tellsHowLongARosterMayBe() =
        Classroom(folder).open(grades = false) {
            val page = "/instructor/courses/${newCourse()}/students"
            for (length in listOf((1 shl 20) + 1, 3 shl 20)) {
                val refused = take(page, FormPart("roster", "Name\n".padEnd(length, 'x')))
                assertEquals(413, refused.status.value)
                val told = refused.bodyAsText()
                assertTrue("at most 1 MiB" in told && "name=\"roster\"" in told, told)
                assertFalse("256" in told, told)
            }
        }

    private fun seen(page: String) =
        checkNotNull(Regex("""name="seen" value="([^"]*)"""").find(page)) { page }.groupValues[1]

    @Test
    @DisplayName("a file that is no roster loses the page, changes something, or what is wrong is not told")
    fun tellsWhatIsWrongWithAFile() =
        Classroom(folder).open(grades = false) {
            val course = newCourse()
            newStudent(course)
            val page = "/instructor/courses/$course/students"
            for (part in listOf(FormPart("roster", "Mark\n5\n"), FormPart("roster", ""), FormPart("other", "x"))) {
                val refused = take(page, part)
                val told = refused.bodyAsText()
                assertEquals(422, refused.status.value, told)
                assertTrue("nothing was changed" in told && "name=\"roster\"" in told, told)
            }
            assertEquals(400, take(page, FormPart("seen", "!")).status.value)
            assertEquals(403, take(page, FormPart("roster", "Name\nEve\n"), by = newStudent(course)).status.value)
            assertEquals("2", count("students"))
        }

    @Test
    @DisplayName("the page does not tell a student's number, attempts or points, or a course without students has none")
    fun listsWhoIsThere() =
        Classroom(folder).open {
            val course = newCourse()
            val page = "/instructor/courses/$course/students"
            assertTrue("No student yet. Give them the code $course" in show(page), show(page))
            val ada = newStudent(course)
            newStudent(course)
            repeat(2) {
                val id = submit(ada, "class Dot { int n = $it; }").json().text("id")
                eventsToTheEnd(ada, id)
            }
            val listed = show(page)
            val cells =
                Regex(
                    """<td class="number"[^>]*>([^<]*)</td>""",
                ).findAll(listed).map { it.groupValues[1] }.toList()
            assertEquals(listOf("1", "2", "4", "2", "0", "–"), cells, listed)
            assertTrue(">Ada (2)<" in listed, listed)
            assertTrue(">Баллы</th>" in show("$page?lang=ru"))
        }

    private suspend fun Visit.show(path: String): String {
        val cookie = cookieOf(instructor)
        return client
            .get(
                if ('?' in
                    path
                ) {
                    path
                } else {
                    "$path?lang=en"
                },
            ) { header(HttpHeaders.Cookie, cookie) }
            .bodyAsText()
    }

    private suspend fun Visit.take(
        path: String,
        vararg parts: FormPart<*>,
        by: String = instructor,
    ): HttpResponse {
        val cookie = cookieOf(by)
        return client.post("$path?lang=en") {
            header(HttpHeaders.Cookie, cookie)
            header(HttpHeaders.Host, "localhost")
            header(HttpHeaders.Origin, "http://localhost")
            setBody(MultiPartFormDataContent(formData(*parts)))
        }
    }

    private fun Visit.count(table: String): String =
        database.read { it.createQuery("SELECT count(*) FROM $table").mapTo(String::class.java).one() }
}
