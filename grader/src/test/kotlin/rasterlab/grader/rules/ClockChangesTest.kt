package rasterlab.grader.rules

import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.patch
import io.ktor.client.request.put
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import io.ktor.http.formUrlEncode
import kotlinx.serialization.json.jsonPrimitive
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
import rasterlab.grader.json
import rasterlab.grader.list
import rasterlab.grader.one
import rasterlab.grader.printedBy
import rasterlab.grader.sendForm
import rasterlab.grader.text
import rasterlab.grader.web.PageTexts
import java.nio.file.Path
import java.time.Instant

/** Times are told in the zone of the course, and are what was typed, also in the nights in which clocks are changed. */
@Tag("slow")
class ClockChangesTest {
    @TempDir
    lateinit var folder: Path

    private fun classroom() = Classroom(folder, clock = { Instant.parse("2027-03-01T12:00:00Z") })

    @Test
    @DisplayName(
        "a deadline in the hour that clocks skip is moved, or its refusal lacks place, value or what is allowed",
    )
    fun refusesATimeThatDoesNotCome() =
        classroom().open(grades = false) {
            val course = newCourse()
            newStudent(course)
            val said =
                "deadline is '$SKIPPED', which the clocks of Europe/Berlin skip; expected a time before " +
                    "2027-03-28T02:00 or from 2027-03-28T03:00 on, or one with its offset such as 2027-03-28T02:30+01:00"
            val refused = rule(course, """{"deadline":"$SKIPPED","zone":"Europe/Berlin"}""")
            assertTrue(said in refused.json().text("detail"), refused.bodyAsText())
            refused.assertProblem(422, "bad-deadline")
            val fields = listOf("deadline" to SKIPPED, "zone" to "Europe/Berlin")
            val page = sendForm("/instructor/courses/$course/exercises/draw-dot?lang=ru", fields.formUrlEncode())
            assertEquals(422, page.status.value)
            assertTrue("начиная с 2027-03-28T03:00" in page.bodyAsText(), page.bodyAsText())
            val arguments = arrayOf("--deadline", SKIPPED, "--zone", "Europe/Berlin")
            assertTrue(said in printedBy(folder, "course", "rules", course, EXERCISE, *arguments, exit = 2))
            rule(course, """{"deadline":"2027-03-01T23:00","zone":"Europe/Berlin"}""")
            extend(course, SKIPPED).assertProblem(422, "bad-deadline")
            val id = one("SELECT id FROM courses")
            val exam = EXAM + listOf("opens" to "2027-03-28T01:00", "closes" to SKIPPED)
            val made = sendForm("/instructor/courses/$id/exams", exam.formUrlEncode())
            assertEquals(422, made.status.value, made.bodyAsText())
            assertEquals("2027-03-01T22:00:00.000Z", one("SELECT max(due_at) FROM course_exercises"))
            assertEquals("0", one("SELECT count(*) FROM extensions"))
        }

    @Test
    @DisplayName("of an hour that comes twice the earlier one is the deadline, or nobody is told which one is taken")
    fun tellsWhichOfTwoIsTaken() =
        classroom().open(grades = false) {
            val course = newCourse()
            newStudent(course)
            val set = rule(course, """{"opens":"$TWICE","deadline":"2027-11-01T00:00","zone":"Europe/Berlin"}""").json()
            assertEquals("2027-10-31T00:30:00.000Z", set.text("opens"), "students can begin later than at the first")
            val due = rule(course, """{"opens":"","deadline":"$TWICE"}""").json()
            assertEquals("2027-10-31T01:30:00.000Z", due.text("deadline"))
            val said =
                "deadline is $TWICE, which the clocks of Europe/Berlin show twice; the later one is taken, $TWICE+01:00"
            assertEquals(listOf(said), due.list("notes").map { it.jsonPrimitive.content })
            val address = "/instructor/courses/$course/exercises/draw-dot"
            assertTrue(said in page(instructor, address), page(instructor, address))
            val arguments = arrayOf("--deadline", TWICE, "--zone", "Europe/Berlin", "--lang", "ru")
            val told = printedBy(folder, "course", "rules", course, EXERCISE, *arguments)
            assertTrue("взято более позднее, $TWICE+01:00" in told, told)
            val earlier = rule(course, """{"deadline":"$TWICE+02:00"}""").json()
            assertTrue(
                "the earlier one is taken" in
                    earlier
                        .list("notes")
                        .single()
                        .jsonPrimitive.content,
            )
            sendForm(address, listOf("deadline" to "$TWICE:00", "attempts" to "3").formUrlEncode())
            assertEquals("2027-10-31T00:30:00.000Z", one("SELECT due_at FROM course_exercises WHERE attempts = 3"))
            rule(course, """{"deadline":"2027-10-30T12:00"}""")
            assertEquals("2027-10-31T01:30:00.000Z", extend(course, TWICE).json().text("deadline"))
            assertEquals(1, extend(course, TWICE).json().list("notes").size)
        }

