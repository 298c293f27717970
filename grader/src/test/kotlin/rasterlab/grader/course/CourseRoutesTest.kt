package rasterlab.grader.course

import io.ktor.client.request.header
import io.ktor.client.request.post
import io.ktor.client.request.setBody
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.jsonArray
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.assertProblem
import rasterlab.grader.bearer
import rasterlab.grader.field
import rasterlab.grader.json
import rasterlab.grader.list
import rasterlab.grader.one
import rasterlab.grader.text
import java.nio.file.Path
import java.time.InstantSource

/** Staff look at courses, their students and what these handed in. */
@Tag("slow")
class CourseRoutesTest {
    @TempDir
    lateinit var folder: Path

    @Test
    @DisplayName("staff of one course are told of another, staff of all miss one, or the latest is not the first")
    fun everybodySeesTheirCourses() =
        Classroom(folder).open(grades = false) {
            val (first, second) = List(2) { newCourse() }
            newStudent(first)
            val all = look(instructor, "/api/v1/courses").json().list("courses")
            assertEquals(listOf(second to "0", first to "1"), all.map { it.field("code") to it.field("students") })
            assertEquals("Graphics", all[0].field("name"))
            for (role in StaffRole.entries) {
                val own = look(staffOf(first, role), "/api/v1/courses").json()
                assertEquals(listOf(first), own.list("courses").map { it.field("code") })
                assertEquals("null", own.text("next"))
            }
            look(newStudent(first), "/api/v1/courses").assertProblem(403, "wrong-role")
        }

    @Test
    @DisplayName("a course is not found by its code, or is shown to staff of another")
    fun aCourseIsShown() =
        Classroom(folder).open(grades = false) {
            val (first, second) = List(2) { newCourse() }
            val shown = look(instructor, "/api/v1/courses/$first").json()
            assertEquals(listOf(first, "0"), listOf(shown.text("code"), shown.text("students")))
            assertEquals(shown, look(instructor, "/api/v1/courses/${shown.text("course")}").json())
            val assistant = staffOf(first, StaffRole.ASSISTANT)
            assertEquals(200, look(assistant, "/api/v1/courses/$first").status.value)
            for (below in listOf("", "/students", "/submissions")) {
                look(assistant, "/api/v1/courses/$second$below").assertProblem(404, "unknown-course")
            }
            look(instructor, "/api/v1/courses/none").assertProblem(404, "unknown-course")
        }

    @Test
    @DisplayName("an assistant reads numbers or addresses of students, or an instructor does not")
    fun whoTakesDataAwaySeesTheAddress() =
        Classroom(folder).open(grades = false) {
            val course = newCourse()
            roster(course, "Name,ID number,Email\nAda Lovelace,17,ada@example.org\nGrace Hopper,,\n")
            val assistant = staffOf(course, StaffRole.ASSISTANT)
            val students = "/api/v1/courses/$course/students"
            val told = array(instructor, students)
            assertEquals(
                listOf("Ada Lovelace 17 ada@example.org", "Grace Hopper null null"),
                told.map { one -> listOf("name", "idNumber", "email").joinToString(" ") { one.field(it) } },
            )
            val ada = told[0].field("student")
            assertEquals(told[0], look(instructor, "$students/$ada").json())
            val seen = look(assistant, "$students/$ada").json()
            assertEquals(listOf("1", "null", "null"), listOf("number", "idNumber", "email").map(seen::text))
            assertEquals(listOf("null", "null"), array(assistant, students).map { it.field("email") })
            look(instructor, "/api/v1/courses/${newCourse()}/students/$ada").assertProblem(404, "unknown-student")
            look(instructor, "$students/none").assertProblem(404, "unknown-student")
        }

