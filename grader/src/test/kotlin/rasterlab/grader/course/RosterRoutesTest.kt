package rasterlab.grader.course

import io.ktor.client.request.header
import io.ktor.client.request.post
import io.ktor.client.request.setBody
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
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
import rasterlab.grader.commandLine
import rasterlab.grader.field
import rasterlab.grader.json
import rasterlab.grader.list
import rasterlab.grader.one
import java.io.PrintWriter
import java.io.StringWriter
import java.nio.file.Files
import java.nio.file.Path

/** A course's students come from a file, and what will change is seen before. */
@Tag("slow")
class RosterRoutesTest {
    @TempDir
    lateinit var folder: Path

    @Test
    @DisplayName("a preview changes something, or says something else than what comes")
    fun aPreviewSaysWhatComes() =
        Classroom(folder).open(grades = false) {
            val course = newCourse()
            val preview = roster(course, FIRST, dry = true)
            assertEquals(listOf("Ada Lovelace", "Grace Hopper"), preview.list("added").map { it.field("name") })
            assertEquals("0", one("SELECT count(*) FROM students"))
            val done = roster(course, FIRST)
            assertEquals(preview.list("added").map { it.field("name") }, done.list("added").map { it.field("name") })
            for (added in done.list("added")) {
                assertEquals(200, look(added.field("token"), "/api/v1/exercises").status.value)
            }
            assertEquals("1", one("SELECT count(*) FROM audit WHERE action = 'roster'"))
        }

    @Test
    @DisplayName("a student whose name changed becomes a second one, or one who is missing loses the work")
    fun knowsStudentsAgain() =
        Classroom(folder).open(grades = false) {
            val course = newCourse()
            val ada = roster(course, FIRST).list("added")[0]
            val again = roster(course, "Name,Email\nAda King,ADA@example.org\nAlan Turing,\n")
            assertEquals(
                listOf("Ada Lovelace > Ada King"),
                again.list("corrected").map {
                    "${it.field("from")} > ${it.field("to")}"
                },
            )
            assertEquals(ada.field("student"), again.list("corrected")[0].field("student"))
            assertEquals(listOf("Alan Turing"), again.list("added").map { it.field("name") })
            assertEquals(listOf("Grace Hopper"), again.list("missing").map { it.field("name") })
            assertEquals("3", one("SELECT count(*) FROM students"))
            val third = roster(course, "Name\nAda King\nAlan Turing\n")
            assertEquals("2", third.getValue("unchanged").jsonPrimitive.content)
        }

    @Test
    @DisplayName("what a field said before is not told, or a column that is not used is dropped in silence")
    fun saysWhatEachFieldWasAndBecomes() =
        Classroom(folder).open(grades = false) {
            val course = newCourse()
            val first = roster(course, "Name,Email,Group\nAda Lovelace,ada@example.org,\nGrace Hopper,,north\n")
            assertEquals(0, first.list("unused").size)
            val second = "Name,ID number,Email,Group,Mark\nAda King,s1,ada@example.org,,5\nGrace Hopper,,,south,6\n"
            for (dry in listOf(true, false)) {
                val answer = roster(course, second, dry)
                val changes =
                    answer.list("corrected").map { one ->
                        one.jsonObject.list("changes").map { it.jsonObject.values.map { v -> v.jsonPrimitive.content } }
                    }
                val ada = listOf(listOf("id-number", "null", "s1"))
                assertEquals(listOf(ada, listOf(listOf("section", "north", "south"))), changes)
                assertEquals(listOf("Mark"), answer.list("unused").map { it.jsonPrimitive.content })
            }
        }

    @Test
    @DisplayName(
        "students of one name are shown alike, or one who is renamed keeps another from the name that is free now",
    )
    fun showsNoTwoAlike() =
        Classroom(folder).open(grades = false) {
            val course = newCourse()
            newStudent(course)
            roster(course, "Name,Email\nBob,b@x\nBob,c@x\nEve,e@x\n")
            roster(course, "Name,Email\nBob King,b@x\nBob,e@x\nDan,a@x\nDan,f@x\n")
            val shown =
                one("SELECT group_concat(shown_name, ', ') FROM (SELECT shown_name FROM students ORDER BY number)")
            assertEquals("Ada, Bob King, Bob (3), Bob, Dan, Dan (6)", shown)
        }

