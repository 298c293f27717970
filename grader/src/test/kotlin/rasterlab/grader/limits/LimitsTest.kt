package rasterlab.grader.limits

import io.ktor.client.request.header
import io.ktor.client.request.patch
import io.ktor.client.request.post
import io.ktor.client.request.setBody
import io.ktor.client.statement.HttpResponse
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource
import rasterlab.grader.Classroom
import rasterlab.grader.ServerSettings
import rasterlab.grader.Visit
import rasterlab.grader.assertProblem
import rasterlab.grader.bearer
import rasterlab.grader.commandLine
import rasterlab.grader.cookieOf
import rasterlab.grader.json
import rasterlab.grader.one
import rasterlab.grader.sendForm
import rasterlab.grader.text
import java.io.PrintWriter
import java.io.StringWriter
import java.nio.file.Path
import java.time.Duration
import java.time.Instant
import java.time.InstantSource

/** Comes up against the limits with a clock of the test's own, and reads what the answers say of them. */
@Tag("slow")
class LimitsTest {
    @TempDir
    lateinit var folder: Path

    private var now: Instant = Instant.parse("2027-03-01T20:00:00Z")

    private fun room(limits: IntakeLimits) =
        Classroom(
            folder,
            settings = ServerSettings(intake = limits, entriesPerMinute = 4),
            clock = InstantSource { now },
        )

    private fun HttpResponse.told() = NAMES.map { headers[it] }

    private suspend fun Visit.handIn(
        student: String,
        number: Int,
    ) = submit(student, "class Dot { int a$number; }")

    @Test
    @DisplayName("a student learns of the limit when it is reached, and has to guess when it ends")
    fun submissionsTellWhatIsLeft() =
        room(IntakeLimits(waiting = 9, perMinute = 2)).open(grades = false) {
            val student = newStudent()
            assertEquals(listOf("2;w=60", "2", "1", "60", null), handIn(student, 1).told())
            now += Duration.ofMillis(10_500)
            assertEquals(listOf("2;w=60", "2", "0", "50", null), handIn(student, 2).told())
            val refused = handIn(student, 3)
            refused.assertProblem(429, "too-fast")
            assertEquals(listOf("2;w=60", "2", "0", "50", "50"), refused.told())
            now += Duration.ofSeconds(50)
            assertEquals(listOf("2;w=60", "2", "0", "10", null), handIn(student, 4).told())
        }

    @Test
    @DisplayName("a full queue says when to come again, but not how many a minute may come")
    fun aFullQueueTellsBoth() =
        room(IntakeLimits(waiting = 1, perMinute = 9)).open(grades = false) {
            val student = newStudent()
            handIn(student, 1)
            val refused = handIn(student, 2)
            refused.assertProblem(429, "too-many-queued")
            assertEquals(listOf("9;w=60", "9", "8", "60", "5"), refused.told())
        }

    @Test
    @DisplayName("a course's own limit does not hold, holds elsewhere, or asks for more than the server allows")
    fun aCourseAllowsLess() =
        room(IntakeLimits(waiting = 9, perMinute = 8)).open(grades = false) {
            val course = newCourse()
            val (ada, elsewhere) = newStudent(course) to newStudent()
            assertEquals(STANDARD, limits(course, "{}").bodyAsText())
            val set = limits(course, """{"submissionsPerMinute":2,"waiting":"3"}""").bodyAsText()
            assertEquals(
                STANDARD.replace("submissionsPerMinute\":8,\"waiting\":9", "submissionsPerMinute\":2,\"waiting\":3"),
                set,
            )
            assertEquals(set, look(instructor, "/api/v1/courses/$course/limits").bodyAsText())
            assertEquals(listOf("2", "8"), listOf(ada, elsewhere).map { handIn(it, 1).headers["RateLimit-Limit"] })
            handIn(ada, 2)
            handIn(ada, 3).assertProblem(429, "too-fast")
            now += Duration.ofMinutes(1)
            handIn(ada, 4)
            handIn(ada, 5).assertProblem(429, "too-many-queued")
            for (wrong in listOf("9", "0", "\"x\"", "2.5")) {
                limits(course, """{"submissionsPerMinute":$wrong}""").assertProblem(422, "bad-rule")
            }
            for (wrong in listOf("[1]", "{}", """{"a":1}""")) {
                limits(course, """{"submissionsPerMinute":$wrong}""").assertProblem(400, "malformed-request")
            }
            limits(course, """{"perMinute":3}""").assertProblem(400, "malformed-request")
            limits(course, """{"waiting":3}""", ada).assertProblem(403, "wrong-role")
            assertEquals(set, look(instructor, "/api/v1/courses/$course/limits").bodyAsText())
            assertEquals("submissionsPerMinute 2, waiting 3", one("SELECT detail FROM audit WHERE action = 'limits'"))
            assertEquals(STANDARD, limits(course, """{"submissionsPerMinute":null,"waiting":null}""").bodyAsText())
        }