    @Test
    @DisplayName("the answer to a roster leaves out numbers and addresses of those whom it adds, corrects or misses")
    fun aRosterTellsWhoIsWho() =
        Classroom(folder).open(grades = false) {
            val course = newCourse()
            val added = roster(course, "Name,ID number,Email\nAda,17,ada@example.org\nGrace,18,grace@example.org\n")
            assertEquals(listOf("17", "18"), added.list("added").map { it.field("idNumber") })
            val again = roster(course, "Name,ID number\nAda King,17\n")
            assertEquals(
                listOf("17 ada@example.org"),
                again.list("corrected").map { "${it.field("idNumber")} ${it.field("email")}" },
            )
            assertEquals(listOf("grace@example.org"), again.list("missing").map { it.field("email") })
        }

    @Test
    @DisplayName(
        "submissions of another course, exercise or student are listed, one is left out, or the order is another",
    )
    fun submissionsAreFiltered() =
        Classroom(folder, more = listOf(Classroom.another("draw-line"))).open {
            val course = newCourse()
            val (ada, eve) = List(2) { newStudent(course) }
            val first = submit(ada).json().text("id")
            eventsToTheEnd(ada, first)
            val second = submit(eve).json().text("id")
            val third = submit(ada, exercise = "draw-line").json().text("id")
            submit(newStudent())
            val all = "/api/v1/courses/$course/submissions"
            assertEquals(listOf(third, second, first), ids(all))
            assertEquals(listOf(second, first), ids("$all?exercise=draw-dot"))
            val student = one("SELECT student_id FROM submissions WHERE id = '$first'")
            assertEquals(listOf(third, first), ids("$all?student=$student"))
            assertEquals(listOf(first), ids("$all?student=$student&exercise=draw-dot"))
            val graded = look(instructor, all).json().list("submissions").last()
            assertEquals(
                listOf(student, "1", "done", "wrong", "4", "10", "false"),
                listOf("student", "attempt", "state", "verdict", "points", "of", "late").map(graded::field),
            )
            look(instructor, "$all?exercise=none").assertProblem(404, "unknown-exercise")
            look(instructor, "$all?student=none").assertProblem(404, "unknown-student")
            look(ada, all).assertProblem(403, "wrong-role")
        }

    @Test
    @DisplayName("parts of the list of submissions overlap, leave one out, or go on behind one of another course")
    fun submissionsComeInParts() =
        Classroom(folder).open(grades = false) {
            val course = newCourse()
            val ada = newStudent(course)
            val made = List(5) { submit(ada).json().text("id") }.reversed()
            val foreign = submit(newStudent()).json().text("id")
            val all = "/api/v1/courses/$course/submissions"
            val parts = mutableListOf(look(instructor, "$all?limit=2"))
            while (true) {
                val link = parts.last().headers[HttpHeaders.Link] ?: break
                parts += look(instructor, link.substringAfter('<').substringBefore('>'))
            }
            assertEquals(made.chunked(2), parts.map { part -> part.json().list("submissions").map { it.field("id") } })
            assertEquals(listOf(made[1], made[3], "null"), parts.map { it.json().text("next") })
            for (wrong in listOf("after=$foreign", "after=none", "limit=0", "limit=1001", "limit=many")) {
                look(instructor, "$all?$wrong").assertProblem(400, "malformed-request")
            }
        }

    private suspend fun Visit.ids(path: String) =
        look(instructor, path).json().list("submissions").map { it.field("id") }

    private suspend fun Visit.array(
        token: String,
        path: String,
    ): List<JsonElement> = Json.parseToJsonElement(look(token, path).bodyAsText()).jsonArray

    private fun Visit.staffOf(
        course: String,
        role: StaffRole,
    ) = Staff(database, InstantSource.system()).add(Name.of("Alan"), role, by = "test", key = null, course).token

    private suspend fun Visit.roster(
        course: String,
        text: String,
    ) = client
        .post("/api/v1/courses/$course/roster") {
            bearer(instructor)
            header(HttpHeaders.ContentType, "text/csv")
            setBody(text)
        }.json()
}
