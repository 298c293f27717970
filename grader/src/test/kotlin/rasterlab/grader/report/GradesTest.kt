package rasterlab.grader.report

import io.ktor.client.request.header
import io.ktor.client.request.post
import io.ktor.client.request.setBody
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
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
import rasterlab.grader.text
import java.nio.file.Path

/** Marks leave the server in the columns of whoever takes them. */
@Tag("slow")
class GradesTest {
    @TempDir
    lateinit var folder: Path

    @Test
    @DisplayName("Canvas cannot take the marks back: its columns are not as they came, or a name is a formula")
    fun givesCanvasItsColumnsBack() =
        Classroom(folder).open {
            val course = newCourse()
            val tokens =
                roster(
                    course,
                    """Student,ID,SIS User ID,SIS Login ID,Section,Other (5)
                      |    Points Possible,,,,,10
                      |"Lovelace, Ada",123,S1,ada,"Graphics, autumn",7
                      |"=1+1, Eve",124,S2,eve,Graphics,
                      |+1,125,S3,bob,Graphics,
                      |-1,126,S4,kay,Graphics,
                      |@SUM,127,S5,dan,Graphics,""",
                )
            hand(tokens[0])
            assertEquals(
                """Student,ID,SIS User ID,SIS Login ID,Section,Draw a dot
                  |    Points Possible,,,,,10
                  |"Lovelace, Ada",123,S1,ada,"Graphics, autumn",4
                  |"'=1+1, Eve",124,S2,eve,Graphics,
                  |'+1,125,S3,bob,Graphics,
                  |'-1,126,S4,kay,Graphics,
                  |'@SUM,127,S5,dan,Graphics,
                  |
                """.trimMargin(),
                grades(course, "?for=canvas&lang=en"),
            )
        }

    @Test
    @DisplayName("Moodle cannot take the marks back: what names a student is missing, or a number is changed")
    fun givesMoodleItsColumnsBack() =
        Classroom(folder).open {
            val course = newCourse()
            val tokens =
                roster(
                    course,
                    "First name,Surname,ID number,Email address\nAda,Lovelace,0042,ada@example.org\nEve,Who,,eve@example.org",
                )
            hand(tokens[0])
            assertEquals(
                "ID number,Email address,Full name,Draw a dot\n0042,ada@example.org,Ada Lovelace,4\n,eve@example.org,Eve Who,\n",
                grades(course, "?for=moodle&lang=en"),
            )
            assertEquals("number,name,draw-dot,total\n1,Ada Lovelace,4,4\n2,Eve Who,,0\n", grades(course))
            look(tokens[0], "/api/v1/courses/$course/grades.csv").assertProblem(403, "wrong-role")
            look(instructor, "/api/v1/courses/$course/grades.csv?for=excel").assertProblem(400, "malformed-request")
        }

    @Test
    @DisplayName("what counts is not what the rule of the course says, or practice after the last late day counts")
    fun countsByTheRuleOfTheCourse() =
        Classroom(folder).open {
            val course = newCourse()
            val token = roster(course, "Name\nAda").single()
            repeat(3) { hand(token, "class Dot { int n = $it; }") }

            fun number(points: Int) = "number,name,draw-dot,total\n1,Ada,$points,$points\n"
            for ((attempt, points) in listOf(1 to 2, 2 to 6, 3 to 4)) {
                execute(
                    """UPDATE results SET accuracy = $points
                       WHERE submission_id = (SELECT id FROM submissions WHERE attempt = $attempt)""",
                )
                execute(
                    """UPDATE submissions SET received_at = '2026-03-0${attempt}T12:00:00.000Z',
                           due_at = '2026-03-01T13:00:00.000Z' WHERE attempt = $attempt""",
                )
            }
            assertEquals(number(6), grades(course))
            execute(
                """INSERT INTO course_exercises (course_id, exercise, due_at, policy)
                   SELECT id, 'draw-dot', '2026-03-01T13:00:00.000Z', 'last' FROM courses""",
            )
            assertEquals(number(4), grades(course))
            execute("UPDATE course_exercises SET late_days = 1, policy = 'best'")
            assertEquals(number(6), grades(course))
            execute("UPDATE course_exercises SET late_days = 0")
            assertEquals(number(2), grades(course))
            execute("INSERT INTO extensions SELECT id, 'draw-dot', '2026-03-04T00:00:00.000Z', 'ill' FROM students")
            execute("UPDATE course_exercises SET policy = 'chosen'")
            execute("UPDATE submissions SET is_chosen = 1 WHERE attempt = 3")
            assertEquals(number(4), grades(course))
        }

    private fun Visit.execute(sql: String) = database.write { it.execute(sql) }

    private suspend fun Visit.hand(
        token: String,
        source: String = "class Dot {}",
    ) {
        val id = submit(token, source).json().text("id")
        eventsToTheEnd(token, id)
    }

    private suspend fun Visit.grades(
        course: String,
        query: String = "",
    ): String {
        val answer = look(instructor, "/api/v1/courses/$course/grades.csv$query")
        assertEquals(200, answer.status.value, answer.bodyAsText())
        return answer.bodyAsText().replace("\r\n", "\n")
    }

    /** The students' tokens. */
    private suspend fun Visit.roster(
        course: String,
        text: String,
    ): List<String> {
        val answer =
            client.post("/api/v1/courses/$course/roster") {
                bearer(instructor)
                header(HttpHeaders.ContentType, "text/csv")
                setBody(text.trimMargin())
            }
        assertEquals(200, answer.status.value, answer.bodyAsText())
        return answer.json().list("added").map { it.field("token") }
    }
}
