package rasterlab.grader.similarity

import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.statement.bodyAsBytes
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.assertProblem
import rasterlab.grader.cookieOf
import rasterlab.grader.json
import rasterlab.grader.list
import rasterlab.grader.text
import java.nio.file.Path
import java.util.zip.ZipInputStream

/** Programs that are alike are shown to the instructor, by HTTP, on pages and in a file for other tools. */
@Tag("slow")
class SimilarTest {
    @TempDir
    lateinit var folder: Path

    private suspend fun Visit.hand(
        token: String,
        source: String,
    ): String {
        val id = submit(token, source).json().text("id")
        eventsToTheEnd(token, id)
        return id
    }

    @Test
    @DisplayName("copies of two courses are not found, an earlier attempt is compared, or a student sees the list")
    fun findsCopiesAcrossCourses() =
        Classroom(folder).open {
            val ada = newStudent(newCourse())
            val eve = newStudent(newCourse())
            hand(ada, "class Dot { int other() { return 1; } }")
            val first = hand(ada, COPIED)
            val second = hand(eve, COPIED.replace("sum", "total"))
            val found = look(instructor, PATH).json()
            assertEquals(
                2,
                found
                    .getValue("programs")
                    .jsonPrimitive.content
                    .toInt(),
            )
            val pair = found.list("pairs").single().jsonObject
            assertEquals(
                listOf(first, second),
                listOf("first", "second").map { pair.getValue(it).jsonObject.text("submission") },
            )
            assertEquals("1.0", pair.text("shared"))
            assertEquals(listOf("open-case", "hidden-case"), pair.list("sameWrong").map { it.jsonPrimitive.content })
            look(ada, PATH).assertProblem(403, "wrong-role")
            look(instructor, PATH.replace("draw-dot", "none")).assertProblem(404, "unknown-exercise")
        }

    @Test
    @DisplayName("the page of two programs does not mark what is alike, or shows a source as HTML")
    fun marksWhatIsAlike() =
        Classroom(folder).open {
            val ids = listOf("<b>", "<i>").map { hand(newStudent(), "// $it\n$COPIED") }
            val cookie = cookieOf(instructor)

            suspend fun page(path: String) = client.get(path) { header(HttpHeaders.Cookie, cookie) }.bodyAsText()
            val list = page("/instructor/exercises/draw-dot/similarity")
            val address = "/instructor/exercises/draw-dot/similarity/${ids[0]}/${ids[1]}"
            assertTrue(address in list, list)
            val beside = page(address)
            assertEquals(2, Regex("<li><code>// &lt;[bi]&gt;</code>").findAll(beside).count(), beside)
            assertEquals(2, Regex("<li class=\"in-both\">").findAll(beside).count(), beside)
            assertTrue("open-case, hidden-case" in beside, beside)
        }

    @Test
    @DisplayName("the file for other tools lacks a program, the starter or the table")
    fun givesAllProgramsAway() =
        Classroom(folder).open {
            val ids = listOf("class Dot {}", COPIED).map { hand(newStudent(), it) }
            val zip = look(instructor, "/api/v1/exercises/draw-dot/programs.zip").bodyAsBytes()
            val files =
                ZipInputStream(zip.inputStream()).use { all ->
                    generateSequence { all.nextEntry }.associate { it.name to all.readBytes().decodeToString() }
                }
            assertEquals(
                setOf("info.csv", "starter/Starter.java") + ids.map { "submissions/$it/Program.java" },
                files.keys,
            )
            assertEquals(COPIED, files["submissions/${ids[1]}/Program.java"])
            val table = files.getValue("info.csv").lines()
            assertEquals("filename,label,full_name,created_at", table[0])
            assertTrue(table[1].startsWith("\"submissions/${ids[0]}/Program.java\",\"Graphics\",\"Ada"), table[1])
        }

    private companion object {
        const val PATH = "/api/v1/exercises/draw-dot/similarity"

        const val COPIED =
            "class Dot { int sum(int[] all) { int sum = 0; for (int i = 0; i < all.length; i++) " +
                "if (all[i] > 0) sum += 2 * all[i]; return sum; } }"
    }
}
