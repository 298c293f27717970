package rasterlab.grader.rules

import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.patch
import io.ktor.client.request.post
import io.ktor.client.request.put
import io.ktor.client.request.setBody
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource
import rasterlab.exercises.Grading
import rasterlab.exercises.score.GradingVerdict
import rasterlab.exercises.score.ScorePoints
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.assertProblem
import rasterlab.grader.bearer
import rasterlab.grader.cookieOf
import rasterlab.grader.field
import rasterlab.grader.json
import rasterlab.grader.list
import rasterlab.grader.one
import rasterlab.grader.problem.Rejection
import rasterlab.grader.text
import java.nio.file.Path
import java.time.Duration
import java.time.Instant
import java.util.Locale

/** Late work loses what its student agreed to, wherever points are told; each result here has 7 of 10. */
@Tag("slow")
class LatePenaltyTest {
    @TempDir
    lateinit var folder: Path
    private var now = Instant.parse("2027-03-01T12:00:00Z")

    private val grading =
        Grading { _, _, _, _ -> Classroom.report(GradingVerdict.WRONG, ScorePoints(4, 2, 1, 10)) }

    private fun classroom() = Classroom(folder, grading, clock = { now })

    @Test
    @DisplayName(
        "what lateness costs is not told before, or points are told without it on a page, by HTTP or in the marks",
    )
    fun costsWhereverPointsAreTold() =
        classroom().open {
            val course = newCourse()
            val ada = newStudent(course)
            rule(course, DAILY)
            val before = page(ada, "/exercises/draw-dot")
            assertTrue(
                "Each late day begun costs 25% of the points; an attempt counts until 2027-03-04 12:00 UTC." in before,
                before,
            )
            now += Duration.ofHours(30)
            submit(ada).assertProblem(409, "late-cost")
            assertTrue("now loses 50 % of its points" in submit(ada).bodyAsText())
            val asked = page(ada, "/exercises/draw-dot")
            assertTrue(
                "I submit late. The attempt counts, is marked as late and loses 50% of its points." in asked,
                asked,
            )
            val id = handIn(ada)
            val seen = look(ada, "/api/v1/submissions/$id").json()
            assertEquals("50", seen.text("penalty"))
            assertEquals(listOf("3", "4"), listOf("late", "total").map(seen.getValue("points")::field))
            val result = page(ada, "/submissions/$id")
            assertTrue("−3 for lateness (50%)" in result && "4 of 10" in result, result)
            assertTrue("−50% for lateness" in page(ada, "/exercises/draw-dot"))
            assertEquals("number,name,draw-dot,total\r\n1,Ada,4,4\r\n", marks(course))
            val given =
                client
                    .patch("/api/v1/submissions/$id/points") {
                        bearer(instructor)
                        json("""{"points":5,"reason":"fine"}""")
                    }.json()
            assertEquals("9", given.text("total"))
            assertEquals("9", look(ada, "/api/v1/submissions/$id").json().getValue("points").field("total"))
            val regrade =
                client
                    .post("/api/v1/courses/$course/exercises/draw-dot/regrade?dry=true") {
                        bearer(instructor)
                        json("""{"of":"all"}""")
                    }.json()
                    .text("regrade")
            look(instructor, "/api/v1/regrades/$regrade/events").bodyAsText()
            val change = look(instructor, "/api/v1/regrades/$regrade").json().list("changes").single()
            assertEquals(listOf("4", "4"), listOf("before", "after").map { change.field(it, "points") })
        }

    @Test
    @DisplayName("late work costs more than was agreed to, or not less when a deadline moves or a rule is milder")
    fun neverCostsMoreThanWasAgreedTo() =
        classroom().open {
            val course = newCourse()
            val ada = newStudent(course)
            val eve = newStudent(course)
            val student = one("SELECT id FROM students WHERE number = 1")
            rule(course, DAILY)
            val inTime = handIn(eve)
            now += Duration.ofHours(30)
            val id = handIn(ada)
            assertEquals("4", total(id))
            rule(course, """{"latePenalty":40}""")
            assertEquals("4", total(id), "a harsher rule costs more than was agreed to")
            rule(course, """{"deadline":"2027-03-01T00:00:00Z"}""")
            assertEquals("4" to "7", total(id) to total(inTime), "an earlier deadline makes work late")
            rule(course, DAILY)
            extend(course, student, "2027-03-02T00:00:00Z")
            assertEquals("6", total(id), "more time for one student is not taken off")
            extend(course, student, "")
            rule(course, """{"lateDays":1}""")
            assertEquals("6", total(id), "a covered late day costs something")
            rule(course, """{"latePenalty":0,"lateDays":null}""")
            assertEquals("7", total(id))
            assertEquals("number,name,draw-dot,total\r\n1,Ada,7,7\r\n2,Ada (2),7,7\r\n", marks(course))
        }

