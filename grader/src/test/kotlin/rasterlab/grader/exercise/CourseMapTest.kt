package rasterlab.grader.exercise

import io.ktor.client.request.patch
import io.ktor.client.request.post
import io.ktor.client.statement.HttpResponse
import io.ktor.client.statement.bodyAsText
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.assertProblem
import rasterlab.grader.bearer
import rasterlab.grader.json
import rasterlab.grader.text
import java.nio.file.Path

/** How far a student has come, as the list of exercises tells it. */
@Tag("slow")
class CourseMapTest {
    @TempDir
    lateinit var folder: Path

    @Test
    fun untriedExerciseIsToldAsSuchUntilItHasPoints() =
        Classroom(folder).open {
            val ada = newStudent()
            assertEquals("not-tried" to "null", standing(ada))
            eventsToTheEnd(ada, submit(ada).json().text("id"))
            assertEquals("graded" to "4", standing(ada))
        }

    @Test
    fun whatWaitsForItsGradingHasNoPointsYet() =
        Classroom(folder).open(grades = false) {
            val ada = newStudent()
            submit(ada)
            assertEquals("waiting" to "null", standing(ada))
        }

    @Test
    fun oneStudentsPointsAreNotAnothersNorTheInstructors() =
        Classroom(folder).open {
            val course = newCourse()
            val ada = newStudent(course)
            eventsToTheEnd(ada, submit(ada).json().text("id"))
            assertEquals("not-tried" to "null", standing(newStudent(course)))
            assertEquals(JsonNull, listed(instructor).getValue("state"))
        }

    @Test
    fun deadlineIsToldToTheStudentsOfItsCourseAlone() =
        Classroom(folder).open {
            val course = created()
            val ada = newStudent(course.text("code"))
            val id = course.text("course")
            due(id, "2027-03-01T20:00:00Z").assertDeadline("2027-03-01T20:00:00.000Z")
            due(id, "2027-03-02T21:00:00Z").assertDeadline("2027-03-02T21:00:00.000Z")
            assertEquals("2027-03-02T21:00:00.000Z", listed(ada).text("deadline"))
            assertEquals(JsonNull, listed(newStudent()).getValue("deadline"))
            due(id, "").assertDeadline("null")
            assertEquals(JsonNull, listed(ada).getValue("deadline"))
        }

    @Test
    fun deadlineThatCannotBeSetIsRefusedWithItsReason() =
        Classroom(folder).open {
            val course = created()
            val id = course.text("course")
            due(id, "tomorrow").assertProblem(422, "bad-deadline")
            due("none", "2027-03-01T20:00:00Z").assertProblem(404, "unknown-course")
            due(id, "2027-03-01T20:00:00Z", exercise = "none").assertProblem(404, "unknown-exercise")
            due(id, "2027-03-01T20:00:00Z", token = newStudent(course.text("code"))).assertProblem(403, "wrong-role")
        }

    private suspend fun Visit.created() =
        client
            .post("/api/v1/courses") {
                bearer(instructor)
                json("""{"name":"Graphics"}""")
            }.json()

    private suspend fun Visit.due(
        course: String,
        deadline: String,
        exercise: String = "draw-dot",
        token: String = instructor,
    ) = client.patch("/api/v1/courses/$course/exercises/$exercise") {
        bearer(token)
        json("""{"deadline":"$deadline"}""")
    }

    private suspend fun HttpResponse.assertDeadline(expected: String) = assertEquals(expected, json().text("deadline"))

    private suspend fun Visit.standing(token: String) = listed(token).run { text("state") to text("best") }

    private suspend fun Visit.listed(token: String): JsonObject =
        Json
            .parseToJsonElement(look(token, "/api/v1/exercises").bodyAsText())
            .jsonArray
            .single()
            .jsonObject
}
