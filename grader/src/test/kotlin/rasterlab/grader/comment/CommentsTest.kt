package rasterlab.grader.comment

import io.ktor.client.request.delete
import io.ktor.client.request.header
import io.ktor.client.request.patch
import io.ktor.client.request.post
import io.ktor.client.statement.HttpResponse
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.jsonObject
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.assertProblem
import rasterlab.grader.bearer
import rasterlab.grader.course.Name
import rasterlab.grader.course.Staff
import rasterlab.grader.course.StaffRole
import rasterlab.grader.field
import rasterlab.grader.json
import rasterlab.grader.list
import rasterlab.grader.one
import rasterlab.grader.problem.Rejection
import rasterlab.grader.text
import java.nio.file.Path
import java.time.InstantSource

/** Comments, questions and answers over HTTP, of a student and of staff. */
@Tag("slow")
class CommentsTest {
    @TempDir
    lateinit var folder: Path

    @Test
    @DisplayName("a question does not wait for its answer, an answer does not close it, or more words do not open it")
    fun aQuestionWaitsForItsAnswer() =
        Classroom(folder).open(grades = false) {
            val course = newCourse()
            val student = newStudent(course)
            val id = submit(student, "a\nb\nc\n").json().text("id")
            val asked = say(id, """{"text":"Why?","line":2,"lastLine":3}""", student).json()
            val place = listOf("line", "lastLine", "open", "own", "role", "name").map(asked::text)
            assertEquals(listOf("2", "3", "true", "true", "student", "Ada"), place)
            assertEquals(listOf("Ada draw-dot 1 Why?"), questions(course))
            val thread = asked.text("id")
            val answer = say(id, """{"text":"So.","thread":"$thread"}""", newAssistant("Grace")).json()
            assertEquals(listOf(thread, "null", "Grace"), listOf("thread", "line", "name").map(answer::text))
            assertEquals(emptyList<String>(), questions(course))
            say(id, """{"text":"But why?","thread":"$thread"}""", student)
            assertEquals(1, questions(course).size)
            assertEquals(
                "false",
                client.post("${address(id)}/$thread/answered") { bearer(instructor) }.json().text("open"),
            )
            assertEquals(emptyList<String>(), questions(course))
            client.post("${address(id)}/$thread/answered") { bearer(student) }.assertProblem(422, "bad-comment")
            assertEquals(listOf("Why?", "So.", "But why?"), texts(id, student))
            val notes =
                "SELECT group_concat(action || ' ' || detail || ' ' || subject, ', ') FROM (SELECT * FROM audit " +
                    "WHERE action LIKE 'comment%' ORDER BY noted_at, rowid)"
            assertEquals("comment-answer 2–3 $id, comment-settle 2–3 $id", one(notes))
        }

    @Test
    @DisplayName("what belongs to another student is read, commented, or told to be there")
    fun anotherStudentsWorkIsUnknown() =
        Classroom(folder).open(grades = false) {
            val course = newCourse()
            val (student, other) = List(2) { newStudent(course) }
            val id = submit(student).json().text("id")
            val thread = say(id, """{"text":"Why?"}""", student).json().text("id")
            look(other, address(id)).assertProblem(404, "unknown-submission")
            say(id, """{"text":"x"}""", other).assertProblem(404, "unknown-submission")
            val own = submit(other).json().text("id")
            say(own, """{"text":"x","thread":"$thread"}""", other).assertProblem(404, "unknown-comment")
            change(own, thread, "x", other).assertProblem(404, "unknown-comment")
            client.delete("${address(own)}/$thread") { bearer(other) }.assertProblem(404, "unknown-comment")
            client.post("${address(own)}/$thread/answered") { bearer(other) }.assertProblem(404, "unknown-comment")
            look(other, "${address(own)}?after=$thread").assertProblem(400, "malformed-request")
            val course2 = newCourse()
            look(
                instructor,
                "/api/v1/courses/$course2/questions",
            ).json().also { assertEquals(0, it.list("questions").size) }
            assertEquals(listOf("Why?"), texts(id, student))
        }

