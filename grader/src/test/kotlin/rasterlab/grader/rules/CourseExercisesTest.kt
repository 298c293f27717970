package rasterlab.grader.rules

import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.put
import io.ktor.client.statement.HttpResponse
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.jsonArray
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
import rasterlab.grader.printedBy
import rasterlab.grader.sendForm
import rasterlab.grader.text
import java.nio.file.Path

/** A course has the exercises that its instructor chose, out of all that the server has. */
@Tag("slow")
class CourseExercisesTest {
    @TempDir
    lateinit var folder: Path

    private fun classroom() = Classroom(folder, more = listOf("b", "c").map(Classroom::another))

    @Test
    @DisplayName("a student gets an exercise that the course does not have, or another course loses it")
    fun givesStudentsWhatWasChosen() =
        classroom().open(grades = false) {
            val course = newCourse()
            val (ada, elsewhere) = newStudent(course) to newStudent()
            assertEquals(listOf("draw-dot", "b", "c"), exercisesOf(ada))
            assertEquals("""{"exercises":["draw-dot","c"]}""", choose(course, """["c","draw-dot"]""").bodyAsText())
            assertEquals(listOf("draw-dot", "c"), exercisesOf(ada))
            assertEquals(listOf("draw-dot", "b", "c"), exercisesOf(elsewhere))
            assertEquals(listOf("draw-dot", "b", "c"), exercisesOf(instructor))
            for (path in listOf("b", "b/starter", "%62", "b/front", "b/hints")) {
                look(ada, "/api/v1/exercises/$path").assertProblem(404, "unknown-exercise")
            }
            submit(ada, exercise = "b").assertProblem(404, "unknown-exercise")
            assertEquals(202, submit(ada, exercise = "c").status.value)
            val page = page("/exercises", ada)
            assertTrue("The task c" in page && "The task b" !in page, page)
            assertEquals("""{"exercises":["draw-dot","b","c"]}""", choose(course, "null").bodyAsText())
            assertEquals(202, submit(ada, exercise = "b").status.value)
        }

    @Test
    @DisplayName("a course with no exercise, or with one that there is not, is stored, or a student chooses")
    fun refusesWhatCannotBe() =
        classroom().open(grades = false) {
            val course = newCourse()
            choose(course, """["b"]""")
            choose(course, "[]").assertProblem(400, "malformed-request")
            choose(course, """["b","none"]""").assertProblem(404, "unknown-exercise")
            choose(course, "7").assertProblem(400, "malformed-request")
            choose("none", """["b"]""").assertProblem(404, "unknown-course")
            choose(course, """["c"]""", by = newStudent(course)).assertProblem(403, "wrong-role")
            assertEquals(listOf("b"), inCourse(course))
            choose(course, """["b"]""")
            assertEquals("1", one("SELECT count(*) FROM audit WHERE action = 'exercises'"))
        }

    @Test
    @DisplayName("the marks have a column, or a total has points, of an exercise that the course does not have")
    fun countsWhatTheCourseHas() =
        classroom().open {
            val course = newCourse()
            val ada = newStudent(course)
            for (exercise in listOf("draw-dot", "b")) {
                val id = submit(ada, exercise = exercise).json().text("id")
                eventsToTheEnd(ada, id)
            }
            choose(course, """["b","c"]""")
            assertEquals("number,name,b,c,total\r\n1,Ada,4,,4\r\n", grades(course))
            choose(course, "null")
            assertEquals("number,name,draw-dot,b,c,total\r\n1,Ada,4,4,,8\r\n", grades(course))
        }

    @Test
    @DisplayName("next year's course has other exercises")
    fun isTakenOver() =
        classroom().open(grades = false) {
            val course = newCourse()
            choose(course, """["c"]""")
            val next = printedBy(folder, "course", "clone", course, "Next").lines().first().substringAfter('\t')
            assertEquals(listOf("c"), inCourse(next))
        }

    @Test
    @DisplayName("the page loses a choice, shows what is in the course last, or lets an assistant choose")
    fun isChosenOnThePage() =
        classroom().open(grades = false) {
            val course = one("SELECT id FROM courses WHERE code = '${newCourse()}'")
            val address = "/instructor/courses/$course/exercises"
            assertEquals(302, sendForm(address, "exercise=c").status.value)
            assertEquals(listOf("c"), inCourse(course))
            val page = page(address, instructor)
            assertTrue(page.indexOf("The task c") < page.indexOf("The task b"), page)
            val refused = sendForm(address, "")
            assertEquals(422, refused.status.value)
            assertTrue("at least one exercise" in refused.bodyAsText(), refused.bodyAsText())
            val assistant =
                printedBy(
                    folder,
                    "staff",
                    "add",
                    "--role",
                    "assistant",
                    "Bob",
                ).trim().lines().last().substringAfterLast('\t')
            assertEquals(403, sendForm(address, "exercise=b", assistant).status.value)
            assertFalse("checkbox" in page(address, assistant))
            assertEquals(302, sendForm(address, "all=").status.value)
            assertEquals(listOf("draw-dot", "b", "c"), inCourse(course))
        }

    @Test
    @DisplayName("the command makes no course, takes an exercise that there is not, or loses the choice")
    fun isChosenByCommand() =
        Classroom(folder).open(grades = false) {
            val made =
                printedBy(folder, "course", "create", "Graphics")
                    .trim()
                    .lines()
                    .last()
                    .substringAfter('\t')
            val chosen = printedBy(folder, "course", "exercises", made, "clip-segment", "circle")
            assertEquals(setOf("clip-segment", "circle"), chosen.trim().lines().toSet())
            assertTrue("none" in printedBy(folder, "course", "exercises", made, "none", exit = 2))
            assertEquals(chosen, printedBy(folder, "course", "exercises", made))
            val head = listOf("number", "name") + chosen.trim().lines() + "total"
            assertEquals(head.joinToString(","), printedBy(folder, "course", "grades", made).trim())
            assertTrue(printedBy(folder, "course", "exercises", made, "--all").lines().size > 20)
            printedBy(folder, "course", "exercises", made, "--all", "circle", exit = 2)
        }

    private suspend fun Visit.exercisesOf(token: String): List<String> =
        Json.parseToJsonElement(look(token, "/api/v1/exercises").bodyAsText()).jsonArray.map { it.field("id") }

    private suspend fun Visit.choose(
        course: String,
        exercises: String,
        by: String = instructor,
    ): HttpResponse =
        client.put("/api/v1/courses/$course/exercises") {
            bearer(by)
            json("""{"exercises":$exercises}""")
        }

    private suspend fun Visit.inCourse(course: String): List<String> =
        look(instructor, "/api/v1/courses/$course/exercises")
            .json()
            .list("exercises")
            .filter { it.field("inCourse") == "true" }
            .map { it.field("exercise") }

    private suspend fun Visit.grades(course: String) =
        look(instructor, "/api/v1/courses/$course/grades.csv").bodyAsText()

    private suspend fun Visit.page(
        path: String,
        by: String,
    ): String {
        val cookie = cookieOf(by)
        return client.get(path) { header(HttpHeaders.Cookie, cookie) }.bodyAsText()
    }
}
