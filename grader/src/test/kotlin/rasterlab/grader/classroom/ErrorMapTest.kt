package rasterlab.grader.classroom

import io.ktor.client.request.delete
import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.put
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.engine.raster.Pixel
import rasterlab.engine.raster.PixelWindow
import rasterlab.exercises.Exercise
import rasterlab.exercises.Grading
import rasterlab.exercises.score.CasePicture
import rasterlab.exercises.score.CaseReport
import rasterlab.exercises.score.Disclosure
import rasterlab.exercises.score.GradingVerdict
import rasterlab.exercises.score.Message
import rasterlab.exercises.score.PicturePart
import rasterlab.exercises.score.Report
import rasterlab.exercises.score.ScorePoints
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.assertProblem
import rasterlab.grader.bearer
import rasterlab.grader.cookieOf
import rasterlab.grader.json
import rasterlab.grader.list
import rasterlab.grader.one
import rasterlab.grader.text
import java.nio.file.Path
import java.util.Optional

/** Staff see which cases of an exercise fail, for whom, and who gave the same wrong answers. */
@Tag("slow")
class ErrorMapTest {
    @TempDir
    lateinit var folder: Path

    /** Answers as the source says: `first` and `drawn` are rows of the differences of the two cases, or `ok`. */
    private val bySource =
        Grading { _, source, _, _ ->
            val (first, drawn) = source.substringAfter("/*").substringBefore("*/").split(' ')
            val cases = listOf(case("first", first), case("drawn", drawn), case("speed", "ok"))
            val verdict =
                if (cases.all {
                        it.verdict() == GradingVerdict.OK
                    }
                ) {
                    GradingVerdict.OK
                } else {
                    GradingVerdict.WRONG
                }
            Report(verdict, ScorePoints(0, 0, 0, 10), cases, emptyList(), "", 1.0)
        }

    private fun case(
        name: String,
        row: String,
    ): CaseReport {
        val wrong = row != "ok"
        val part =
            PicturePart(PixelWindow(5, -7, 4 + row.length, -7), PixelWindow(5, -7, 4 + row.length, -7), Pixel(5, -7))
        val pictures =
            listOf("actual", "difference").map {
                CasePicture(it, row.toByteArray(), Message.rows(row), Optional.of(part))
            }
        return CaseReport(
            name,
            if (name == "drawn") Disclosure.VERDICT_ONLY else Disclosure.OPEN,
            if (wrong) GradingVerdict.WRONG else GradingVerdict.OK,
            0,
            5,
            if (wrong) Message.of("known-mistake", "mutant.line.last-pixel") else Message.NONE,
            if (wrong) pictures else emptyList(),
            "{}",
        )
    }

    private fun classroom() = Classroom(folder, bySource, exercise = EXERCISE)

    private suspend fun Visit.hand(
        token: String,
        answers: String,
    ): String {
        val id = submit(token, "class Dot {/*$answers*/}").json().text("id")
        eventsToTheEnd(token, id)
        return id
    }

    private suspend fun Visit.map(course: String): JsonObject = look(instructor, "$API/$course/$ERRORS").json()

    private fun JsonObject.case(name: String) =
        list("cases").map { it.jsonObject }.single { it.text("name") == name }.run {
            listOf("passed", "failed", "nobodyPasses").map { text(it) }
        }

    @Test
    @DisplayName("each look reads all cases and pictures again, or misses what was graded since")
    fun whatWasReadIsKept() =
        classroom().open {
            val course = newCourse()
            hand(newStudent(course), "#+- ok")
            val last = LastResults(database)
            val id = one("SELECT id FROM courses")
            val failed = { last.of(id, "draw-dot").map { one -> one.cases.filterNot { it.passed }.map { it.name } } }
            assertEquals(listOf(listOf("first")), failed())
            database.write { handle ->
                handle.execute("DELETE FROM case_pictures")
                handle.execute("DELETE FROM case_results")
            }
            assertEquals(listOf(listOf("first")), failed())
            hand(newStudent(course), "#+- +")
            assertEquals(listOf(listOf("first"), listOf("first", "drawn")), failed())
        }

