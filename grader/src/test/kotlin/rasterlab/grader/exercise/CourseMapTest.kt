package rasterlab.grader.exercise

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

    private suspend fun Visit.standing(token: String) = listed(token).run { text("state") to text("best") }

    private suspend fun Visit.listed(token: String): JsonObject =
        Json.parseToJsonElement(look(token, "/api/v1/exercises").bodyAsText()).jsonArray.single().jsonObject
}