    @Test
    @DisplayName("somebody changes another's words, a change is not shown, or words vanish that were answered")
    fun everybodyChangesTheirOwn() =
        Classroom(folder).open(grades = false) {
            val student = newStudent()
            val id = submit(student).json().text("id")
            val grace = newAssistant("Grace")
            val said = say(id, """{"text":"fine","line":1}""", grace).json().text("id")
            for (other in listOf(student, instructor)) {
                change(id, said, "x", other).assertProblem(403, "foreign-comment")
                client.delete("${address(id)}/$said") { bearer(other) }.assertProblem(403, "foreign-comment")
            }
            val changed = change(id, said, "better", grace).json()
            assertEquals(listOf("better", "false"), listOf("text", "open").map(changed::text))
            assertEquals(true, changed.text("editedAt") > changed.text("writtenAt").dropLast(5))
            val answer = say(id, """{"text":"thanks","thread":"$said"}""", student).json().text("id")
            client.delete("${address(id)}/$said") { bearer(grace) }.assertProblem(422, "bad-comment")
            assertEquals(200, client.delete("${address(id)}/$answer") { bearer(student) }.status.value)
            assertEquals(200, client.delete("${address(id)}/$said") { bearer(grace) }.status.value)
            assertEquals(emptyList<String>(), texts(id, student))
        }

    @Test
    @DisplayName("a comment of somebody who teaches no longer is lost, or nameless, or a student is told accounts")
    fun wordsOfFormerStaffStay() =
        Classroom(folder).open(grades = false) {
            val student = newStudent()
            val id = submit(student).json().text("id")
            val staff = Staff(database, InstantSource.system())
            val grace = staff.add(Name.of("Grace"), StaffRole.ASSISTANT, by = "test", key = null)
            say(id, """{"text":"fine"}""", grace.token)
            staff.revoke(grace.id, by = "test")
            say(id, """{"text":"again"}""", grace.token).assertProblem(401, "not-signed-in")
            val listed = look(student, address(id)).json()
            assertEquals(
                "Grace" to "assistant",
                listed.list("comments").single().let {
                    it.field("name") to
                        it.field("role")
                },
            )
            assertEquals(false, grace.id in "$listed")
        }

    @Test
    @DisplayName("a repeated request speaks twice, or another one with its key is taken")
    fun aRepeatedRequestSpeaksOnce() =
        Classroom(folder).open(grades = false) {
            val student = newStudent()
            val id = submit(student).json().text("id")
            val made = List(2) { say(id, """{"text":"Why?"}""", student, key = "once").json().text("id") }
            assertEquals(made[0], made[1])
            say(id, """{"text":"How?"}""", student, key = "once").assertProblem(422, "idempotency-key-reused")
            client.delete("${address(id)}/${made[0]}") { bearer(student) }
            say(id, """{"text":"Why?"}""", student, key = "once").assertProblem(404, "unknown-comment")
        }

    @ParameterizedTest(name = "{0} is taken")
    @CsvSource(
        quoteCharacter = '`',
        value = [
            """{"text":""}, 422""",
            """{"text":" \r\n "}, 422""",
            """{"text":"a\u0000b"}, 422""",
            """{"text":"a\ud800b"}, 422""",
            """`{"text":"x","line":4}`, 422""",
            """`{"text":"x","line":2,"lastLine":1}`, 422""",
            """`{"text":"x","lastLine":1}`, 422""",
            """`{"text":"x","line":1,"thread":"t"}`, 422""",
            """`{"text":"x","line":0}`, 400""",
            """`{"text":"x","line":null}`, 400""",
            """`{"text":"x","other":1}`, 400""",
            """{"line":1}, 400""",
        ],
    )
    fun refusesWhatIsNone(
        body: String,
        status: Int,
    ) = Classroom(folder).open(grades = false) {
        val id = submit(newStudent(), "a\r\nb\rc\n").json().text("id")
        say(id, body, instructor).assertProblem(status, if (status == 400) "malformed-request" else "bad-comment")
        say(id, """{"text":"x","line":3}""", instructor).also { assertEquals(201, it.status.value) }
    }

    @Test
    @DisplayName("a text is cut, grows without end, or has no place for all of its lines")
    fun textsHaveALimit() {
        assertEquals("a\n\tb\nc", CommentText.of(" a\r\n\tb\rc\n").text)
        assertEquals(CommentText.MOST, CommentText.of("Ж".repeat(CommentText.MOST)).text.length)
        assertThrows(Rejection.BadComment::class.java) { CommentText.of("x".repeat(CommentText.MOST + 1)) }
        assertThrows(IllegalArgumentException::class.java) { CommentedLines(0, 1) }
        assertThrows(IllegalArgumentException::class.java) { CommentedLines(2, 1) }
    }