    @Test
    @DisplayName(
        "no hash is kept with a picture, it is not read, or an answer kept before there were hashes is another",
    )
    fun pictureHasItsHash() =
        classroom().open {
            hand(newStudent(newCourse()), "#+- ok")
            val id = one("SELECT id FROM courses")
            val picture = {
                LastResults(database)
                    .of(id, "draw-dot")
                    .single()
                    .cases
                    .first()
                    .picture
            }
            val kept = one("SELECT png_hash FROM case_pictures WHERE kind = 'actual'")
            assertEquals(kept, picture())
            database.write { it.execute("UPDATE case_pictures SET png_hash = NULL") }
            assertEquals(kept, picture())
            database.write { it.execute("UPDATE case_pictures SET png_hash = 'abc'") }
            assertEquals("abc", picture())
        }

    @Test
    @DisplayName("an earlier attempt is counted, a case that nobody passes is not told, or speed is taken for a case")
    fun countsTheLastResultOfEach() =
        classroom().open {
            val course = newCourse()
            val ada = newStudent(course)
            hand(ada, "#- #-")
            hand(ada, "ok #-")
            hand(newStudent(course), "#- #-")
            hand(newStudent(newCourse()), "ok ok")
            val found = map(course)
            assertEquals("2", found.text("students"))
            assertEquals(listOf("first", "drawn"), found.list("cases").map { it.jsonObject.text("name") })
            assertEquals(listOf("1", "1", "false"), found.case("first"))
            assertEquals(listOf("0", "2", "true"), found.case("drawn"))
            val failed =
                found.list("results").map { one ->
                    one.jsonObject.list("failed").map { it.jsonPrimitive.content }
                }
            assertEquals(setOf(listOf("drawn"), listOf("first", "drawn")), failed.toSet())
        }

    @Test
    @DisplayName("other answers are one group, drawn inputs part it, who passes is in one, or its mistake is not named")
    fun groupsTheSameWrongAnswers() =
        classroom().open {
            val course = newCourse()
            val same = listOf("#- #-", "#- ok", "#- +#").map { hand(newStudent(course), it) }
            val other = listOf("-# ok", "-# ok").map { hand(newStudent(course), it) }
            listOf("## #-", "ok ok", "ok ok").forEach { hand(newStudent(course), it) }
            val groups = map(course).list("groups").map { it.jsonObject }
            assertEquals(
                listOf(same.toSet(), other.toSet()),
                groups.map { group -> group.list("members").map { it.jsonObject.text("submission") }.toSet() },
            )
            assertEquals(listOf("first"), groups[0].list("cases").map { it.jsonPrimitive.content })
            assertTrue(groups[0].text("mistake").startsWith("the same comes out if"), groups[0].text("mistake"))
            assertEquals(
                groups.map { it.text("group") },
                map(course).list("groups").map { it.jsonObject.text("group") },
            )
        }

    @Test
    @DisplayName("a comment to a group misses who comes later, or reaches others, or whoever left the group")
    fun oneCommentReachesAGroup() =
        classroom().open {
            val course = newCourse()
            val ada = newStudent(course)
            val first = hand(ada, "#- ok")
            hand(newStudent(course), "#- #-")
            val other = newStudent(course)
            val apart = hand(other, "-# ok")
            val group =
                map(course)
                    .list("groups")
                    .single()
                    .jsonObject
                    .text("group")
            val path = "$API/$course/$ERRORS/groups/$group/comment"
            val said =
                client.put(path) {
                    bearer(instructor)
                    json("""{"text":"The last pixel!"}""")
                }
            assertEquals(200, said.status.value, said.bodyAsText())
            assertEquals(
                "The last pixel!",
                map(course)
                    .list("groups")
                    .single()
                    .jsonObject
                    .getValue("comment")
                    .jsonObject
                    .text("text"),
            )
            assertEquals("The last pixel!", told(ada, first))
            assertEquals(null, told(other, apart))
            val late = newStudent(course)
            assertEquals("The last pixel!", told(late, hand(late, "#- +")))
            assertEquals(null, told(ada, hand(ada, "ok ok")))
            val page = client.get("/submissions/$first") { header(HttpHeaders.Cookie, cookieOf(ada)) }.bodyAsText()
            assertTrue("The last pixel!" in page && "To all who gave these wrong answers" in page, page)
            client
                .put(path.replace(group, "0000000000000000")) {
                    bearer(instructor)
                    json("""{"text":"Nobody."}""")
                }.assertProblem(404, "unknown-group")
            look(other, path.replace("/comment", "")).let { assertEquals(404, it.status.value) }
            assertEquals(200, client.delete(path) { bearer(instructor) }.status.value)
            assertEquals(null, told(ada, first))
            client.delete(path) { bearer(instructor) }.assertProblem(404, "unknown-group")
            assertEquals(listOf("comment-group", "comment-group-drop"), notes())
        }

