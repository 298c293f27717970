package rasterlab.grader.rules

import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.patch
import io.ktor.client.request.post
import io.ktor.client.request.put
import io.ktor.client.request.setBody
import io.ktor.client.statement.HttpResponse
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import io.ktor.http.formUrlEncode
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
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
import rasterlab.grader.cookieOf
import rasterlab.grader.field
import rasterlab.grader.json
import rasterlab.grader.list
import rasterlab.grader.one
import rasterlab.grader.printedBy
import rasterlab.grader.text
import java.nio.file.Path
import java.time.Duration
import java.time.Instant

/** The rules of a course are set by its instructor alone, and what students hand in is taken by them. */
@Tag("slow")
class RuleRoutesTest {
    @TempDir
    lateinit var folder: Path
    private var now = Instant.parse("2027-03-01T12:00:00Z")

    private fun classroom() = Classroom(folder, clock = { now })

    @Test
    @DisplayName("a rule that is set is not told, takes another one away, or a time is not of the zone")
    fun setsWhatIsToldAndNothingElse() =
        classroom().open(grades = false) {
            val course = newCourse()
            val set =
                rule(
                    course,
                    """{"deadline":"2027-03-02T23:59","zone":"Europe/Moscow","lateDays":2,"attempts":3}""",
                ).json()
            assertEquals("2027-03-02T20:59:00.000Z", set.text("deadline"))
            val more = rule(course, """{"opens":"2027-03-01T00:00:00+01:00","policy":"last"}""").json()
            assertEquals(
                listOf("2027-02-28T23:00:00.000Z", "2027-03-02T20:59:00.000Z", "Europe/Moscow", "2", "3", "last"),
                listOf("opens", "deadline", "zone", "lateDays", "attempts", "policy").map(more::text),
            )
            val none = rule(course, """{"opens":"","lateDays":null,"attempts":""}""").json()
            assertEquals(listOf("null", "null", "null"), listOf("opens", "lateDays", "attempts").map(none::text))
            val listed = look(instructor, "/api/v1/courses/$course/exercises").json().list("exercises").single()
            assertEquals("2027-03-02T20:59:00.000Z" to "last", listed.field("deadline") to listed.field("policy"))
            assertEquals("3", one("SELECT count(*) FROM audit WHERE action = 'rules'"))
        }

    @Test
    @DisplayName("a rule that cannot hold is stored, its refusal does not tell place, value and what is allowed")
    fun refusesWhatCannotHold() =
        classroom().open(grades = false) {
            val course = newCourse()
            val refusals =
                mapOf(
                    """{"lateDays":-1}""" to "lateDays is '-1'; expected a whole number from 0 to 60",
                    """{"attempts":0}""" to "attempts is '0'; expected a whole number from 1 to 1,000",
                    """{"attempts":1.5}""" to "attempts is '1.5'",
                    """{"zone":"Moscow"}""" to "zone is 'Moscow'; expected a time zone such as Europe/Moscow",
                    """{"policy":"worst"}""" to "policy is 'worst', allowed are best, last, chosen",
                    """{"opens":"tomorrow"}""" to "opens is 'tomorrow'; expected a moment such as",
                    """{"opens":"2027-03-02T00:00Z","deadline":"2027-03-01T00:00Z"}""" to
                        "opens is 2027-03-02T00:00Z",
                )
            for ((body, said) in refusals) {
                val answer = rule(course, body)
                assertTrue(said in answer.bodyAsText(), answer.bodyAsText())
                answer.assertProblem(422, "bad-rule")
            }
            rule(course, """{"deadline":"+10000-01-01T00:00:00Z"}""").assertProblem(422, "bad-deadline")
            for (wrong in listOf("[1]", "{}")) {
                rule(course, """{"deadline":$wrong}""").assertProblem(400, "malformed-request")
            }
            rule(course, """{"weight":3}""").assertProblem(400, "malformed-request")
            rule(course, """{"attempts":3}""", by = newStudent(course)).assertProblem(403, "wrong-role")
            rule("none", """{"attempts":3}""").assertProblem(404, "unknown-course")
            look(newStudent(course), "/api/v1/courses/$course/exercises").assertProblem(403, "wrong-role")
            assertEquals("0", one("SELECT count(*) FROM course_exercises"))
        }