    @Test
    @DisplayName("a page of a list leaves one out or repeats it, or one student writes without end")
    fun listsHavePages() =
        Classroom(folder).open(grades = false) {
            val course = newCourse()
            val student = newStudent(course)
            val id = submit(student).json().text("id")
            repeat(Comments.MOST_OF_STUDENT) { say(id, """{"text":"$it"}""", student) }
            say(id, """{"text":"more"}""", student).assertProblem(422, "bad-comment")
            say(id, """{"text":"${Comments.MOST_OF_STUDENT}"}""", instructor)
            val first = look(student, address(id)).json()
            val second = look(student, "${address(id)}?after=${first.text("next")}").json()
            val all = (first.list("comments") + second.list("comments")).map { it.field("text").toInt() }
            assertEquals((0..Comments.MOST_OF_STUDENT).toList(), all.sorted())
            assertEquals("50 null", "${first.list("comments").size} ${second.text("next")}")
            val other = submit(student).json().text("id")
            say(other, """{"text":"last"}""", student)
            val waiting = look(instructor, "/api/v1/courses/$course/questions").json()
            val rest = look(instructor, "/api/v1/courses/$course/questions?after=${waiting.text("next")}").json()
            assertEquals(listOf("last"), rest.list("questions").map { said(it) })
            look(instructor, "/api/v1/courses/$course/questions?after=none").assertProblem(400, "malformed-request")
        }

    @Test
    @DisplayName("a comment that is kept is another course's too, has another's name, or stays when it is dropped")
    fun keptCommentsBelongToACourse() =
        Classroom(folder).open(grades = false) {
            val (course, other) = List(2) { newCourse() }
            val grace = newAssistant("Grace")
            val body = """{"name":"names","text":"Say it in the name."}"""
            val made = List(2) { keep(course, body, grace, key = "once").json().text("id") }
            assertEquals(made[0], made[1])
            keep(course, body, grace).assertProblem(422, "bad-comment")
            keep(course, """{"name":"","text":"x"}""", grace).assertProblem(422, "bad-name")
            keep(course, """{"name":"n","text":""}""", grace).assertProblem(422, "bad-comment")
            assertEquals(201, keep(other, body, grace).status.value)
            client.delete("${kept(other)}/${made[0]}") { bearer(instructor) }.assertProblem(404, "unknown-comment")
            assertEquals(200, client.delete("${kept(course)}/${made[0]}") { bearer(instructor) }.status.value)
            assertEquals("1", one("SELECT count(*) FROM kept_comments"))
            look(newStudent(course), kept(course)).assertProblem(403, "wrong-role")
        }

    private fun Visit.newAssistant(name: String): String =
        Staff(database, InstantSource.system()).add(Name.of(name), StaffRole.ASSISTANT, by = "test", key = null).token

    private fun address(submission: String) = "/api/v1/submissions/$submission/comments"

    private fun kept(course: String) = "/api/v1/courses/$course/kept-comments"

    private suspend fun Visit.say(
        submission: String,
        body: String,
        by: String,
        key: String? = null,
    ): HttpResponse = post(address(submission), body, by, key)

    private suspend fun Visit.keep(
        course: String,
        body: String,
        by: String,
        key: String? = null,
    ): HttpResponse = post(kept(course), body, by, key)

    private suspend fun Visit.post(
        path: String,
        body: String,
        by: String,
        key: String?,
    ): HttpResponse =
        client.post(path) {
            bearer(by)
            key?.let { header("Idempotency-Key", it) }
            json(body)
        }

    private suspend fun Visit.change(
        submission: String,
        comment: String,
        text: String,
        by: String,
    ): HttpResponse =
        client.patch("${address(submission)}/$comment") {
            bearer(by)
            json("""{"text":"$text"}""")
        }

    private suspend fun Visit.texts(
        submission: String,
        by: String,
    ): List<String> = look(by, address(submission)).json().list("comments").map { it.field("text") }

    private suspend fun Visit.questions(course: String): List<String> =
        look(instructor, "/api/v1/courses/$course/questions").json().list("questions").map { one ->
            (listOf("student", "exercise", "attempt").map(one::field) + said(one)).joinToString(" ")
        }

    private fun said(question: JsonElement): String = question.jsonObject.getValue("comment").field("text")
}
