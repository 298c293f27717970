package rasterlab.grader.classroom

import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.put
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonObject
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.exercises.Grading
import rasterlab.exercises.score.GradingVerdict
import rasterlab.exercises.score.Report
import rasterlab.exercises.score.ScorePoints
import rasterlab.exercises.score.SpeedFigures
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.assertProblem
import rasterlab.grader.bearer
import rasterlab.grader.cookieOf
import rasterlab.grader.json
import rasterlab.grader.list
import rasterlab.grader.sendForm
import rasterlab.grader.text
import java.nio.file.Path
import java.util.Optional

/** A class sees its speeds and errors without names, each student the own one marked; staff see the names. */
@Tag("slow")
class ClassFrontTest {
    @TempDir
    lateinit var folder: Path

    /** Takes as many nanoseconds as stand in the source; the reference takes 2. */
    private val bySource =
        Grading { _, source, _, _ ->
            val nanos = source.filter { it.isDigit() }.toDouble()
            Report(GradingVerdict.OK, ScorePoints(6, 3, 1, 10), emptyList(), emptyList(), "", nanos)
                .with(Optional.of(SpeedFigures(nanos, 2.0, 0.5, emptyList())))
        }

    private suspend fun Visit.hand(
        course: String,
        nanos: Int,
    ): String {
        val token = newStudent(course)
        eventsToTheEnd(token, submit(token, "class Dot { /* $nanos */ }").json().text("id"))
        return token
    }

    private fun JsonObject.points() = list("points").map { it.jsonObject }

    @Test
    @DisplayName("a student is told whose a point is, is shown so few that it can be told, or sees another course's")
    fun hidesWhoseThePointsAre() =
        Classroom(folder, bySource).open {
            val course = newCourse()
            hand(newCourse(), 9)
            val ada = hand(course, 6)
            (1..3).forEach { hand(course, it) }
            assertEquals(
                listOf("3.0" to "true"),
                look(ada, OWN).json().points().map {
                    it.text("ratio") to
                        it.text("own")
                },
            )
            hand(course, 40)
            val seen = look(ada, OWN).json().points()
            assertEquals(listOf("0.5", "1.0", "1.5", "3.0", "20.0"), seen.map { it.text("ratio") })
            assertEquals(listOf("3.0"), seen.filter { it.text("own") == "true" }.map { it.text("ratio") })
            assertEquals(setOf("ratio", "low", "high", "error", "own", "name"), seen.flatMap { it.keys }.toSet())
            assertEquals(setOf("null"), seen.map { it.text("name") }.toSet())
            look(ada, "/api/v1/courses/$course/$FRONT").assertProblem(403, "wrong-role")
        }

    private suspend fun Visit.name(
        who: String,
        named: String,
    ) = client.put("/api/v1/front-name") {
        bearer(who)
        json(named)
    }

    @Test
    @DisplayName(
        "a name is told unasked, not when its student wants it, still when no longer, or leaves too few to hide among",
    )
    fun namesThoseWhoWantIt() =
        Classroom(folder, bySource).open {
            val course = newCourse()
            val students = (1..6).map { hand(course, it) }
            val names = suspend { look(students[0], OWN).json().points().map { it.text("name") } }
            assertEquals("false", look(students[1], "/api/v1/front-name").json().text("named"))
            assertEquals("true", name(students[1], """{"named":true}""").json().text("named"))
            val none = List(4) { "null" }
            assertEquals(listOf("null", "Ada (2)") + none, names())
            assertEquals("true", look(students[1], "/api/v1/front-name").json().text("named"))
            name(students[2], """{"named":true}""")
            assertEquals(listOf("null", "Ada (2)", "Ada (3)"), names(), "four without a name are too few")
            assertEquals(
                listOf("null", "Ada (2)", "Ada (3)"),
                look(students[0], OWN).json().points().map { it.text("name") },
            )
            name(students[1], """{"named":false}""")
            assertEquals(listOf("null", "null", "Ada (3)") + none.drop(1), names())
            name(students[1], "{}").assertProblem(400, "malformed-request")
            name(instructor, """{"named":true}""").assertProblem(403, "wrong-role")
        }

    @Test
    @DisplayName("the page does not let a student show the name, shows no name, or not how to hide it")
    fun thePageShowsAndHidesTheName() =
        Classroom(folder, bySource).open {
            val course = newCourse()
            val (ada, other) = (1..6).map { hand(course, it) }
            val show =
                suspend { who: String ->
                    cookieOf(who).let { cookie ->
                        client.get("/$FRONT?lang=en") { header(HttpHeaders.Cookie, cookie) }.bodyAsText()
                    }
                }
            assertTrue("Show my name" in show(ada))
            assertFalse("Ada" in show(other).substringAfter("<figure").substringBefore("Your name"))
            assertEquals(302, sendForm("/$FRONT", "named=yes", ada).status.value)
            assertTrue("Hide my name" in show(ada))
            assertTrue(">Ada</text>" in show(other) && "<td>Ada</td>" in show(other), show(other))
            assertEquals(302, sendForm("/$FRONT", "named=no", ada).status.value)
            assertTrue("Show my name" in show(ada))
        }

    @Test
    @DisplayName("the page of a student has a name or an id of others, or that of staff has none")
    fun pagesNameStudentsToStaffAlone() =
        Classroom(folder, bySource).open {
            val course = newCourse()
            val ada = hand(course, 6)
            (1..4).forEach { hand(course, it) }

            suspend fun page(
                who: String,
                path: String,
            ): String {
                val cookie = cookieOf(who)
                return client.get(path) { header(HttpHeaders.Cookie, cookie) }.bodyAsText()
            }
            val named = look(instructor, "/api/v1/courses/$course/$FRONT").json().points()
            val seen = page(ada, "/$FRONT")
            val main = seen.substringAfter("<main")
            for (one in named.filter { it.text("ratio") != "3.0" }) {
                for (told in listOf("name", "submission", "student")) {
                    assertFalse(one.text(told) in main, "$told ${one.text(told)} in $main")
                }
            }
            assertEquals(4, Regex("<circle").findAll(main).count(), main)
            assertTrue("""<g class="own beaten">""" in main && ">your method</text>" in main, main)
            assertTrue("ваш метод" in page(ada, "/$FRONT?lang=ru"))
            assertTrue("/$FRONT\"" in page(ada, "/exercises/draw-dot"), "no way to the page")
            val staff = page(instructor, "/instructor/courses/$course/$FRONT")
            for (one in named) assertTrue(">${one.text("name")}</a>" in staff, "no ${one.text("name")} in $staff")
        }

    private companion object {
        const val OWN = "/api/v1/exercises/draw-dot/front"
        const val FRONT = "exercises/draw-dot/front"
    }
}
