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
import rasterlab.exercises.score.CaseReport
import rasterlab.exercises.score.Report
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.assertProblem
import rasterlab.grader.cookieOf
import rasterlab.grader.course.Name
import rasterlab.grader.course.Staff
import rasterlab.grader.course.StaffRole
import rasterlab.grader.json
import rasterlab.grader.list
import rasterlab.grader.one
import rasterlab.grader.text
import java.nio.file.Path
import java.time.InstantSource
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
            val table = Regex("<div class=\"scroll\" tabindex=\"0\"[^>]*>\\s*<table class=\"students stacked\">")
            assertTrue(table in list, "the page is as wide as its table: $list")
            assertEquals(4, Regex("<td class=\"number\"").findAll(list).count(), list)
            assertEquals(4, Regex("<th [^>]*class=\"number\"").findAll(list).count(), list)
            val beside = page(address)
            assertEquals(2, Regex("<li><code>// &lt;[bi]&gt;</code>").findAll(beside).count(), beside)
            assertEquals(2, Regex("<li class=\"in-both\">").findAll(beside).count(), beside)
            assertTrue("(2): one pixel; hidden-case." in beside, beside)
        }

    @Test
    @DisplayName("points that both lost are told as a case by a name of the program, without a reason")
    fun saysWhyPointsAreWithheld() {
        val report =
            Classroom.wrongReport().let {
                Report(
                    it.verdict(),
                    it.points(),
                    it.cases() + CaseReport.withheld(1, "steep lines", "крутые отрезки"),
                    it.diagnostics(),
                    it.isolation(),
                    it.nanosPerItem(),
                )
            }
        Classroom(folder, grading = { _, _, _, _ -> report }).open {
            val ids = List(2) { hand(newStudent(), COPIED) }
            val beside = page("/instructor/exercises/draw-dot/similarity/${ids[0]}/${ids[1]}")
            assertTrue("(2): one pixel; hidden-case." in beside, beside)
            assertTrue("withheld, since most hidden inputs" in beside, beside)
        }
    }

    @Test
    @DisplayName("the list of a course has a program of another, or staff of another course see it")
    fun comparesWithinACourse() =
        Classroom(folder).open {
            val (course, other) = List(2) { newCourse() }
            val here = List(2) { hand(newStudent(course), COPIED) }
            val there = hand(newStudent(other), COPIED)
            val path = "/courses/$course/exercises/draw-dot/similarity"
            val found = look(instructor, "/api/v1$path").json()
            assertEquals("2", found.text("programs"))
            val pair = found.list("pairs").single().jsonObject
            assertEquals(here, listOf("first", "second").map { pair.getValue(it).jsonObject.text("submission") })
            val list = page("/instructor$path")
            val id = one("SELECT id FROM courses WHERE code = '$course'")
            assertTrue("/instructor/courses/$id/exercises/draw-dot/similarity/${here[0]}/${here[1]}" in list, list)
            assertTrue(there !in list && "of this course: 2" in list, list)
            assertTrue("draw-dot/similarity\"" in page("/instructor/courses/$course/exercises"))
            val staff = Staff(database, InstantSource.system())
            val mine = staff.add(Name.of("Alan"), StaffRole.ASSISTANT, by = "test", key = null, id).token
            assertEquals("2", look(mine, "/api/v1$path").json().text("programs"))
            look(mine, "/api/v1${path.replace(course, other)}").assertProblem(404, "unknown-course")
            val beside = "/instructor$path/${here[0]}"
            assertTrue("in-both" in page("$beside/${here[1]}", mine))
            assertTrue("in-both" !in page("$beside/$there", mine), "a program of another course is shown")
        }

    private suspend fun Visit.page(
        path: String,
        by: String = instructor,
    ): String {
        val cookie = cookieOf(by)
        return client.get("$path?lang=en") { header(HttpHeaders.Cookie, cookie) }.bodyAsText()
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
