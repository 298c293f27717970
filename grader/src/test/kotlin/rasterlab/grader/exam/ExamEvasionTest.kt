package rasterlab.grader.exam

import io.ktor.client.request.delete
import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.patch
import io.ktor.client.request.post
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.Classroom
import rasterlab.grader.ServerSettings
import rasterlab.grader.Visit
import rasterlab.grader.Wire
import rasterlab.grader.assertProblem
import rasterlab.grader.bearer
import rasterlab.grader.cookieOf
import rasterlab.grader.header
import rasterlab.grader.json
import rasterlab.grader.one
import rasterlab.grader.text
import java.net.InetAddress
import java.nio.file.Path
import java.time.Duration
import java.time.Instant

/** Students who want more of an exam than it gives try what a browser and a program can. */
@Tag("slow")
class ExamEvasionTest {
    @TempDir
    lateinit var folder: Path
    private var nanos = 0L
    private val wall = Instant.parse("2027-03-01T09:00:00Z")

    private fun classroom(settings: ServerSettings = ServerSettings(entriesPerMinute = 100)) =
        Classroom(folder, settings = settings, clock = { wall }, nanos = { nanos })

    private fun pass(time: Duration) {
        nanos += time.toNanos()
    }

    @Test
    @DisplayName("a path that is written in another way leads out of an exam, or is answered by a fault")
    fun noSpellingOfAPathLeadsOut() =
        classroom().open(grades = false) {
            val course = newCourse()
            val ada = newStudent(course)
            val exam = exam(course)
            pass(Duration.ofMinutes(61))
            val cookie = cookieOf(ada)
            open(exam, cookie)
            val pages =
                listOf(
                    "/exercises/draw-dot",
                    "/exercises/%64raw-dot",
                    "/exercises//draw-dot",
                    "/exercises/draw-dot/",
                    "/exercises/draw-dot/front",
                    "/exercises/draw-dot/starter/../front",
                    "/api/v1/exercises/draw-dot/statement",
                    "/api/v1/exercises?of=/exams/$exam",
                    "/assets/../exercises/draw-dot",
                    "/instructor",
                )
            for (path in pages) {
                val status = page(path, cookie).status.value
                assertTrue(status in setOf(400, 403, 404), "$path: $status")
            }
            assertEquals(200, page("/exercises/draw-dot/starter", cookie).status.value)
            for (path in listOf("/exercises/draw-dot", "/exercises/draw-dot/hints", "/chosen", "/join", "/sign-in")) {
                assertEquals(403, send(path, cookie).status.value, path)
            }
            assertEquals(403, client.post("/api/v1/join") { header(HttpHeaders.Cookie, cookie) }.status.value)
            assertEquals("0", one("SELECT count(*) FROM submissions"))
        }

    @Test
    @DisplayName("a path that is none is answered by a fault")
    fun aPathThatIsNoneIsRefused() =
        classroom().listen {
            assertEquals("HTTP/1.1 400 Bad Request", status("GET", "/exercises/%zz"))
        }

    @Test
    @DisplayName("what was handed in before an exam is seen at it, or what is handed in at it is not")
    fun pastResultsStayAway() =
        classroom().open {
            val course = newCourse()
            val ada = newStudent(course)
            val before = submit(ada).json().text("id")
            eventsToTheEnd(ada, before)
            val exam = exam(course)
            pass(Duration.ofMinutes(61))
            val cookie = cookieOf(ada)
            open(exam, cookie)
            draft(exam, cookie, "class Dot { int now; }", to = "")
            val now = one("SELECT id FROM submissions WHERE id <> '$before'")
            val api = listOf("", "/source", "/events", "/comments", "/cases/open-case/scene.json")
            val paths = api.map { "/api/v1/submissions/%s$it" } + listOf("/submissions/%s", "/submissions/%s/fragment")
            val statuses = { id: String -> paths.map { it.replace("%s", id) } }
            assertEquals(paths.map { 403 }, statuses(before).map { page(it, cookie).status.value })
            assertEquals(200, page("/submissions/$now", cookie).status.value)
            client
                .get("/api/v1/submissions/$now/source") {
                    bearer(ada)
                    header(HttpHeaders.Cookie, cookie)
                }.let { assertEquals("class Dot { int now; }", it.bodyAsText()) }
            // The token alone is another session than the browser's.
            look(ada, "/api/v1/submissions/$now").assertProblem(409, "other-session")
            look(ada, "/api/v1/submissions/$before/events").assertProblem(403, "in-exam")
            submit(ada).assertProblem(403, "in-exam")
            assertEquals("opened draft hand-in second-session", kinds())
        }

