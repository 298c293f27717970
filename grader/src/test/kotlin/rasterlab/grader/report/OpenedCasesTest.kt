package rasterlab.grader.report

import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.patch
import io.ktor.client.request.post
import io.ktor.client.request.put
import io.ktor.client.request.setBody
import io.ktor.client.statement.bodyAsBytes
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonObject
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.exercises.Exercise
import rasterlab.exercises.Grading
import rasterlab.exercises.score.Disclosure
import rasterlab.exercises.score.GradingVerdict
import rasterlab.exercises.score.Report
import rasterlab.exercises.score.ScorePoints
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.assertProblem
import rasterlab.grader.bearer
import rasterlab.grader.json
import rasterlab.grader.list
import rasterlab.grader.text
import java.nio.file.Path
import java.time.Duration
import java.time.Instant

/** Hidden cases are opened by the deadline, neither earlier nor for anybody else. */
class OpenedCasesTest {
    @TempDir
    lateinit var folder: Path
    private var now = Instant.parse("2026-03-28T10:00:00Z")

    private fun classroom() =
        Classroom(
            folder,
            grading =
                Grading { _, _, _, progress ->
                    report().also { it.cases().forEach(progress::accept) }
                },
            exercise = exercise(),
            clock = { now },
        )

    /** The visible parts of each hidden case: message, picture, scene and reason. */
    private suspend fun Visit.seen(
        token: String,
        id: String,
        language: String = "en",
    ): Map<String, JsonObject> =
        look(token, "/api/v1/submissions/$id?lang=$language")
            .json()
            .list("cases")
            .map { it.jsonObject }
            .associateBy { it.text("visibility") }

    private suspend fun Visit.page(
        token: String,
        path: String,
    ): String {
        val cookie =
            client
                .post("/sign-in") {
                    header(HttpHeaders.Host, "localhost")
                    header(HttpHeaders.Origin, "http://localhost")
                    header(HttpHeaders.ContentType, "application/x-www-form-urlencoded")
                    setBody("token=$token")
                }.headers[HttpHeaders.SetCookie]
                .orEmpty()
                .substringBefore(';')
        return client.get(path) { header(HttpHeaders.Cookie, cookie) }.bodyAsText()
    }

    /** A course of its own, with the deadline; its student and what that has handed in. */
    private suspend fun Visit.handedIn(due: Instant?): Triple<String, String, String> {
        val course =
            client
                .post("/api/v1/courses") {
                    bearer(instructor)
                    json("""{"name":"Graphics"}""")
                }.json()
        if (due != null) setDeadline(course.text("course"), due.toString())
        val student = newStudent(course.text("code"))
        val id = submit(student, late = due != null).json().text("id")
        eventsToTheEnd(student, id)
        return Triple(course.text("course"), student, id)
    }

    private suspend fun Visit.setDeadline(
        course: String,
        due: String,
    ) = assertEquals(
        200,
        client
            .patch("/api/v1/courses/$course/exercises/draw-dot") {
                bearer(instructor)
                json("""{"deadline":"$due"}""")
            }.status.value,
    )

    private fun case(id: String) = "/api/v1/submissions/$id/cases/hidden-after-deadline"

    @Test
    @DisplayName("something of a hidden case is told before the deadline, or not all of it after")
    fun hiddenCaseIsOpenedByTheDeadline() =
        classroom().open {
            val due = now + Duration.ofHours(1)
            val (course, student, id) = handedIn(due)
            now = due
            assertHidden(student, id)
            now = due + Duration.ofMillis(1)
            val opened = seen(student, id).getValue("after-deadline")
            assertTrue(opened.text("message").startsWith("secret of hidden-after-deadline"), opened.toString())
            assertEquals(4, opened.list("pictures").size)
            assertTrue("from" in opened.getValue("scene").jsonObject, opened.toString())
            assertTrue("it asks what the open cases ask" in opened.text("why"), opened.text("why"))
            assertTrue("a segment of one point is not drawn" in opened.text("why"), opened.text("why"))
            val russian = seen(student, id, "ru").getValue("after-deadline").text("why")
            assertTrue("отрезок из одной точки не рисуется" in russian, russian)
            assertArrayEquals(byteArrayOf(2), look(student, "${case(id)}/actual.png").bodyAsBytes())
            assertEquals(200, look(student, "${case(id)}/scene.json").status.value)
            val page = page(student, "/submissions/$id?lang=en")
            assertTrue("secret of hidden-after-deadline" in page, page)
            assertTrue("Why this case is there: it asks" in page, page)
            assertTrue("The deadline was 2026-03-28 11:00 UTC: hidden cases are shown" in page, page)
            setDeadline(course, (now + Duration.ofHours(1)).toString())
            assertHidden(student, id)
        }

