package rasterlab.grader.hint

import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.post
import io.ktor.client.request.setBody
import io.ktor.client.statement.HttpResponse
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.exercises.Exercise
import rasterlab.exercises.Hint
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.assertProblem
import rasterlab.grader.bearer
import rasterlab.grader.field
import rasterlab.grader.json
import rasterlab.grader.list
import rasterlab.grader.text
import java.nio.file.Path

/** Hints are shown in order, recorded once, and taken off what is handed in afterwards. */
class HintsTest {
    @TempDir
    lateinit var folder: Path

    private fun classroom(exercise: Exercise = WITH_HINTS) = Classroom(folder, exercise = exercise)

    private suspend fun Visit.hints(student: String): JsonObject = look(student, HINTS).json()

    private suspend fun Visit.take(
        student: String,
        key: String? = null,
    ): HttpResponse =
        client.post(HINTS) {
            bearer(student)
            key?.let { header("Idempotency-Key", it) }
        }

    /** Sends a form as the button of the page does. */
    private suspend fun Visit.press(
        cookie: String,
        step: String,
        origin: String = "http://localhost",
    ): HttpResponse =
        client.post("/exercises/draw-dot/hints") {
            header(HttpHeaders.Host, "localhost")
            header(HttpHeaders.Origin, origin)
            header(HttpHeaders.Cookie, cookie)
            header(HttpHeaders.ContentType, "application/x-www-form-urlencoded")
            setBody("step=$step")
        }

    private suspend fun Visit.cookie(token: String): String {
        val answer =
            client.post("/sign-in") {
                header(HttpHeaders.Host, "localhost")
                header(HttpHeaders.Origin, "http://localhost")
                header(HttpHeaders.ContentType, "application/x-www-form-urlencoded")
                setBody("token=$token")
            }
        return checkNotNull(answer.headers[HttpHeaders.SetCookie]) { "${answer.status}" }.substringBefore(';')
    }

    private suspend fun Visit.page(
        path: String,
        cookie: String,
    ) = client.get(path) { header(HttpHeaders.Cookie, cookie) }.bodyAsText()

    /** The points of what is handed in now, once it is graded. */
    private suspend fun Visit.graded(student: String): Pair<String, JsonObject> {
        val id = submit(student).json().text("id")
        eventsToTheEnd(student, id)
        return id to points(student, id)
    }

    private suspend fun Visit.points(
        student: String,
        id: String,
    ) = look(student, "/api/v1/submissions/$id").json().getValue("points").jsonObject

    @Test
    @DisplayName("a hint is taken twice, or cannot be read again")
    fun eachStepIsRecordedOnceAndStays() =
        classroom().open(grades = false) {
            val student = newStudent()
            val before = hints(student)
            assertEquals("3", before.text("steps"))
            assertEquals(0, before.list("taken").size)
            assertEquals("1" to "1", before.getValue("next").let { it.field("step") to it.field("cost") })
            val answer = take(student, key = "first")
            assertEquals(201, answer.status.value)
            val first = answer.json()
            assertEquals("Look at one.", first.list("taken").single().field("text"))
            assertEquals(first, take(student, key = "first").json(), "the same request took another step")
            assertEquals(first, hints(student))
            assertEquals("Смотрите на 1.", look(student, "$HINTS?lang=ru").json().list("taken")[0].field("text"))
            take(student)
            val all = take(student).json()
            assertEquals(listOf("1", "2", "3"), all.list("taken").map { it.field("step") })
            assertEquals(JsonNull, all.getValue("next"))
            take(student).assertProblem(409, "no-more-hints")
            assertEquals(all, hints(student))
        }

    @Test
    @DisplayName("a hint is charged twice, charges what was handed in before, or is not told beside the points")
    fun aHintCostsOnceInWhatIsHandedInAfterwards() =
        classroom().open {
            val student = newStudent()
            val (before, free) = graded(student)
            assertEquals("4", free.text("total"))
            assertFalse("hints" in free, "hints are told where none were taken: $free")
            take(student)
            val (first, less) = graded(student)
            assertEquals(listOf("4", "1", "3"), listOf("accuracy", "hints", "total").map(less::text))
            take(student)
            assertEquals("1", graded(student).second.text("total"))
            assertEquals("3" to "4", points(student, first).text("total") to points(student, before).text("total"))
            val cookie = cookie(student)
            val result = page("/submissions/$first", cookie)
            assertTrue("−1 for hints" in result && "3 of 10" in result, result)
            assertTrue("−1 за подсказки" in page("/submissions/$first?lang=ru", cookie), "not told in Russian")
            val exercise = page("/exercises/draw-dot?lang=en", cookie)
            assertTrue("1 / 10" in exercise && "−3 for hints" in exercise && "4 / 10" in exercise, exercise)
            assertTrue("4 of 100" !in page("/exercises", cookie) && "best: 4 of" in page("/exercises", cookie))
        }

    @Test
    @DisplayName("hints take more points than were earned")
    fun pointsDoNotFallBelowNought() =
        classroom().open {
            val student = newStudent()
            repeat(3) { take(student) }
            val points = graded(student).second
            assertEquals("6" to "0", points.text("hints") to points.text("total"))
            assertTrue("best: 0 of" in page("/exercises", cookie(student)), page("/exercises", cookie(student)))
        }

