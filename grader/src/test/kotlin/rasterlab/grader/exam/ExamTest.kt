package rasterlab.grader.exam

import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.Classroom
import rasterlab.grader.assertProblem
import rasterlab.grader.cookieOf
import rasterlab.grader.json
import rasterlab.grader.one
import rasterlab.grader.text
import java.nio.file.Path
import java.time.Duration
import java.time.Instant

/** A student at an exam has its time, one browser and nothing else; what is written is never lost. */
@Tag("slow")
open class ExamTest {
    @TempDir
    lateinit var folder: Path
    private var nanos = 0L
    private var wall = Instant.parse("2027-03-01T09:00:00Z")

    private fun classroom() = Classroom(folder, clock = { wall }, nanos = { nanos })

    private fun pass(time: Duration) {
        nanos += time.toNanos()
    }

    @Test
    @DisplayName("time begins before the student, does not end, follows a clock that is set, or the last draft is lost")
    fun handsTheLastDraftInWhenTimeIsOver() =
        classroom().open(grades = false) {
            val course = newCourse()
            val ada = newStudent(course)
            val exam = exam(course)
            val cookie = cookieOf(ada)
            pass(Duration.ofMinutes(59))
            assertEquals(409, open(exam, cookie).status.value)
            pass(Duration.ofMinutes(2))
            wall += Duration.ofHours(9)
            assertEquals(302, open(exam, cookie).status.value)
            assertTrue("30 minutes" in seen(exam, cookie), seen(exam, cookie))
            assertTrue("<span class=\"unbroken\">2027-03-01</span>" in seen(exam, cookie), "a line may end in a date")
            assertEquals(302, draft(exam, cookie, "class Dot { int first; }").status.value)
            pass(Duration.ofMinutes(29))
            assertEquals("60", draft(exam, cookie, "class Dot { int <last>; }", "quiet" to "yes").bodyAsText())
            assertTrue("class Dot { int &lt;last&gt;; }" in seen(exam, cookie), "the draft is not there after a reload")
            pass(Duration.ofSeconds(90))
            assertEquals(302, draft(exam, cookie, "class Dot { int late; }").status.value, "there is no grace")
            assertEquals("0", one("SELECT count(*) FROM submissions"))
            pass(Duration.ofSeconds(1))
            assertEquals(409, draft(exam, cookie, "class Dot { int more; }").status.value)
            repeat(2) { list(cookie) }
            assertEquals("class Dot { int late; } 0", one("SELECT source || ' ' || penalty FROM submissions"))
            assertEquals("opened draft draft draft hand-in end", kinds())
        }

    @Test
    @DisplayName("own work on an exercise that an exam has is said not to exist, or work of others is said to exist")
    fun ownWorkIsHiddenByAnExam() =
        classroom().open(grades = false) {
            val course = newCourse()
            val ada = newStudent(course)
            val eve = newStudent(course)
            val id = submit(ada).json().text("id")
            exam(course)
            look(ada, "/api/v1/submissions/$id").assertProblem(404, "hidden-by-exam")
            look(eve, "/api/v1/submissions/$id").assertProblem(404, "unknown-submission")
            val cookie = cookieOf(ada)
            val told = mapOf("en" to "an exam now has its exercise", "ru" to "его задание сейчас на экзамене")
            for ((language, said) in told) {
                val page = page("/submissions/$id?lang=$language", cookie)
                assertEquals(404, page.status.value)
                assertTrue(said in page.bodyAsText(), page.bodyAsText())
            }
            assertFalse("an exam now has" in page("/submissions/$id", cookieOf(eve)).bodyAsText())
        }

    @Test
    @DisplayName("a student at an exam reaches another exercise, or one who is not reaches the exam's")
    fun nothingElseCanBeReached() =
        classroom().open(grades = false) {
            val course = newCourse()
            val ada = newStudent(course)
            val eve = newStudent(course)
            val before = submit(ada)
            assertEquals(202, before.status.value)
            val exam = exam(course, "starts" to "first")
            val (cookie, other) = listOf(ada, eve).map { cookieOf(it) }
            for (token in listOf(ada, eve)) {
                look(token, "/api/v1/exercises/draw-dot/statement").assertProblem(404, "unknown-exercise")
                look(token, "/api/v1/exercises/draw%2Ddot").assertProblem(404, "unknown-exercise")
                submit(token).assertProblem(404, "unknown-exercise")
                assertEquals("[]", look(token, "/api/v1/exercises").bodyAsText())
            }
            pass(Duration.ofMinutes(61))
            open(exam, cookie)
            for (path in listOf("/api/v1/exercises", "/api/v1/exercises/other", "/api/v1/exercises/draw-dot/hints")) {
                look(ada, path).assertProblem(403, "in-exam")
            }
            assertEquals("/exams", page("/exercises", cookie).headers[HttpHeaders.Location])
            assertEquals(403, page("/exercises/draw-dot", cookie).status.value)
            assertEquals(200, page("/exercises/draw-dot/pictures/dot.svg", cookie).status.value)
            assertEquals(404, page("/exercises/draw-dot/pictures/dot.svg", other).status.value)
            assertEquals(200, page("/exercises", other).status.value)
            assertEquals(404, page("/exams/none", cookie).status.value)
            val stranger = cookieOf(newStudent())
            assertEquals(404, open(exam, stranger).status.value, "a student of another course opens it")
            assertEquals(403, page("/instructor/exams/$exam", cookie).status.value)
            send("/exams/$exam/end", cookie)
            pass(Duration.ofHours(3))
            assertEquals(200, page("/exercises/draw-dot", cookie).status.value)
        }