    private suspend fun Visit.told(
        token: String,
        submission: String,
    ): String? {
        val told = look(token, "/api/v1/submissions/$submission/group-comment").json().getValue("comment")
        return (told as? JsonObject)?.text("text")
    }

    private fun Visit.notes(): List<String> =
        database.read { handle ->
            handle
                .createQuery("SELECT action FROM audit WHERE action LIKE 'comment-group%' ORDER BY noted_at, action")
                .mapTo(String::class.java)
                .list()
        }

    @Test
    @DisplayName("the sum has no mark of a student's, sums drawn inputs, or is shown to a student")
    fun sumsTheDifferences() =
        classroom().open {
            val course = newCourse()
            val ada = newStudent(course)
            hand(ada, "#-. #-")
            hand(newStudent(course), "#-+ #-")
            val path = "$API/$course/$ERRORS/first/differences.svg"
            val svg = look(instructor, path).bodyAsText()
            assertEquals(
                listOf("24"),
                Regex("""<circle cx="(\d+)"""").findAll(svg).map { it.groupValues[1] }.toList(),
                svg,
            )
            assertEquals(1, Regex("<path").findAll(svg).count(), svg)
            assertEquals(
                setOf("#d55e00"),
                Regex("""stroke="([^"]*)"""").findAll(svg).map { it.groupValues[1] }.toSet(),
                svg,
            )
            look(instructor, "$API/$course/$ERRORS/drawn/differences.svg").assertProblem(404, "unknown-picture")
            look(ada, path).assertProblem(403, "wrong-role")
        }

    @Test
    @DisplayName("a page leaves students out, or the next one begins elsewhere; a place that is none is taken")
    fun pagesThroughTheStudents() =
        classroom().open {
            val course = newCourse()
            repeat(3) { hand(newStudent(course), "#- ok") }
            val path = "$API/$course/$ERRORS?from="
            assertEquals(1, look(instructor, "${path}2").json().list("results").size)
            assertEquals(0, look(instructor, "${path}2147483647").json().list("results").size)
            listOf("-1", "x", "2147483648").forEach {
                look(instructor, path + it).assertProblem(400, "malformed-request")
            }
        }

    @Test
    @DisplayName("the page of the errors or of a case does not tell who fails, in one of the languages")
    fun pagesTellForWhom() =
        classroom().open {
            val course = newCourse()
            val id = hand(newStudent(course), "#- #-")
            hand(newStudent(course), "#- #-")
            val cookie = cookieOf(instructor)

            suspend fun page(path: String) = client.get(path) { header(HttpHeaders.Cookie, cookie) }.bodyAsText()
            val of = page("/instructor/courses/$course/$ERRORS")
            for (words in listOf(
                "Ada",
                "/submissions/$id",
                "nobody passes",
                "Students: 2",
                """<span class="unseen">wrong""",
            )) {
                assertTrue(words in of, "no $words in $of")
            }
            assertTrue("никто не\u00a0прошёл" in page("/instructor/courses/$course/$ERRORS?lang=ru"))
            assertTrue("There are no students on this page" in page("/instructor/courses/$course/$ERRORS?from=99"))
            val case = page("/instructor/courses/$course/$ERRORS/first")
            assertTrue("pixel (6, −7): missing for 2, extra for 0" in case && "/first/differences.svg" in case, case)
            assertFalse("differences.svg" in page("/instructor/courses/$course/$ERRORS/drawn"))
            assertTrue("/$ERRORS\"" in page("/instructor/courses/$course/exercises"), "no way to the page")
        }

    private companion object {
        const val API = "/api/v1/courses"
        const val ERRORS = "exercises/draw-dot/errors"

        val EXERCISE =
            Classroom.EXERCISE.run {
                val cases =
                    listOf("first" to false, "drawn" to true).map { (name, drawn) ->
                        val shown = if (drawn) Disclosure.VERDICT_ONLY else Disclosure.OPEN
                        Exercise.Case(name, emptyMap(), Exercise.Criterion.ACCURACY, shown, 5, "{}", drawn)
                    }
                Exercise(
                    id(),
                    topic(),
                    mapOf("en" to "Draw a dot"),
                    mapOf("en" to "Draw."),
                    emptyMap(),
                    starter(),
                    revision(),
                    Exercise.ExerciseTolerance(true),
                    points(),
                    cases,
                )
            }
    }
}
