package rasterlab.grader.report

import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.post
import io.ktor.client.request.setBody
import io.ktor.client.statement.bodyAsBytes
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonObject
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.assertProblem
import rasterlab.grader.json
import rasterlab.grader.list
import rasterlab.grader.text
import java.nio.file.Path

/** Pictures of a case on their way to who looks at it, one of a kind that no reader knows among them. */
class PicturesTest {
    @TempDir
    lateinit var folder: Path

    @Test
    fun eachPictureHasItsKindAddressTextAndPart() =
        graded { token, id ->
            val part =
                """{"shown":{"xmin":-2,"ymin":1,"xmax":1,"ymax":1},"whole":{"xmin":-2,"ymin":1,"xmax":99,"ymax":1},""" +
                    """"pixel":{"x":-1,"y":1}}"""
            val folder = "/api/v1/submissions/$id/cases/open-case"
            for ((language, input) in listOf("en" to "pixel (-1, 2) is extra", "ru" to "лишний пиксель (−1; 2)")) {
                val cases = look(token, "/api/v1/submissions/$id?lang=$language").json().list("cases")
                val told = cases[0].jsonObject.list("pictures").map { described(it.jsonObject) }
                assertEquals(
                    listOf(
                        """expected $folder/expected.png a part/#.#. $part""",
                        """actual $folder/actual.png a part/##.. $part""",
                        """difference $folder/difference.png a part/#+-. $part""",
                        """input $folder/input.png $input null""",
                    ),
                    told,
                )
                assertEquals(emptyList<Any>(), cases[1].jsonObject.list("pictures"), "of a hidden case")
            }
        }

    private fun described(picture: JsonObject): String {
        assertEquals(setOf("kind", "url", "text", "part"), picture.keys)
        val text = picture.text("text").replace("\n", "/")
        return "${picture.text("kind")} ${picture.text("url")} $text ${picture["part"]}"
    }

    @Test
    fun eachAddressHasItsOwnPicture() =
        graded { token, id ->
            val cases = look(token, "/api/v1/submissions/$id").json().list("cases")
            for ((place, picture) in cases[0].jsonObject.list("pictures").withIndex()) {
                val found = look(token, picture.jsonObject.text("url")).bodyAsBytes()
                assertArrayEquals(byteArrayOf((place + 1).toByte()), found, picture.toString())
            }
            for (name in listOf("difference", "difference.png.png", "other.png", "differencexpng")) {
                val none = look(token, "/api/v1/submissions/$id/cases/open-case/$name")
                none.assertProblem(404, "unknown-picture")
            }
        }

    @Test
    fun thePageNamesEachPictureInItsLanguageAndTellsWhatIsThere() =
        graded { token, id ->
            val cookie = session(token)
            val english = page(cookie, "/submissions/$id?lang=en")
            val names = listOf("expected", "yours", "difference", "input")
            assertEquals(names, captions(english))
            assertTrue("alt=\"one pixel: yours\ncolumns −2..1 of −2..99, rows 1..1 of 1..1\n##..\"" in english, english)
            assertTrue("alt=\"one pixel: input\npixel (−1, 2) is extra\"" in english, english)
            val russian = page(cookie, "/submissions/$id?lang=ru")
            assertEquals(listOf("ожидалось", "у вас", "разница", "input"), captions(russian))
            assertTrue("столбцы −2..1 из −2..99" in russian.replace("\u00a0", " "), russian)
            assertTrue("alt=\"один пиксель: input\nлишний пиксель (−1; 2)\"" in russian, russian)
            assertTrue(""">#+-.</pre>""" in russian, russian)
        }

    private fun captions(page: String) = Regex("<figcaption>([^<]*)").findAll(page).map { it.groupValues[1] }.toList()

    private suspend fun Visit.session(token: String) =
        client
            .post("/sign-in") {
                header(HttpHeaders.Host, "localhost")
                header(HttpHeaders.Origin, "http://localhost")
                header(HttpHeaders.ContentType, "application/x-www-form-urlencoded")
                setBody("token=$token")
            }.headers[HttpHeaders.SetCookie]
            .orEmpty()
            .substringBefore(';')

    private suspend fun Visit.page(
        cookie: String,
        path: String,
    ) = client.get(path) { header(HttpHeaders.Cookie, cookie) }.bodyAsText()

    /** Runs a test with a student's token and submission. */
    private fun graded(test: suspend Visit.(String, String) -> Unit) =
        Classroom(folder).open {
            val token = newStudent()
            val id = submit(token).json().text("id")
            eventsToTheEnd(token, id)
            test(token, id)
        }
}