    @Test
    @DisplayName(
        "the page does not set a course's limits, loses what was typed where it is refused, or a clone has others",
    )
    fun thePageSetsThem() =
        room(IntakeLimits(waiting = 9, perMinute = 8)).open(grades = false) {
            val course = newCourse()
            val address = "/instructor/courses/$course"
            assertEquals(302, sendForm("$address/limits", "submissionsPerMinute=2&waiting=").status.value)
            val refused = sendForm("$address/limits", "submissionsPerMinute=77&waiting=1")
            assertEquals(422, refused.status.value)
            assertTrue("value=\"77\"" in refused.bodyAsText())
            val clone =
                client.post("/api/v1/courses/$course/clone") {
                    bearer(instructor)
                    json("""{"name":"Next year","days":364}""")
                }
            assertEquals(201, clone.status.value)
            val copied = look(instructor, "/api/v1/courses/${clone.json().text("course")}/limits").bodyAsText()
            assertEquals(STANDARD.replace("submissionsPerMinute\":8", "submissionsPerMinute\":2"), copied)
        }

    private suspend fun Visit.limits(
        course: String,
        body: String,
        by: String = instructor,
    ) = client.patch("/api/v1/courses/$course/limits") {
        bearer(by)
        json(body)
    }

    @Test
    @DisplayName("a request that is repeated costs another one, or tells nothing")
    fun repeatedRequestsCostNothing() =
        room(IntakeLimits(perMinute = 3)).open(grades = false) {
            val student = newStudent()
            val both = List(2) { submit(student, key = "the-same") }
            assertEquals(listOf("2", "2"), both.map { it.headers["RateLimit-Remaining"] })
        }

    @Test
    @DisplayName("a page hands in without a word on the limit")
    fun pagesTellIt() =
        room(IntakeLimits(waiting = 9, perMinute = 1)).open(grades = false) {
            val cookie = cookieOf(newStudent())
            val answers =
                List(2) { number ->
                    client.post("/exercises/draw-dot") {
                        header(HttpHeaders.Cookie, cookie)
                        header(HttpHeaders.Host, "localhost")
                        header(HttpHeaders.Origin, "http://localhost")
                        header(HttpHeaders.ContentType, "multipart/form-data; boundary=b")
                        setBody(field("source", "class Dot { int a$number; }") + field("once", "$number") + "--b--\r\n")
                    }
                }
            assertEquals(listOf(302, 429), answers.map { it.status.value })
            assertEquals(listOf("0", "0"), answers.map { it.headers["RateLimit-Remaining"] })
            assertEquals("60", answers.last().headers[HttpHeaders.RetryAfter])
        }

    private fun field(
        name: String,
        value: String,
    ) = "--b\r\nContent-Disposition: form-data; name=\"$name\"\r\n\r\n$value\r\n"

    @Test
    @DisplayName("joining and signing in tell nothing, or the wrong time")
    fun entriesTellWhatIsLeft() =
        room(IntakeLimits()).open(grades = false) {
            suspend fun join() = client.post("/api/v1/join") { json("{}") }
            val first = join()
            assertEquals(listOf("4;w=60", "4", "3"), first.told().take(3))
            assertTrue(first.headers["RateLimit-Reset"]!!.toInt() in 1..60)
            val signIn = client.post("/sign-in") { header(HttpHeaders.Origin, "http://localhost") }
            assertEquals("2", signIn.headers["RateLimit-Remaining"], "${signIn.status}")
            repeat(2) { join() }
            val refused = join()
            refused.assertProblem(429, "too-many-requests")
            assertEquals(listOf("4;w=60", "4", "0"), refused.told().take(3))
            assertEquals(refused.headers["RateLimit-Reset"], refused.headers[HttpHeaders.RetryAfter])
            assertTrue(refused.headers[HttpHeaders.RetryAfter]!!.toInt() in 1..60)
        }

    @ParameterizedTest(name = "--{0} {1} lets nobody in, or all")
    @CsvSource("entries-per-minute, 0", "submissions-per-minute, 100001", "waiting, -1")
    fun limitsHaveLimits(
        option: String,
        value: String,
    ) {
        val printed = StringWriter()
        val commands = commandLine().setErr(PrintWriter(printed, true))
        assertEquals(2, commands.execute("serve", "--port", "0", "--$option=$value"), "$printed")
        assertEquals("./lab grader serve: --$option $value: expected 1 to 100000", "$printed".trim())
    }

    private companion object {
        const val STANDARD = """{"submissionsPerMinute":8,"waiting":9,"mostPerMinute":8,"mostWaiting":9}"""
        val NAMES =
            listOf(
                "RateLimit-Policy",
                "RateLimit-Limit",
                "RateLimit-Remaining",
                "RateLimit-Reset",
                HttpHeaders.RetryAfter,
            )
    }
}