    @Test
    @DisplayName("somebody complains about a result while the exam runs, or cannot when it is over")
    fun nobodyComplainsDuringAnExam() =
        classroom().open {
            val course = newCourse()
            val ada = newStudent(course)
            val exam = exam(course)
            pass(Duration.ofMinutes(61))
            val cookie = cookieOf(ada)
            open(exam, cookie)
            draft(exam, cookie, "class Dot { int now; }", to = "")
            val id = one("SELECT id FROM submissions")
            page("/api/v1/submissions/$id/events", cookie).bodyAsText()
            val complain =
                suspend { send("/submissions/$id/complaints", cookie, "case" to "open-case", "text" to "no") }
            val form = "/submissions/$id/complaints\""
            assertFalse(form in page("/submissions/$id", cookie).bodyAsText())
            assertEquals(403, complain().status.value)
            assertEquals(403, page("/api/v1/submissions/$id/complaints", cookie).status.value)
            pass(Duration.ofHours(3))
            assertTrue(form in page("/submissions/$id", cookie).bodyAsText())
            assertEquals(302, complain().status.value)
        }

    @Test
    @DisplayName("an exam is worked on before it opens or after it is over, or work of the lost network's time is")
    fun workOutsideTheWindowIsRefused() =
        classroom().open(grades = false) {
            val course = newCourse()
            val ada = cookieOf(newStudent(course))
            val exam = exam(course, "starts" to "fixed")
            val tries: suspend Visit.(String) -> List<Int> = { source ->
                listOf("/draft", "").map { draft(exam, ada, source, to = it).status.value }
            }
            pass(Duration.ofSeconds(3_599))
            assertEquals(listOf(409, 409, 409), tries("class Dot {}") + open(exam, ada).status.value)
            pass(Duration.ofSeconds(1))
            assertEquals(listOf(409, 409), tries("class Dot {}"), "it was not opened")
            open(exam, ada)
            assertEquals(listOf(302, 302), tries("class Dot { int in; }"))
            pass(Duration.ofSeconds(1_830))
            assertEquals(listOf(302, 302), tries("class Dot { int grace; }"), "the network came back in time")
            pass(Duration.ofSeconds(1))
            assertEquals(listOf(409, 409), tries("class Dot { int late; }"), "the network came back too late")
            assertEquals("/exams", page("/exams/$exam", ada).headers[HttpHeaders.Location])
            assertEquals(409, send("/exams/$exam/end", ada).status.value)
            assertEquals(404, page("/exercises/draw-dot", ada).status.value, "others may still be at work")
            assertEquals("2", one("SELECT count(*) FROM submissions"))
            val student = one("SELECT id FROM students")
            send("/instructor/exams/$exam/students/$student/extra", cookieOf(instructor), "extra" to "5")
            assertEquals(listOf(302, 302), tries("class Dot { int given; }"), "staff gave more minutes for it")
            pass(Duration.ofSeconds(330))
            assertEquals(listOf(409, 409), tries("class Dot { int late; }"))
            pass(Duration.ofHours(2))
            assertEquals(200, page("/exercises/draw-dot", ada).status.value)
        }