    @Test
    @DisplayName("work is taken before the exercise opens, or when all attempts are used")
    fun takesWhatIsOpenAndHasAnAttemptLeft() =
        classroom().open(grades = false) {
            val course = newCourse()
            val ada = newStudent(course)
            rule(course, """{"opens":"2027-03-01T12:00:01Z","attempts":2}""")
            submit(ada).assertProblem(409, "not-open")
            assertTrue("opens 2027-03-01 12:00 UTC" in page(ada, "/exercises"))
            now += Duration.ofSeconds(1)
            assertEquals("2", mine(ada).field("attemptsLeft"))
            val key = submit(ada, key = "first")
            assertEquals(202, key.status.value)
            submit(ada)
            assertEquals("0", mine(ada).field("attemptsLeft"))
            submit(ada).assertProblem(409, "no-attempts-left")
            assertEquals(202, submit(ada, key = "first").status.value, "a repeated request is refused")
            assertTrue("Attempts used: 2 of 2." in page(ada, "/exercises/draw-dot"))
            assertEquals(202, submit(newStudent(course)).status.value)
        }

    @Test
    @DisplayName("a late day is spent unasked, practice is not told to be such, or needs an attempt")
    fun asksBeforeALateDayIsSpent() =
        classroom().open(grades = false) {
            val course = newCourse()
            val ada = newStudent(course)
            rule(course, """{"deadline":"2027-03-01T12:00:00Z","lateDays":1,"attempts":1}""")
            assertTrue("One late day follows, until 2027-03-02 12:00 UTC" in page(ada, "/exercises/draw-dot"))
            now += Duration.ofHours(24)
            submit(ada).assertProblem(409, "late-day")
            assertTrue("I submit late and spend late day 1 of 1." in page(ada, "/exercises/draw-dot"))
            assertEquals(202, submit(ada, late = true).status.value)
            now += Duration.ofMillis(1)
            submit(ada).assertProblem(409, "late-practice")
            assertTrue("I submit for practice" in page(ada, "/exercises/draw-dot"))
            assertEquals(202, submit(ada, late = true).status.value)
        }

    @Test
    @DisplayName("an extension is another's too, shortens a deadline, or cannot be taken back")
    fun extendsTheDeadlineOfOneStudent() =
        classroom().open(grades = false) {
            val course = newCourse()
            val (ada, eve) = List(2) { newStudent(course) }
            val id = one("SELECT id FROM students WHERE number = 1")
            extend(course, id, "2027-03-02T12:00:00Z").assertProblem(422, "bad-rule")
            rule(course, """{"deadline":"2027-03-01T11:00:00Z"}""")
            extend(course, id, "2027-03-01T10:00:00Z").assertProblem(422, "bad-rule")
            extend(course, id, "2027-03-02T12:00:00Z", reason = "").assertProblem(422, "bad-rule")
            extend(course, "nobody", "2027-03-02T12:00:00Z").assertProblem(404, "unknown-student")
            extend(course, id, "2027-03-02T12:00:00Z", by = eve).assertProblem(403, "wrong-role")
            assertEquals("2027-03-02T12:00:00.000Z", extend(course, id, "2027-03-02T12:00:00Z").json().text("deadline"))
            assertEquals(202, submit(ada).status.value)
            submit(eve).assertProblem(409, "late")
            val told = look(instructor, "/api/v1/courses/$course/exercises").json().list("extensions").single()
            assertEquals("Ada" to "ill", told.field("name") to told.field("reason"))
            rule(course, """{"deadline":"2027-03-05T11:00:00Z"}""")
            assertEquals("2027-03-05T11:00:00.000Z", mine(ada).field("deadline"))
            rule(course, """{"deadline":"2027-03-01T11:00:00Z"}""")
            assertEquals("2027-03-01T11:00:00.000Z", extend(course, id, "").json().text("deadline"))
            submit(ada).assertProblem(409, "late")
        }

    @Test
    @DisplayName("another's attempt is chosen, two are at once, or one where the course rules otherwise")
    fun countsWhatTheStudentChooses() =
        classroom().open(grades = false) {
            val course = newCourse()
            val ada = newStudent(course)
            val (first, second) = List(2) { submit(ada, "class Dot { int n = $it; }").json().text("id") }
            choose(ada, first).assertProblem(409, "nothing-to-choose")
            rule(course, """{"policy":"chosen"}""")
            assertEquals("1", choose(ada, first).json().text("attempt"))
            choose(newStudent(course), second).assertProblem(404, "unknown-submission")
            choose(instructor, second).assertProblem(403, "wrong-role")
            assertTrue("The attempt that counts" in page(ada, "/exercises/draw-dot"))
            assertEquals(302, send("/chosen", "submission" to second, by = ada).status.value)
            assertEquals(second, one("SELECT id FROM submissions WHERE is_chosen = 1"))
        }

    private suspend fun Visit.choose(
        token: String,
        id: String,
    ) = client.put("/api/v1/submissions/$id/chosen") { bearer(token) }