    @Test
    @DisplayName("a roster that is refused by the database leaves a part of it behind")
    fun takesAllOrNothing() =
        Classroom(folder).open(grades = false) {
            val course = newCourse()
            roster(course, FIRST)
            database.write {
                it.execute(
                    """CREATE TRIGGER refuse BEFORE INSERT ON roster_fields WHEN NEW.value = 'last@example.org'
                       BEGIN SELECT RAISE(ABORT, 'refused'); END""",
                )
            }
            val many = (1..300).joinToString("\n") { "Student $it,s$it@example.org" }
            val taken = send(course, "Name,Email\nAda King,ada@example.org\n$many\nEve,last@example.org\n")
            assertEquals(503, taken.status.value, taken.bodyAsText())
            assertEquals("2", one("SELECT count(*) FROM students"))
            assertEquals("0", one("SELECT count(*) FROM students WHERE name = 'Ada King'"))
        }

    @Test
    @DisplayName("a roster that is in doubt is taken half, or by a student")
    fun refusesWhatIsInDoubt() =
        Classroom(folder).open(grades = false) {
            val course = newCourse()
            val student = newStudent(course)
            newStudent(course)
            send(course, "Name\nGrace\nAda\n").assertProblem(422, "bad-roster")
            assertEquals("2", one("SELECT count(*) FROM students"))
            send(course, FIRST, by = student).assertProblem(403, "wrong-role")
            send("none", FIRST).assertProblem(404, "unknown-course")
            send(course, FIRST, query = "?dry=perhaps").assertProblem(400, "malformed-request")
            send(course, FIRST, type = "application/json").assertProblem(415, "wrong-media-type")
        }

    @Test
    @DisplayName("the command takes no roster, or says nothing in Russian")
    fun theCommandTakesRostersToo() =
        Classroom(folder).open(grades = false) {
            val course = newCourse()
            val file = Files.writeString(folder.resolve("roster.csv"), FIRST)
            assertTrue("would add 2, correct 0" in command("roster", course, "$file", "--dry-run"))
            assertEquals("0", one("SELECT count(*) FROM students"))
            assertTrue("новый студент: Ada Lovelace" in command("roster", course, "$file", "--lang", "ru"))
            assertTrue("$course\t2\tGraphics" in command("list"))
            assertTrue("курса с идентификатором" in command("roster", "none", "$file", "--lang", "ru", exit = 2))
            Files.writeString(file, "Mark\n7\n")
            assertTrue("headings are Mark" in command("roster", course, "$file", exit = 2))
        }

    private fun command(
        vararg arguments: String,
        exit: Int = 0,
    ): String {
        val printed = StringWriter()
        val words = rasterlab.grader.CommandWords.asked(*arguments)
        val commands = commandLine(words).setOut(PrintWriter(printed, true)).setErr(PrintWriter(printed, true))
        val database = "sqlite:${folder.resolve("test.db")}"
        assertEquals(exit, commands.execute("course", *arguments, "--db", database), "$printed")
        return "$printed"
    }

    private suspend fun Visit.roster(
        course: String,
        text: String,
        dry: Boolean = false,
    ): JsonObject {
        val answer = send(course, text, query = if (dry) "?dry=true" else "")
        assertEquals(200, answer.status.value, answer.bodyAsText())
        return answer.json()
    }

    private suspend fun Visit.send(
        course: String,
        text: String,
        by: String = instructor,
        query: String = "",
        type: String = "text/csv",
    ) = client.post("/api/v1/courses/$course/roster$query") {
        bearer(by)
        header(HttpHeaders.ContentType, type)
        setBody(text.toByteArray())
    }

    private companion object {
        const val FIRST = "Name,Email\nAda Lovelace,ada@example.org\nGrace Hopper,grace@example.org\n"
    }
}
