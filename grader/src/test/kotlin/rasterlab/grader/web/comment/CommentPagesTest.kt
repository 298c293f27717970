package rasterlab.grader.web.comment

import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.post
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import io.ktor.http.encodeURLParameter
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.cookieOf
import rasterlab.grader.course.Name
import rasterlab.grader.course.Staff
import rasterlab.grader.course.StaffRole
import rasterlab.grader.json
import rasterlab.grader.one
import rasterlab.grader.sendForm
import rasterlab.grader.text
import java.nio.file.Path
import java.time.InstantSource

/** Comments, questions and kept comments on pages, without JavaScript. */
@Tag("slow")
class CommentPagesTest {
    @TempDir
    lateinit var folder: Path

    @Test
    @DisplayName("a question stands away from its lines, is not shown to staff as waiting, or is not answered in place")
    fun aQuestionIsAnsweredBesideItsLines() =
        Classroom(folder).open(grades = false) {
            val course = newCourse()
            val student = newStudent(course)
            val id = submit(student, "first\nsecond\nthird\n").json().text("id")
            val page = "/submissions/$id"
            assertTrue("Ask about your lines" in show(page, student))
            val asked = send("$page/comments", "form=new&line=1&last=2&text=Why%3F", student)
            val thread = one("SELECT id FROM comments")
            assertEquals("$page#comment-$thread", asked)
            val seen = show(page, student)
            val place = """<li class="noted"><code>second</code><div class="thread" id="comment-$thread""""
            assertTrue(place in seen && "lines 1 to 2" in seen && "Waits for an answer." in seen, seen)
            assertFalse("kept-comments" in seen || "/keep" in seen, "a student is shown what staff keep")
            val courseId = one("SELECT id FROM courses")
            assertTrue("Questions (1)" in show("/instructor", instructor))
            val waiting = show("/instructor/courses/$courseId/questions", instructor)
            assertTrue("""<a href="$page#comment-$thread">Ada: Draw a dot, no. 1</a>""" in waiting, waiting)
            val grace = newAssistant("Grace")
            send("$page/comments/$thread/answer", "form=answer-$thread&text=So.", grace)
            assertTrue("<strong>Grace, Assistant</strong>" in show(page, student))
            assertTrue("No question waits." in show("/instructor/courses/$courseId/questions", instructor))
            assertTrue("<strong>Grace, Ассистент</strong>" in show("$page?lang=ru", student))
            send("$page/comments/$thread/answer", "text=But+why%3F", student)
            send("$page/comments/$thread/answered", "", instructor)
            assertTrue("Questions (0)" in show("/instructor", instructor))
        }

    @Test
    @DisplayName("text is read as markup, or a comment from Windows has a line end too many")
    fun textStaysText() =
        Classroom(folder).open(grades = false) {
            val student = newStudent()
            val id = submit(student).json().text("id")
            val hostile = "<img src=x onerror=alert(1)>\r\n</textarea><script>alert(1)</script>"
            send("/submissions/$id/comments", "text=" + hostile.encodeURLParameter(spaceToPlus = true), student)
            send(
                "/instructor/courses/${one("SELECT id FROM courses")}/kept-comments",
                KEEP + hostile.encodeURLParameter(),
                instructor,
            )
            val pages =
                listOf(
                    show("/submissions/$id", student),
                    show("/submissions/$id", instructor),
                    show("/instructor/courses/${one("SELECT id FROM courses")}/questions", instructor),
                    show("/instructor/courses/${one("SELECT id FROM courses")}/kept-comments", instructor),
                )
            for (page in pages) {
                assertFalse("<img" in page || "<script>" in page, page)
                assertTrue("&lt;img src=x onerror=alert(1)&gt;\n&lt;/textarea&gt;&lt;script&gt;" in page, page)
            }
        }