    private suspend fun Visit.assertHidden(
        student: String,
        id: String,
    ) {
        val hidden = seen(student, id).getValue("after-deadline")
        assertEquals("wrong pixels on a hidden input", hidden.text("message"))
        assertEquals(0, hidden.list("pictures").size)
        assertEquals(JsonNull, hidden.getValue("scene"))
        assertFalse("why" in hidden, hidden.toString())
        look(student, "${case(id)}/actual.png").assertProblem(404, "unknown-picture")
        look(student, "${case(id)}/scene.json").assertProblem(404, "unknown-scene")
        val told =
            page(student, "/submissions/$id?lang=en") +
                page(student, "/submissions/$id/fragment") +
                look(student, "/api/v1/submissions/$id/events").bodyAsText()
        assertFalse("secret of hidden" in told, told)
        assertFalse("Why this case" in told, told)
        assertTrue("After it, hidden cases are shown with everything" in told, told)
    }

    @Test
    @DisplayName("a hidden case is opened while a late day, or another's extension, still lets somebody earn points")
    fun hiddenCaseIsOpenedWhenNobodyCanEarnPointsAnyMore() =
        classroom().open {
            val due = now
            val (course, student, id) = handedIn(due)
            val address = "/api/v1/courses/$course/exercises/draw-dot"
            client.patch(address) {
                bearer(instructor)
                json("""{"lateDays":1}""")
            }
            now = due + Duration.ofHours(24)
            assertStillHidden(student, id, "From 2026-03-29 10:00 UTC on, hidden cases are shown")
            now += Duration.ofMillis(1)
            assertEquals(4, pictures(student, id))
            val ill = classmate(course)
            client.put("$address/extensions/$ill") {
                bearer(instructor)
                json("""{"deadline":"${due + Duration.ofHours(48)}","reason":"ill"}""")
            }
            now = due + Duration.ofHours(72)
            assertStillHidden(student, id, "Hidden cases are shown with everything when nobody can submit")
            now += Duration.ofMillis(1)
            assertEquals(4, pictures(student, id))
        }

    private suspend fun Visit.pictures(
        student: String,
        id: String,
    ) = seen(student, id).getValue("after-deadline").list("pictures").size

    private suspend fun Visit.assertStillHidden(
        student: String,
        id: String,
        promise: String,
    ) {
        assertEquals(0, pictures(student, id))
        val result = page(student, "/submissions/$id?lang=en")
        assertTrue("Hidden cases are shown with everything when nobody can submit" in result, result)
        val exercise = page(student, "/exercises/draw-dot?lang=en")
        assertTrue(promise in exercise, exercise)
    }

    /** The id of one more student of the course. */
    private suspend fun Visit.classmate(course: String): String {
        val code =
            database.read {
                it
                    .createQuery("SELECT code FROM courses WHERE id = ?")
                    .bind(0, course)
                    .mapTo(String::class.java)
                    .one()
            }
        newStudent(code)
        return database.read {
            it
                .createQuery(
                    "SELECT id FROM students WHERE number = 2",
                ).mapTo(String::class.java)
                .one()
        }
    }

    @Test
    @DisplayName("a case that stays hidden is opened by the deadline, or is hidden from the instructor")
    fun deadlineOpensOnlyWhatItIsToOpen() =
        classroom().open {
            val (_, student, id) = handedIn(now - Duration.ofHours(1))
            val seen = seen(student, id)
            for (visibility in listOf("verdict-only", "never")) {
                val hidden = seen.getValue(visibility)
                assertEquals("wrong pixels on a hidden input", hidden.text("message"), visibility)
                assertFalse("why" in hidden, hidden.toString())
            }
            assertEquals("hidden", seen.getValue("never").text("name"))
            for (hidden in seen(instructor, id).filterKeys { it != "open" }.values) {
                assertTrue("secret of hidden" in hidden.text("message"), hidden.toString())
                assertTrue("why" in hidden, hidden.toString())
            }
        }

    @Test
    @DisplayName("the deadline of one course opens cases of another")
    fun deadlineIsThatOfTheStudentsCourse() =
        classroom().open {
            val (_, student, id) = handedIn(due = null)
            handedIn(now - Duration.ofHours(1))
            val hidden = seen(student, id).getValue("after-deadline")
            assertEquals("wrong pixels on a hidden input", hidden.text("message"))
            assertEquals(JsonNull, look(student, "/api/v1/submissions/$id").json().getValue("deadline"))
        }