    @Test
    @DisplayName("two browsers work on an exam, staff cannot let another one in, or that is not noted")
    fun oneBrowserAtATime() =
        classroom().open(grades = false) {
            val course = newCourse()
            val ada = newStudent(course)
            val exam = exam(course)
            val (first, second) = List(2) { cookieOf(ada) }
            pass(Duration.ofMinutes(61))
            open(exam, first)
            draft(exam, first, "class Dot { int kept; }")
            assertEquals(409, open(exam, second).status.value)
            assertEquals(409, draft(exam, second, "class Dot {}").status.value)
            assertEquals(409, page("/exams/$exam", second).status.value)
            val student = one("SELECT id FROM students")
            val staff = cookieOf(instructor)
            assertEquals(403, send("/instructor/exams/$exam/students/$student/release", first).status.value)
            assertEquals(302, send("/instructor/exams/$exam/students/$student/release", staff).status.value)
            assertEquals(302, open(exam, second).status.value)
            assertTrue("int kept;" in seen(exam, second), "the draft is not there in the other browser")
            assertEquals(409, draft(exam, first, "class Dot {}").status.value)
            assertEquals(
                "opened draft second-session second-session second-session released second-session",
                kinds(),
            )
            val desk = page("/instructor/exams/$exam", staff).bodyAsText()
            assertTrue("second session refused" in desk && "at work" in desk, desk)
            val csv = page("/instructor/exams/$exam/protocol.csv", staff).bodyAsText()
            val begin = "time,student,name,event,address,detail\r\n2027-03-01T10:01:00.000Z,$student,Ada,opened,"
            assertTrue(csv.startsWith(begin), csv)
        }

    @Test
    @DisplayName("the second browser does not end the first where the exam says so")
    fun theSecondBrowserTakesOver() =
        classroom().open(grades = false) {
            val course = newCourse()
            val ada = newStudent(course)
            val exam = exam(course, "second" to "end")
            val (first, second) = List(2) { cookieOf(ada) }
            pass(Duration.ofMinutes(61))
            open(exam, first)
            assertEquals(302, open(exam, second).status.value)
            assertEquals(409, draft(exam, first, "class Dot {}").status.value)
            assertEquals(302, draft(exam, second, "class Dot {}").status.value)
            assertEquals("opened session-taken-over second-session draft", kinds())
        }

    @Test
    @DisplayName("more minutes are another's, or cannot be given; all begin at once, or one begins later")
    fun givesMoreMinutes() =
        classroom().open(grades = false) {
            val course = newCourse()
            val (ada, eve) = List(2) { cookieOf(newStudent(course)) }
            val exam = exam(course, "starts" to "fixed")
            val student = one("SELECT id FROM students WHERE number = 1")
            val extra = "/instructor/exams/$exam/students/$student/extra"
            assertEquals(302, send(extra, cookieOf(instructor), "extra" to "10").status.value)
            assertEquals(422, send(extra, cookieOf(instructor), "extra" to "-1").status.value)
            assertEquals(403, send(extra, ada, "extra" to "99").status.value)
            pass(Duration.ofMinutes(65))
            assertEquals("/exams", page("/exercises", eve).headers[HttpHeaders.Location], "it has begun for all")
            listOf(ada, eve).forEach { open(exam, it) }
            pass(Duration.ofMinutes(24))
            assertEquals("660", draft(exam, ada, "class Dot {}", "quiet" to "yes").bodyAsText())
            assertEquals("60", draft(exam, eve, "class Dot {}", "quiet" to "yes").bodyAsText())
        }

    @Test
    @DisplayName("minutes given after the end are of no use, or open an exam whose new end has passed")
    fun goesOnWithMoreMinutes() =
        classroom().open(grades = false) {
            val course = newCourse()
            val ada = cookieOf(newStudent(course))
            val exam = exam(course)
            val extra = "/instructor/exams/$exam/students/${one("SELECT id FROM students")}/extra"
            pass(Duration.ofMinutes(61))
            open(exam, ada)
            pass(Duration.ofMinutes(35))
            list(ada)
            send(extra, cookieOf(instructor), "extra" to "4")
            assertEquals("1", one("SELECT count(*) FROM exam_sittings WHERE ended_at IS NOT NULL"))
            assertNotEquals(302, draft(exam, ada, "class Dot {}").status.value)
            send(extra, cookieOf(instructor), "extra" to "10")
            assertEquals(302, draft(exam, ada, "class Dot {}").status.value)
        }

    @Test
    @DisplayName("an exam is opened from an address that it does not allow, or an exam that cannot be is stored")
    fun holdsItsAddresses() =
        classroom().open(grades = false) {
            val course = newCourse()
            val ada = cookieOf(newStudent(course))
            val exam = exam(course, "addresses" to "192.0.2.0/24")
            pass(Duration.ofMinutes(61))
            assertEquals(403, open(exam, ada).status.value)
            assertEquals("address-refused", kinds())
            val desk = "/instructor/courses/${one("SELECT id FROM courses")}/exams"
            for (wrong in listOf("addresses" to "lab.example.org", "minutes" to "0", "closes" to "2027-03-01T01:00")) {
                val refused = send(desk, cookieOf(instructor), *(FIELDS + wrong).toList().toTypedArray())
                assertEquals(422, refused.status.value, wrong.second)
                assertTrue("value=\"${wrong.second}\"" in refused.bodyAsText(), "what was typed is lost")
            }
            assertEquals("1", one("SELECT count(*) FROM exams"))
            assertFalse(AddressList.of("192.0.2.128/25 2001:db8::/33").allows("192.0.2.127"))
            for (inside in listOf("192.0.2.128", "2001:db8:7fff::1", "::ffff:192.0.2.200")) {
                assertTrue(AddressList.of("192.0.2.128/25 2001:db8::/33").allows(inside), inside)
            }
        }
}