    @Test
    @DisplayName("the page sets nothing, forgets what was typed, or is a student's")
    fun thePageSetsRules() =
        classroom().open(grades = false) {
            val course = newCourse()
            val ada = newStudent(course)
            val student = one("SELECT id FROM students")
            val page = "/instructor/courses/$course/exercises/draw-dot"
            val rules = arrayOf("deadline" to "2027-03-02T23:59", "zone" to "Europe/Moscow", "policy" to "last")
            assertEquals(302, send(page, *rules).status.value)
            assertTrue("2027-03-02 23:59 Europe/Moscow" in page(instructor, "/instructor/courses/$course/exercises"))
            val refused = send(page, "deadline" to "2027-04-02T23:59", "attempts" to "none")
            assertEquals(422, refused.status.value)
            val kept = refused.bodyAsText()
            assertTrue("2027-04-02T23:59" in kept && "attempts is &#39;none&#39;" in kept.replace("'", "&#39;"), kept)
            send("$page/extensions", "student" to student, "until" to "2027-03-04T23:59", "reason" to "ill")
            assertTrue("2027-03-04 23:59 Europe/Moscow (ill)" in page(instructor, page), page(instructor, page))
            send("$page/extensions", "student" to student)
            assertTrue("Nobody has more time." in page(instructor, page))
            val cookie = cookieOf(ada)
            assertEquals(403, client.get(page) { header(HttpHeaders.Cookie, cookie) }.status.value)
            assertEquals(403, send(page, "attempts" to "9", by = ada).status.value)
        }

    @Test
    @DisplayName("the command sets nothing, or takes an exercise or a student that there is not")
    fun theCommandSetsRulesToo() =
        classroom().open(grades = false) {
            val course = newCourse()
            newStudent(course)
            val student = one("SELECT id FROM students")
            val set =
                command(
                    "rules",
                    course,
                    EXERCISE,
                    "--deadline",
                    "2027-03-02T23:59",
                    "--zone",
                    "Europe/Moscow",
                    "--attempts",
                    "3",
                )
            assertTrue("deadline\t2027-03-02T20:59:00.000Z" in set && "attempts\t3" in set, set)
            val until = arrayOf("--until", "2027-03-04T00:00Z", "--reason", "ill")
            assertEquals(
                "deadline\t2027-03-04T00:00:00.000Z",
                command("extend", course, EXERCISE, student, *until).trim(),
            )
            assertTrue("extension\t$student\tAda\t2027-03-04T00:00:00.000Z\till" in command("rules", course, EXERCISE))
            assertTrue("задания «none» нет" in command("rules", course, "none", "--lang", "ru", exit = 2))
            assertTrue(
                "целое число от" in command("rules", course, EXERCISE, "--attempts", "0", "--lang", "ru", exit = 2),
            )
            assertTrue("nobody" in command("extend", course, EXERCISE, "nobody", *until, exit = 2))
        }

    private suspend fun Visit.rule(
        course: String,
        body: String,
        by: String = instructor,
    ) = client.patch("/api/v1/courses/$course/exercises/draw-dot") {
        bearer(by)
        json(body)
    }

    private suspend fun Visit.extend(
        course: String,
        student: String,
        until: String,
        reason: String = "ill",
        by: String = instructor,
    ) = client.put("/api/v1/courses/$course/exercises/draw-dot/extensions/$student") {
        bearer(by)
        json("""{"deadline":"$until","reason":"$reason"}""")
    }

    private suspend fun Visit.mine(token: String) =
        Json
            .parseToJsonElement(look(token, "/api/v1/exercises").bodyAsText())
            .jsonArray
            .single()
            .jsonObject

    private suspend fun Visit.page(
        token: String,
        path: String,
    ): String {
        val cookie = cookieOf(token)
        return client.get("$path?lang=en") { header(HttpHeaders.Cookie, cookie) }.bodyAsText()
    }

    private suspend fun Visit.send(
        path: String,
        vararg fields: Pair<String, String>,
        by: String = instructor,
    ): HttpResponse {
        val cookie = cookieOf(by)
        return client.post(path) {
            header(HttpHeaders.Cookie, cookie)
            header(HttpHeaders.Host, "localhost")
            header(HttpHeaders.Origin, "http://localhost")
            header(HttpHeaders.ContentType, "application/x-www-form-urlencoded")
            setBody(fields.toList().formUrlEncode())
        }
    }

    private fun command(
        vararg arguments: String,
        exit: Int = 0,
    ) = printedBy(folder, "course", *arguments, exit = exit)

    private companion object {
        /** One that comes with the program, as the command knows no others here. */
        const val EXERCISE = "line-bresenham"
    }
}