    @Test
    @DisplayName("what comes late is not graded, not told to be late, or what is in time is")
    fun lateAttemptIsGradedAndMarked() =
        classroom().open {
            val due = now
            val (_, student, inTime) = handedIn(due)
            now = due + Duration.ofMillis(1)
            val late = submit(student, late = true).json().text("id")
            eventsToTheEnd(student, late)
            for ((id, expected) in listOf(inTime to "false", late to "true")) {
                val view = look(student, "/api/v1/submissions/$id").json()
                assertEquals(expected, view.text("late"), id)
                assertEquals("2026-03-28T10:00:00.000Z", view.text("deadline"))
                assertEquals("wrong", view.text("verdict"))
                val page = page(student, "/submissions/$id?lang=en")
                assertEquals(expected == "true", "Submitted late, after 2026-03-28 10:00 UTC" in page, page)
            }
            val exercise = page(student, "/exercises/draw-dot?lang=en")
            assertTrue(
                "The deadline was 2026-03-28 10:00 UTC. You can still submit if you agree" in exercise,
                exercise,
            )
            assertEquals(1, Regex("class=\"late\"").findAll(exercise).count(), exercise)
            assertTrue("""<span class="late">с опозданием""" in page(instructor, "/instructor/latest?lang=ru"))
        }

    @Test
    @DisplayName("a deadline that is set into the past makes late what came when none had passed")
    fun deadlineThatIsSetIntoThePastMakesNothingLate() =
        classroom().open {
            for (due in listOf(null, now + Duration.ofHours(2))) {
                val (course, student, before) = handedIn(due)
                now += Duration.ofMinutes(1)
                setDeadline(course, (now - Duration.ofHours(1)).toString())
                val after = submit(student, late = true).json().text("id")
                eventsToTheEnd(student, after)
                for ((id, expected) in listOf(before to "false", after to "true")) {
                    assertEquals(expected, look(student, "/api/v1/submissions/$id").json().text("late"), "$due")
                }
                val exercise = page(student, "/exercises/draw-dot?lang=en")
                assertEquals(1, Regex("class=\"late\"").findAll(exercise).count(), exercise)
                setDeadline(course, (now + Duration.ofHours(1)).toString())
                assertEquals("false", look(student, "/api/v1/submissions/$after").json().text("late"), "put off")
            }
        }

    @Test
    @DisplayName("an exercise without hidden cases promises to show them, or a deadline that is over is to come")
    fun deadlineWithoutHiddenCases() =
        Classroom(folder, clock = { now }).open {
            val due = now + Duration.ofHours(1)
            val (_, student, id) = handedIn(due)
            for (path in listOf("/submissions/$id", "/exercises/draw-dot")) {
                val page = page(student, "$path?lang=en")
                assertTrue("Deadline: 2026-03-28 11:00 UTC." in page, page)
                assertFalse("hidden cases" in page, page)
            }
            val before = page(student, "/exercises?lang=en")
            assertTrue("submit by 2026-03-28 11:00 UTC" in before, before)
            now = due + Duration.ofMillis(1)
            val result = page(student, "/submissions/$id?lang=en")
            assertTrue("The deadline was 2026-03-28 11:00 UTC.<" in result, result)
            val after = page(student, "/exercises?lang=en")
            assertTrue("the deadline was 2026-03-28 11:00 UTC" in after, after)
        }

    private companion object {
        val HIDDEN = listOf(Disclosure.AFTER_DEADLINE, Disclosure.VERDICT_ONLY, Disclosure.NEVER)

        fun report() =
            Report(
                GradingVerdict.WRONG,
                ScorePoints(0, 0, 0, 20),
                (listOf(Disclosure.OPEN) + HIDDEN).map { Classroom.case(name(it), it, GradingVerdict.WRONG) },
                emptyList(),
                "",
                0.0,
            )

        fun name(visibility: Disclosure) =
            if (visibility == Disclosure.OPEN) "open-case" else "hidden-${visibility.code()}"

        /** An exercise of which only a single point is hidden, as no open case has one. */
        fun exercise(): Exercise {
            val plain = Classroom.EXERCISE
            val segment = """{"given":{"from":[0,0],"to":[7,3]}}"""
            val point = """{"given":{"from":[4,3],"to":[4,3]}}"""
            return Exercise(
                plain.id(),
                plain.topic(),
                plain.title(),
                plain.statement(),
                plain.pictures(),
                plain.starter(),
                plain.revision(),
                plain.tolerance(),
                plain.points(),
                (listOf(Disclosure.OPEN) + HIDDEN).map {
                    Exercise.Case(
                        name(it),
                        mapOf("en" to name(it)),
                        Exercise.Criterion.ACCURACY,
                        it,
                        5,
                        if (it == Disclosure.OPEN) segment else point,
                        false,
                    )
                },
            )
        }
    }
}
