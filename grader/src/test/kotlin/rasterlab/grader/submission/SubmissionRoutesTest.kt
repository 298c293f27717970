package rasterlab.grader.submission

import io.ktor.client.request.forms.FormPart
import io.ktor.client.request.forms.MultiPartFormDataContent
import io.ktor.client.request.forms.formData
import io.ktor.client.request.header
import io.ktor.client.request.post
import io.ktor.client.request.setBody
import io.ktor.client.statement.bodyAsBytes
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import kotlinx.serialization.json.jsonObject
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.Classroom
import rasterlab.grader.assertProblem
import rasterlab.grader.bearer
import rasterlab.grader.field
import rasterlab.grader.json
import rasterlab.grader.list
import rasterlab.grader.query
import rasterlab.grader.text
import java.nio.file.Path

class SubmissionRoutesTest {
    @TempDir
    lateinit var folder: Path

    @Test
    fun isOnTheDiskWhenItIsAccepted() =
        Classroom(folder).run {
            open(grades = false) {
                val answer = submit(newStudent(), "class Dot { /* ё */ }")
                assertEquals(202, answer.status.value)
                val id = answer.json().text("id")
                assertEquals("/api/v1/submissions/$id", answer.headers[HttpHeaders.Location])
                assertEquals("queued" to "1", answer.json().run { text("state") to text("position") })
                assertEquals("class Dot { /* ё */ }", query(file, "SELECT source FROM submissions WHERE id = '$id'"))
            }
        }

    @Test
    fun storesNothingWhenStoringFails() =
        Classroom(folder).run {
            open(grades = false) {
                val student = newStudent()
                database.write {
                    it.execute(
                        "CREATE TRIGGER full BEFORE INSERT ON idempotency_keys BEGIN SELECT raise(ABORT, 'full'); END",
                    )
                }
                val refused = submit(student, key = "k")
                refused.assertProblem(503, "storage")
                assertEquals("5", refused.headers[HttpHeaders.RetryAfter], "when to come again")
                assertEquals("0", query(file, "SELECT count(*) FROM submissions"))
            }
        }

    @Test
    fun showsTheStudentOnlyWhatIsOpen() =
        Classroom(folder).open {
            val student = newStudent()
            val id = submit(student).json().text("id")
            val events = eventsToTheEnd(student, id)
            val seen = look(student, "/api/v1/submissions/$id").json()
            assertEquals(SUBMISSION_FIELDS, seen.keys)
            assertEquals("done" to "wrong", seen.text("state") to seen.text("verdict"))
            assertEquals(
                mapOf("accuracy" to "4", "stability" to "0", "speed" to "0", "total" to "4", "of" to "10"),
                numbers(seen.getValue("points").jsonObject),
            )
            assertEquals(
                CASE_FIELDS,
                seen
                    .list("cases")
                    .first()
                    .jsonObject.keys,
            )
            assertEquals(listOf("open-case", "hidden-case"), seen.list("cases").map { it.field("name") })
            assertFalse("secret of hidden-case" in (seen.toString() + events), "a hidden case is told")
        }

    @Test
    fun showsTheInstructorEverything() =
        Classroom(folder).open {
            val student = newStudent()
            val id = submit(student).json().text("id")
            eventsToTheEnd(student, id)
            val seen = look(instructor, "/api/v1/submissions/$id").bodyAsText()
            check("secret of hidden-case" in seen) { "the instructor does not see the hidden case in $seen" }
            val picture = "/api/v1/submissions/$id/cases/hidden-case/difference.png"
            assertArrayEquals(byteArrayOf(3), look(instructor, picture).bodyAsBytes())
            look(student, picture).assertProblem(404, "unknown-picture")
            assertEquals("image/png", look(student, picture.replace("hidden", "open")).headers[HttpHeaders.ContentType])
        }

    @Test
    fun keepsOthersOut() =
        Classroom(folder).open {
            val course = newCourse()
            val owner = newStudent(course)
            val other = newStudent(course)
            val id = submit(owner).json().text("id")
            eventsToTheEnd(owner, id)
            for (path in listOf("", "/events", "/cases/open-case/expected.png")) {
                look(other, "/api/v1/submissions/$id$path").assertProblem(404, "unknown-submission")
            }
        }

    @Test
    fun tellsTheWholeWayAsEvents() =
        Classroom(folder).open {
            val student = newStudent()
            val id = submit(student).json().text("id")
            val first = eventsToTheEnd(student, id)
            assertEquals(
                listOf("open-case", "hidden-case"),
                first.filter { it.first == "case" }.map { it.second.text("name") },
            )
            assertEquals("done", first.last().first)
            assertEquals("wrong", first.last().second.text("verdict"))
            val again = eventsToTheEnd(student, id)
            assertEquals(listOf("case", "case", "done"), again.map { it.first })
        }

    @Test
    fun takesAForm() =
        Classroom(folder).run {
            open(grades = false) {
                val student = newStudent()
                val answer =
                    client.post("/api/v1/exercises/draw-dot/submissions") {
                        bearer(student)
                        setBody(MultiPartFormDataContent(formData(FormPart("source", "class Form {}"))))
                    }
                assertEquals(202, answer.status.value, answer.bodyAsText())
                assertEquals("class Form {}", query(file, "SELECT source FROM submissions"))
            }
        }

    @Test
    fun repeatsNothingThatHasTheSameKey() =
        Classroom(folder).run {
            open(grades = false) {
                val course = newCourse()
                val student = newStudent(course)
                val id = submit(student, key = "upload-1").json().text("id")
                assertEquals(id, submit(student, key = "upload-1").json().text("id"))
                submit(student, "class Other {}", key = "upload-1").assertProblem(422, "idempotency-key-reused")
                check(submit(newStudent(course), key = "upload-1").json().text("id") != id) {
                    "another student's key was taken for mine"
                }
                assertEquals("2", query(file, "SELECT count(*) FROM submissions"))
            }
        }

    @Test
    fun givesTheSameTokenForTheSameKey() =
        Classroom(folder).run {
            open(grades = false) {
                val code = newCourse()

                suspend fun join(name: String) =
                    client.post("/api/v1/join") {
                        json("""{"course":"$code","name":"$name"}""")
                        header("Idempotency-Key", "a-key-that-nobody-guesses")
                    }
                val first = join("Ada").json()
                assertEquals(first, join("Ada").json())
                assertEquals(200, look(first.text("token"), "/api/v1/exercises").status.value)
                join("Bob").assertProblem(422, "idempotency-key-reused")
                assertEquals("1", query(file, "SELECT count(*) FROM students"))
                assertEquals(
                    "0",
                    query(file, "SELECT count(*) FROM students WHERE token_hash = '${first.text("token")}'"),
                )
            }
        }

    private fun numbers(points: kotlinx.serialization.json.JsonObject) = points.keys.associateWith { points.text(it) }

    private companion object {
        val SUBMISSION_FIELDS =
            setOf(
                "id",
                "exercise",
                "revision",
                "current",
                "attempt",
                "state",
                "position",
                "waitSeconds",
                "verdict",
                "points",
                "cases",
                "diagnostics",
                "isolation",
                "speed",
                "receivedAt",
                "gradedAt",
                "deadline",
                "late",
                "penalty",
                "opened",
            )
        val CASE_FIELDS =
            setOf(
                "name",
                "title",
                "visibility",
                "run",
                "verdict",
                "points",
                "of",
                "message",
                "place",
                "tolerance",
                "rule",
                "pictures",
                "scene",
            )
    }
}