    @Test
    @DisplayName("a form that is refused loses what was typed, does not say why, or says something")
    fun whatWasTypedSurvives() =
        Classroom(folder).open(grades = false) {
            val student = newStudent()
            val id = submit(student, "a\nb").json().text("id")
            val page = "/submissions/$id/comments"
            for (lines in listOf("line=3", "line=x", "line=2&last=1", "last=1")) {
                val refused = sendForm("$page?lang=en", "form=new&$lines&text=my+words", student)
                val body = refused.bodyAsText()
                assertEquals(422, refused.status.value, body)
                assertTrue(">my words</textarea>" in body && "nothing was changed" in body, body)
                assertTrue(Regex("""<details id="handed" open="[^"]*">""").containsMatchIn(body), body)
            }
            assertEquals("0", one("SELECT count(*) FROM comments"))
            val foreign = client.post(page) { header(HttpHeaders.Cookie, cookieOf(student)) }
            assertEquals(403, foreign.status.value)
            val other = newStudent()
            assertEquals(404, sendForm(page, "text=x", other).status.value)
            repeat(2) { send(page, "form=new&once=o&text=my+words", student) }
            assertEquals("1", one("SELECT count(*) FROM comments"))
        }

    @Test
    @DisplayName("one's own words cannot be changed or deleted, or another's can")
    fun ownWordsAreChanged() =
        Classroom(folder).open(grades = false) {
            val student = newStudent()
            val id = submit(student).json().text("id")
            send("/submissions/$id/comments", "text=fine", instructor)
            val comment = "/submissions/$id/comments/${one("SELECT id FROM comments")}"
            assertFalse("Change or delete" in show("/submissions/$id", student))
            assertEquals(403, sendForm("$comment/edit", "text=x", student).status.value)
            assertEquals(403, sendForm("$comment/keep", "name=x", student).status.value)
            assertTrue("Change or delete" in show("/submissions/$id", instructor))
            send("$comment/edit", "text=better", instructor)
            assertTrue("""<p class="words">better</p>""" in show("/submissions/$id", student))
            send("$comment/delete", "", instructor)
            assertEquals("0", one("SELECT count(*) FROM comments"))
        }

    @Test
    @DisplayName("a kept comment cannot be chosen, is chosen in another course, or by a student")
    fun keptCommentsAreChosenAgain() =
        Classroom(folder).open(grades = false) {
            val course = newCourse()
            val students = listOf(newStudent(course), newStudent(course), newStudent())
            val ids = students.map { submit(it).json().text("id") }
            send("/submissions/${ids[0]}/comments", "text=Say+it+in+the+name.", instructor)
            send("/submissions/${ids[0]}/comments/${one("SELECT id FROM comments")}/keep", "name=names", instructor)
            val kept = one("SELECT id FROM kept_comments")
            assertTrue("names: Say it in the name." in show("/submissions/${ids[1]}", instructor))
            assertFalse("names: Say it" in show("/submissions/${ids[2]}", instructor))
            send("/submissions/${ids[1]}/comments", "kept=$kept&text=Here+too.", instructor)
            assertTrue("Say it in the name.\n\nHere too.</p>" in show("/submissions/${ids[1]}", students[1]))
            assertEquals(404, sendForm("/submissions/${ids[2]}/comments", "kept=$kept&text=x", instructor).status.value)
            send("/submissions/${ids[1]}/comments", "kept=$kept&text=mine", students[1])
            assertEquals("1", one("SELECT count(*) FROM comments WHERE text = 'mine'"))
            val page = "/instructor/courses/${one("SELECT course_id FROM kept_comments")}/kept-comments"
            val refused = sendForm("$page?lang=en", "name=names&text=other+words", instructor)
            assertEquals(422, refused.status.value)
            assertTrue(">other words</textarea>" in refused.bodyAsText())
            send("$page/$kept/drop", "", instructor)
            assertTrue("keeps no comment yet" in show(page, instructor))
        }

    private fun Visit.newAssistant(name: String): String =
        Staff(database, InstantSource.system()).add(Name.of(name), StaffRole.ASSISTANT, by = "test", key = null).token

    /** Sends a form that is taken, and returns where it leads. */
    private suspend fun Visit.send(
        path: String,
        body: String,
        by: String,
    ): String {
        val answer = sendForm("$path?lang=en", body, by)
        assertEquals(302, answer.status.value, answer.bodyAsText())
        return answer.headers[HttpHeaders.Location].orEmpty()
    }

    private suspend fun Visit.show(
        path: String,
        by: String,
    ): String {
        val cookie = cookieOf(by)
        val asked = if ("lang=" in path) path else "$path?lang=en"
        // Pages are laid out for people who read them, with spaces between elements.
        return client.get(asked) { header(HttpHeaders.Cookie, cookie) }.bodyAsText().replace(BETWEEN, "><")
    }

    private companion object {
        const val KEEP = "name=names&text="
        val BETWEEN = Regex(">\\s+<")
    }
}