    @Test
    @DisplayName("the page shows a hint before it is paid for, not what it costs, or one out of order")
    fun thePageTellsTheCostAndKeepsTheOrder() =
        classroom().open(grades = false) {
            val student = newStudent()
            val cookie = cookie(student)
            val before = page("/exercises/draw-dot", cookie)
            assertTrue("Hint 1 of 3 costs 1 point," in before && "Show hint 1</button>" in before, before)
            assertFalse("Look at" in before, "a hint is shown for nothing: $before")
            assertEquals(409, press(cookie, "2").status.value)
            assertTrue("one after another" in press(cookie, "3").bodyAsText(), "not told why")
            assertEquals(400, press(cookie, "first").status.value)
            assertEquals(0, hints(student).list("taken").size)
            repeat(2) { assertEquals("/exercises/draw-dot#hints", press(cookie, "1").headers[HttpHeaders.Location]) }
            assertEquals(1, hints(student).list("taken").size, "pressing twice took two")
            val after = page("/exercises/draw-dot", cookie)
            assertTrue("Look at <strong>one</strong>." !in after && "Look at one." in after, after)
            assertTrue("Hint 2 of 3 costs 2 points," in after, after)
            press(cookie, "2")
            press(cookie, "3")
            assertTrue("All hints are shown." in page("/exercises/draw-dot", cookie), "not told that these are all")
            assertTrue("already" in press(cookie, "4").bodyAsText(), "not told that there are no more")
        }

    @Test
    @DisplayName("one student sees or pays for another one's hints")
    fun othersHintsAreNotSeen() =
        classroom().open {
            val course = newCourse()
            val (one, other) = newStudent(course) to newStudent(course)
            take(one)
            assertEquals(0, hints(other).list("taken").size)
            assertFalse("Look at" in page("/exercises/draw-dot", cookie(other)), "another one's hint is shown")
            assertEquals("4", graded(other).second.text("total"))
        }

    @Test
    @DisplayName("a hint is given to somebody who is no student here, or the complaint is another")
    fun complaintsNameWhatIsWrong() =
        classroom().open(grades = false) {
            client.post(HINTS).assertProblem(401, "not-signed-in")
            client.get(HINTS).assertProblem(401, "not-signed-in")
            take(instructor).assertProblem(403, "wrong-role")
            val student = newStudent()
            val elsewhere = HINTS.replace("draw-dot", "draw-line")
            client.post(elsewhere) { bearer(student) }.assertProblem(404, "unknown-exercise")
            assertEquals(403, press(cookie(student), "1", origin = "http://elsewhere").status.value)
            assertEquals(0, hints(student).list("taken").size)
        }

    @Test
    fun anExerciseWithoutHintsHasNone() =
        classroom(Classroom.EXERCISE).open(grades = false) {
            val student = newStudent()
            assertEquals("0", hints(student).text("steps"))
            assertEquals(JsonNull, hints(student).getValue("next"))
            take(student).assertProblem(409, "no-more-hints")
            assertFalse("Hints" in page("/exercises/draw-dot", cookie(student)), "the page has hints")
        }

    @Test
    @DisplayName("the instructor does not see who was shown which hint, or a student does")
    fun theInstructorSeesWhoWasShownWhich() =
        classroom().open(grades = false) {
            val course =
                client
                    .post("/api/v1/courses") {
                        bearer(instructor)
                        json("""{"name":"Graphics"}""")
                    }.json()
            val student = newStudent(course.text("code"))
            val path = "/api/v1/courses/${course.text("course")}/exercises/draw-dot/hints"
            take(student)
            take(student)
            take(newStudent())
            val seen = Json.parseToJsonElement(look(instructor, path).bodyAsText()).jsonArray
            assertEquals(listOf("1" to "1", "2" to "2"), seen.map { it.field("step") to it.field("cost") })
            assertEquals(setOf("Ada"), seen.map { it.field("name") }.toSet())
            look(student, path).assertProblem(403, "wrong-role")
            look(instructor, path.replace("draw-dot", "x")).assertProblem(404, "unknown-exercise")
            look(instructor, "/api/v1/courses/x/exercises/draw-dot/hints").assertProblem(404, "unknown-course")
            val desk = page("/instructor", cookie(instructor))
            assertEquals(3, Regex("""<td>Ada</td>\s*<td>Draw a dot</td>""").findAll(desk).count(), desk)
        }

    private companion object {
        const val HINTS = "/api/v1/exercises/draw-dot/hints"

        val WITH_HINTS =
            with(Classroom.EXERCISE) {
                Exercise(
                    id(),
                    topic(),
                    contract(),
                    title(),
                    statement(),
                    pictures(),
                    starter(),
                    revision(),
                    tolerance(),
                    points(),
                    caps(),
                    timed(),
                    groups(),
                    cases(),
                    breaking(),
                    predicting(),
                    evidence(),
                    minutes(),
                    listOf("one", "two", "three").mapIndexed { i, word ->
                        Hint(mapOf("en" to "Look at $word.", "ru" to "Смотрите на ${i + 1}."), i + 1)
                    },
                )
            }
    }
}
