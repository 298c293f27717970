package rasterlab.grader.rules

import io.ktor.client.request.header
import io.ktor.client.request.patch
import io.ktor.client.request.post
import io.ktor.client.statement.HttpResponse
import io.ktor.client.statement.bodyAsText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.assertProblem
import rasterlab.grader.bearer
import rasterlab.grader.field
import rasterlab.grader.json
import rasterlab.grader.list
import rasterlab.grader.one
import rasterlab.grader.printedBy
import rasterlab.grader.sendForm
import rasterlab.grader.text
import java.nio.file.Path

/** A course is made of last year's: its rules a year later, and none of its students. */
@Tag("slow")
class CourseClonesTest {
    @TempDir
    lateinit var folder: Path

    @Test
    @DisplayName("a rule is lost, a deadline has another time of day, a student comes along, or the old course changes")
    fun takesTheRulesAndNobody() =
        Classroom(folder).open(grades = false) {
            val course = ruled()
            val made = clone(course, """{"name":"Next","days":182}""").json()
            val rules = rulesOf(made.text("course"))
            val told = listOf("opens", "deadline", "zone", "lateDays", "attempts", "policy").map(rules::field)
            // Clocks in Berlin are an hour ahead in summer.
            val later =
                listOf("2027-08-01T22:00:00.000Z", "2027-08-15T21:59:00.000Z", "Europe/Berlin", "2", "3", "last")
            assertEquals(later, told)
            assertEquals("2027-02-14T22:59:00.000Z", rulesOf(course).field("deadline"))
            assertEquals("[]", look(instructor, "/api/v1/courses/${made.text("course")}/students").bodyAsText())
            assertEquals(
                "2027-02-13T22:59:00.000Z",
                rulesOf(clone(course, """{"name":"N","days":-1}""")).field("deadline"),
            )
            val year = rulesOf(clone(course, """{"name":"N"}""")).field("deadline")
            assertEquals("2028-02-13T22:59:00.000Z", year)
            assertEquals("3", one("SELECT count(*) FROM audit WHERE action = 'clone'"))
        }

    @Test
    @DisplayName("kept comments do not come along, come twice or leave the old course, or what students were told does")
    fun takesKeptComments() =
        Classroom(folder).open(grades = false) {
            val course = newCourse()
            val token = newStudent(course)
            val submission = submit(token, "class Dot { }").json().text("id")
            client.post("/api/v1/courses/$course/kept-comments") {
                bearer(instructor)
                json("""{"name":"ends","text":"Both ends belong to it."}""")
            }
            client.post("/api/v1/submissions/$submission/comments") {
                bearer(instructor)
                json("""{"text":"Only for you."}""")
            }
            val made = clone(course, """{"name":"Next"}""").json().text("course")
            for (one in listOf(course, made)) {
                val kept = look(instructor, "/api/v1/courses/$one/kept-comments").bodyAsText()
                assertEquals(1, Regex("Both ends belong to it").findAll(kept).count(), kept)
            }
            assertEquals("2", one("SELECT count(DISTINCT id) FROM kept_comments"))
            assertEquals("1", one("SELECT count(*) FROM comments"))
        }

    @Test
    @DisplayName("what cannot be a name, a number of days or a course makes one, or a repeated request makes two")
    fun refusesWhatCannotBe() =
        Classroom(folder).open(grades = false) {
            val course = ruled()
            clone(course, """{"name":"","days":1}""").assertProblem(422, "bad-name")
            clone(course, """{"name":"N","days":3661}""").assertProblem(422, "bad-rule")
            clone(course, """{"name":"N","days":"soon"}""").assertProblem(422, "bad-rule")
            clone("none", """{"name":"N"}""").assertProblem(404, "unknown-course")
            clone(course, """{"name":"N"}""", by = newStudent(course)).assertProblem(403, "wrong-role")
            val twice = List(2) { clone(course, """{"name":"N"}""", key = "once").json().text("course") }
            assertEquals(1, twice.distinct().size)
            assertEquals("2", one("SELECT count(*) FROM courses"))
        }

    @Test
    @DisplayName("the page or the command makes no course, or forgets what was typed")
    fun pageAndCommandDoSoToo() =
        Classroom(folder).open(grades = false) {
            val course = ruled()
            assertTrue(send(course, "name=&days=7").bodyAsText().contains("value=\"7\""))
            assertEquals(302, send(course, "name=Next&days=7").status.value)
            assertEquals("1", one("SELECT count(*) FROM courses WHERE name = 'Next'"))
            assertTrue("code\t" in command(course, "Later", "--days", "7"))
            assertEquals("1", one("SELECT count(*) FROM courses WHERE name = 'Later'"))
            assertTrue("целое число от" in command(course, "Later", "--days", "x", "--lang", "ru", exit = 2))
            assertTrue("от 1 до 80 видимых" in command(course, " ", "--lang", "ru", exit = 2))
        }

    private suspend fun Visit.ruled(): String {
        val course = newCourse()
        newStudent(course)
        client.patch("/api/v1/courses/$course/exercises/draw-dot") {
            bearer(instructor)
            json(
                """{"opens":"2027-02-01T00:00","deadline":"2027-02-14T23:59","zone":"Europe/Berlin","lateDays":2,
                    "attempts":3,"policy":"last"}""",
            )
        }
        return course
    }

    private suspend fun Visit.clone(
        course: String,
        body: String,
        by: String = instructor,
        key: String? = null,
    ) = client.post("/api/v1/courses/$course/clone") {
        bearer(by)
        key?.let { header("Idempotency-Key", it) }
        json(body)
    }

    private suspend fun Visit.rulesOf(made: HttpResponse) = rulesOf(made.json().text("course"))

    private suspend fun Visit.rulesOf(course: String) =
        look(instructor, "/api/v1/courses/$course/exercises").json().list("exercises").single()

    private suspend fun Visit.send(
        course: String,
        body: String,
    ) = sendForm("/instructor/courses/$course/clone", body)

    private fun command(
        vararg arguments: String,
        exit: Int = 0,
    ) = printedBy(folder, "course", "clone", *arguments, exit = exit)
}