    @Test
    @DisplayName(
        "a page that was opened when lateness cost less takes more, or consent to nothing is consent to a cost",
    )
    fun theFormAgreesToWhatItShows() =
        classroom().open(grades = false) {
            val course = newCourse()
            val ada = newStudent(course)
            rule(course, DAILY)
            now += Duration.ofHours(20)
            assertTrue("""name="percent" value="25"""" in page(ada, "/exercises/draw-dot"))
            now += Duration.ofHours(10)
            for (shown in listOf("25", "0", "-1", "many")) {
                val refused = send(ada, shown)
                assertTrue(refused.status.value == 409 && "loses 50% of its points" in refused.bodyAsText(), shown)
            }
            assertEquals("0", one("SELECT count(*) FROM submissions"))
            assertEquals(302, send(ada, "50").status.value)
            assertEquals("50 50", one("SELECT penalty_agreed || ' ' || penalty FROM submissions"))
        }

    @Test
    @DisplayName("a percentage that is none is stored, or hidden cases are shown while points can be had")
    fun holdsItsRange() =
        classroom().open {
            val course = newCourse()
            for (wrong in listOf("101", "-1", "2.5", "\"much\"")) rule(course, """{"latePenalty":$wrong}""", 422)
            rule(course, DAILY)
            val id = handIn(newStudent(course))
            now += Duration.ofHours(72)
            assertEquals("false", look(instructor, "/api/v1/submissions/$id").json().text("opened"))
            now += Duration.ofMillis(1)
            assertEquals("true", look(instructor, "/api/v1/submissions/$id").json().text("opened"))
            assertEquals(
                "25",
                look(instructor, "/api/v1/courses/$course/exercises").json().list("exercises")[0].field("latePenalty"),
            )
        }

    @ParameterizedTest(name = "a number that {0} cannot have is answered with what another field would mean, in {2}")
    @CsvSource(
        "latePenalty, 101, en, or nothing for no penalty",
        "latePenalty, 101, ru, 'или ничего, если баллы не снимаются'",
        "attempts, 0, en, or nothing for no limit",
        "attempts, 0, ru, 'или ничего, если предела нет'",
    )
    fun tellsWhatNothingMeans(
        field: String,
        wrong: String,
        language: String,
        said: String,
    ) {
        val change = RuleChange(mapOf(RuleField.entries.first { it.code == field } to wrong))
        val refused = assertThrows(Rejection.BadRule::class.java) { change.of(ExerciseRules()) }
        val words = refused.said(Locale.forLanguageTag(language))
        assertTrue(words.endsWith(said), words)
    }

    private fun kotlinx.serialization.json.JsonElement.field(
        key: String,
        inner: String,
    ) = (this as kotlinx.serialization.json.JsonObject).getValue(key).field(inner)

    private suspend fun Visit.handIn(token: String): String {
        val id = submit(token, late = true).json().text("id")
        eventsToTheEnd(token, id)
        return id
    }

    private suspend fun Visit.total(id: String) =
        look(instructor, "/api/v1/submissions/$id").json().getValue("points").field("total")

    private suspend fun Visit.rule(
        course: String,
        body: String,
        status: Int = 200,
    ) = assertEquals(
        status,
        client
            .patch("/api/v1/courses/$course/exercises/draw-dot") {
                bearer(instructor)
                json(body)
            }.status.value,
    )

    private suspend fun Visit.extend(
        course: String,
        student: String,
        until: String,
    ) = client.put("/api/v1/courses/$course/exercises/draw-dot/extensions/$student") {
        bearer(instructor)
        json("""{"deadline":"$until","reason":"ill"}""")
    }

    private suspend fun Visit.marks(course: String) =
        look(instructor, "/api/v1/courses/$course/grades.csv").bodyAsText()

    private suspend fun Visit.page(
        token: String,
        path: String,
    ): String {
        val cookie = cookieOf(token)
        return client.get(path) { header(HttpHeaders.Cookie, cookie) }.bodyAsText()
    }

    private suspend fun Visit.send(
        token: String,
        percent: String,
    ) = cookieOf(token).let { cookie ->
        client.post("/exercises/draw-dot") {
            header(HttpHeaders.Cookie, cookie)
            header(HttpHeaders.Host, "localhost")
            header(HttpHeaders.Origin, "http://localhost")
            header(HttpHeaders.ContentType, "multipart/form-data; boundary=b")
            val fields = listOf("source" to "class Dot {}", "late" to "accept", "percent" to percent)
            setBody(
                fields.joinToString("") { (name, value) ->
                    "--b\r\nContent-Disposition: form-data; name=\"$name\"\r\n\r\n$value\r\n"
                } + "--b--\r\n",
            )
        }
    }

    private companion object {
        const val DAILY = """{"deadline":"2027-03-01T12:00:00Z","latePenalty":25}"""
    }
}