    @Test
    @DisplayName("what is refused since it is too early is told in another zone than it was typed in")
    fun refusesInTheZoneOfTheRules() =
        classroom().open(grades = false) {
            val course = newCourse()
            newStudent(course)
            val refused =
                rule(course, """{"opens":"2027-04-02T08:00","deadline":"2027-04-01T08:00","zone":"Europe/Berlin"}""")
            assertEquals(
                "opens is 2027-04-02T08:00+02:00, but the deadline is 2027-04-01T08:00+02:00; expected an earlier moment",
                refused.json().text("detail"),
            )
            rule(course, """{"deadline":"2027-04-01T08:00","zone":"Europe/Berlin"}""")
            val earlier = extend(course, "2027-03-01T08:00").json().text("detail")
            assertTrue("2027-03-01T08:00+01:00 is not after" in earlier && "2027-04-01T08:00+02:00" in earlier, earlier)
            val exam = EXAM + listOf("opens" to "2027-04-02T08:00", "closes" to "2027-04-01T08:00")
            val made =
                sendForm(
                    "/instructor/courses/${one("SELECT id FROM courses")}/exams",
                    exam.formUrlEncode(),
                ).bodyAsText()
            assertTrue("opens is 2027-04-02T08:00+02:00" in made, made)
        }

    @Test
    @DisplayName("a page tells a time in another zone than that of the course, or does not name the zone")
    fun tellsOneZone() =
        classroom().open {
            val course = newCourse()
            val ada = newStudent(course)
            val id = handIn(ada).text("id")
            rule(course, """{"deadline":"2027-03-01T23:59","zone":"Europe/Moscow"}""")
            eventsToTheEnd(ada, id)
            val here = one("SELECT id FROM courses")
            val received = "2027-03-01 15:00"
            val due = "2027-03-01 23:59 Europe/Moscow"
            val student = one("SELECT id FROM students")
            val pages =
                listOf(
                    ada to "/exercises" to due,
                    ada to "/exercises/draw-dot" to due,
                    ada to "/exercises/draw-dot" to "Received (Europe/Moscow)",
                    ada to "/submissions/$id" to "Deadline: $due.",
                    ada to "/submissions/$id" to "Received $received Europe/Moscow",
                    instructor to "/submissions/$id" to "Received $received Europe/Moscow",
                    instructor to "/instructor/courses/$here/exercises" to due,
                    instructor to "/instructor/courses/$here/exercises/draw-dot/stuck" to "Europe/Moscow",
                    instructor to "/instructor/students/$student" to "Received (Europe/Moscow)",
                    instructor to "/instructor" to "Received (Europe/Moscow)",
                )
            for ((place, said) in pages) {
                val shown = page(place.first, place.second)
                assertTrue(said in shown, "${place.second}: $shown")
                assertFalse("UTC" in shown, "${place.second}: $shown")
            }
        }

    @Test
    @DisplayName("a course counts as several zones on pages of all courses, or courses of different zones as one")
    fun tellsTheZoneOfEachCourse() =
        classroom().open(grades = false) {
            val mixed = newCourse()
            val due = "2027-03-01T23:59"
            rule(mixed, """{"deadline":"$due","zone":"Europe/Berlin"}""")
            val id = one("SELECT id FROM courses WHERE code = '$mixed'")
            val times = listOf("opens" to due, "closes" to "2027-03-02T01:59", "zone" to "Europe/Moscow")
            val exam = (EXAM.toMap() + times).toList().formUrlEncode()
            assertEquals(302, sendForm("/instructor/courses/$id/exams", exam).status.value)
            newCourse()
            val audit = "/instructor/audit"
            assertTrue(told("Europe/Berlin") in page(instructor, audit), page(instructor, audit))
            rule(newCourse(), """{"deadline":"$due","zone":"Europe/Moscow"}""")
            assertTrue(told("UTC") in page(instructor, audit), page(instructor, audit))
        }

    private fun told(zone: String) = PageTexts.of("en").say("audit.about", zone)

    private suspend fun Visit.handIn(token: String) = submit(token, "class Dot {}").json()

    private suspend fun Visit.rule(
        course: String,
        body: String,
    ) = client.patch("/api/v1/courses/$course/exercises/draw-dot") {
        bearer(instructor)
        json(body)
    }

    private suspend fun Visit.extend(
        course: String,
        until: String,
    ) = client.put("/api/v1/courses/$course/exercises/draw-dot/extensions/${one("SELECT id FROM students")}") {
        bearer(instructor)
        json("""{"deadline":"$until","reason":"ill"}""")
    }

    private suspend fun Visit.page(
        token: String,
        path: String,
    ): String {
        val cookie = cookieOf(token)
        return client.get("$path?lang=en") { header(HttpHeaders.Cookie, cookie) }.bodyAsText()
    }

    private companion object {
        /** One that comes with the program, as the command knows no others here. */
        const val EXERCISE = "line-bresenham"

        /** Clocks in Berlin go from 2 to 3 that night, and from 3 to 2 in the other. */
        const val SKIPPED = "2027-03-28T02:30"
        const val TWICE = "2027-10-31T02:30"

        val EXAM =
            listOf(
                "name" to "Midterm",
                "zone" to "Europe/Berlin",
                "minutes" to "30",
                "starts" to "first",
                "grace" to "30",
                "addresses" to "",
                "second" to "refuse",
                "exercise" to "draw-dot",
            )
    }
}