    @Test
    @DisplayName("a student goes on from an address that is not allowed, or a change of address is not noted")
    fun anotherAddressIsRefusedOrNoted() =
        classroom(ServerSettings(proxies = setOf(InetAddress.getByName("127.0.0.1")))).listen {
            val token = newStudent()
            val course = database.read { it.createQuery("SELECT id FROM courses").mapTo(String::class.java).one() }
            val made =
                send(
                    "POST",
                    "/api/v1/courses/$course/exams",
                    "Authorization: Bearer $instructor",
                    Wire.JSON,
                    body =
                        """{"name":"Midterm","exercises":["draw-dot"],"opens":"2027-03-01T08:00","minutes":60,"grace":0,
                            "closes":"2027-03-01T12:00","addresses":"192.0.2.0/24"}""".toByteArray(),
                )
            val exam = Regex("\"exam\":\"([^\"]+)\"").find(made.body())?.groupValues?.get(1)
            val form = "Content-Type: application/x-www-form-urlencoded"
            val origin = "Origin: http://127.0.0.1:$port"
            val entered = send("POST", "/sign-in", form, origin, body = "token=$token".toByteArray())
            val cookie = "Cookie: " + entered.header("Set-Cookie")?.substringBefore(';')
            val open = { from: String ->
                send("POST", "/exams/$exam/open", form, origin, cookie, "X-Forwarded-For: $from").statusCode()
            }
            val see = { from: String -> send("GET", "/exams/$exam", cookie, "X-Forwarded-For: $from").statusCode() }
            assertEquals(listOf(403, 302, 302), listOf("198.51.100.1", "192.0.2.7", "192.0.2.7").map(open))
            assertEquals(listOf(200, 200, 403), listOf("192.0.2.7", "192.0.2.8", "198.51.100.1").map(see))
            val forged = send("GET", "/exams/$exam", cookie, "X-Forwarded-For: 192.0.2.7, 198.51.100.1").statusCode()
            assertEquals(403, forged, "the client's own word")
            val noted =
                database.read {
                    it
                        .createQuery("SELECT kind || ' ' || address || ' ' || detail FROM exam_events ORDER BY number")
                        .mapTo(String::class.java)
                        .list()
                }
            val refused = "address-refused 198.51.100.1 "
            assertEquals(
                listOf(refused, "opened 192.0.2.7 ", "address 192.0.2.8 192.0.2.7", refused, refused),
                noted,
            )
        }

    @Test
    @DisplayName("a program makes no exam, gives no minutes and lets nobody in, or an exam that was begun is deleted")
    fun programsWatchOverExams() =
        classroom().open(grades = false) {
            val course = newCourse()
            val ada = newStudent(course)
            val exams = "/api/v1/courses/$course/exams"
            val body =
                """{"name":"Midterm","exercises":["draw-dot"],"opens":"2027-03-01T10:00","closes":"2027-03-01T12:00",
                    "zone":"Europe/Moscow","minutes":30,"grace":30}"""
            val make =
                suspend {
                    client.post(exams) {
                        bearer(instructor)
                        json(body)
                    }
                }
            val first = make().json().text("exam")
            make().assertProblem(422, "bad-exam")
            look(ada, "/api/v1/exercises/draw-dot").assertProblem(404, "unknown-exercise")
            val drop = suspend { exam: String -> client.delete("/api/v1/exams/$exam") { bearer(instructor) } }
            assertEquals(200, drop(first).status.value)
            assertEquals(200, look(ada, "/api/v1/exercises/draw-dot").status.value)
            val made = make().json()
            assertEquals("2027-03-01T07:00:00.000Z", made.text("opens"))
            val exam = made.text("exam")
            assertEquals(302, open(exam, cookieOf(ada)).status.value)
            drop(exam).assertProblem(422, "bad-exam")
            val student = one("SELECT id FROM students")
            val given =
                client.patch("/api/v1/exams/$exam/students/$student") {
                    bearer(instructor)
                    json("""{"extra":7}""")
                }
            assertEquals("2027-03-01T09:07:00.000Z", given.json().text("endsAt"))
            assertEquals(
                200,
                client.post("/api/v1/exams/$exam/students/$student/release") { bearer(instructor) }.status.value,
            )
            assertEquals(302, open(exam, cookieOf(ada)).status.value)
            val own = look(ada, "/api/v1/exams").bodyAsText()
            assertTrue("\"state\":\"running\"" in own && "\"secondsLeft\":420" in own, own)
            assertEquals(403, look(ada, exams).status.value)
            assertEquals("opened extra released", kinds())
        }
}
