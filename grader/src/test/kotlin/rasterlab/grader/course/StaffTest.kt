package rasterlab.grader.course

import io.ktor.client.request.delete
import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.patch
import io.ktor.client.request.post
import io.ktor.client.statement.HttpResponse
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonPrimitive
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.assertProblem
import rasterlab.grader.bearer
import rasterlab.grader.cookieOf
import rasterlab.grader.field
import rasterlab.grader.json
import rasterlab.grader.list
import rasterlab.grader.one
import rasterlab.grader.printedBy
import rasterlab.grader.problem.Paging
import rasterlab.grader.sendForm
import rasterlab.grader.text
import java.nio.file.Path
import java.time.Instant
import java.time.InstantSource

/** Who teaches, by name and with a token each; and what they changed. */
@Tag("slow")
class StaffTest {
    @TempDir
    lateinit var folder: Path

    @Test
    @DisplayName("somebody added has no access, or keeps it when it is taken away, or their sessions go on")
    fun accessIsGivenAndTakenAway() =
        Classroom(folder).open(grades = false) {
            newCourse()
            val added = add("Grace Hopper", "assistant").json()
            val (id, token) = added.text("staff") to added.text("token")
            assertEquals(listOf("" to "instructor", "Grace Hopper" to "assistant"), listed().map(::nameAndRole))
            assertEquals("null", listed()[1].field("lastUsedAt"), "nobody was here yet")
            val accounts = Accounts(database, InstantSource.system())
            val session = accounts.open(checkNotNull(accounts.holder(token)))
            assertNotEquals("null", listed()[1].field("lastUsedAt"))
            assertEquals(200, look(token, "/api/v1/courses/${courseId()}/students").status.value)
            assertEquals(200, client.delete("/api/v1/staff/$id") { bearer(instructor) }.status.value)
            look(token, "/api/v1/exercises").assertProblem(401, "not-signed-in")
            assertEquals(null, accounts.inSession(session), "the session goes on")
            assertNotEquals("null", listed()[1].field("revokedAt"))
            val again = client.post("/api/v1/staff/$id/token") { bearer(instructor) }.json().text("token")
            assertEquals(200, look(again, "/api/v1/exercises").status.value)
            look(token, "/api/v1/exercises").assertProblem(401, "not-signed-in")
            client.post("/api/v1/staff/none/token") { bearer(instructor) }.assertProblem(404, "unknown-staff")
        }

    @Test
    @DisplayName(
        "the first instructor stays without a name, a note of before has none, or a name is taken that is none",
    )
    fun aNameIsGiven() =
        Classroom(folder).open(grades = false) {
            newCourse()
            val first = listed()[0].field("staff")
            assertEquals("Ada Byron", rename(first, "Ada Byron").json().text("name"))
            assertEquals(
                "Ada Byron",
                look(instructor, "/api/v1/audit")
                    .json()
                    .list("entries")
                    .last()
                    .field("byName"),
            )
            rename(first, " ").assertProblem(422, "bad-name")
            rename("none", "Ada").assertProblem(404, "unknown-staff")
            assertEquals(302, sendForm("/instructor/staff/$first/name", "name=Ada+King").status.value)
            assertEquals("name\tAda", printedBy(folder, "staff", "rename", first, "Ada").trim())
            assertEquals("Ada", listed()[0].field("name"))
            assertEquals("3", one("SELECT count(*) FROM audit WHERE action = 'staff-name'"))
        }

    @Test
    @DisplayName("the last instructor is shut out, also where only assistants or others without access are left")
    fun theLastInstructorStays() =
        Classroom(folder).open(grades = false) {
            add("Grace", "assistant")
            val first = listed()[0].field("staff")
            client.delete("/api/v1/staff/$first") { bearer(instructor) }.assertProblem(409, "last-instructor")
            val second = add("Alan", "instructor").json()
            assertEquals(200, client.delete("/api/v1/staff/$first") { bearer(second.text("token")) }.status.value)
            look(instructor, "/api/v1/exercises").assertProblem(401, "not-signed-in")
            val last = second.text("staff")
            client.delete("/api/v1/staff/$last") { bearer(second.text("token")) }.assertProblem(409, "last-instructor")
            assertEquals(200, look(second.text("token"), "/api/v1/staff").status.value)
            assertTrue("only instructor" in command("revoke", last, exit = 2))
        }

    @Test
    @DisplayName("repeating a request adds somebody twice, or a name or a role is taken that is none")
    fun aRequestIsRepeatedAndNonsenseRefused() =
        Classroom(folder).open(grades = false) {
            val twice = List(2) { add("Grace", "assistant", key = "k1").bodyAsText() }
            assertEquals(twice[0], twice[1])
            assertEquals(2, listed().size)
            add("Grace", "instructor", key = "k1").assertProblem(422, "idempotency-key-reused")
            add("Grace", "dean").assertProblem(400, "malformed-request")
            add(" ", "assistant").assertProblem(422, "bad-name")
            assertEquals(2, listed().size)
        }

    @Test
    @DisplayName("a student whose token is taken away comes in, or loses work, or a new token lets nobody in")
    fun aStudentsTokenIsTakenAwayToo() =
        Classroom(folder).open(grades = false) {
            val token = newStudent()
            submit(token)
            val id = one("SELECT id FROM students")
            val address = "/api/v1/students/$id/token"
            val since = List(2) { client.delete(address) { bearer(instructor) }.json().text("revokedAt") }
            assertEquals(since[0], since[1], "it is taken away twice")
            look(token, "/api/v1/exercises").assertProblem(401, "not-signed-in")
            assertEquals("1", one("SELECT count(*) FROM submissions"))
            val page = show("/instructor/students/$id")
            assertTrue("No token lets this student in" in page && "Take the token away" !in page, page)
            val again = client.post(address) { bearer(instructor) }.json().text("token")
            assertEquals(200, look(again, "/api/v1/exercises").status.value)
            client.delete("/api/v1/students/none/token") { bearer(instructor) }.assertProblem(404, "unknown-student")
        }

    @Test
    @DisplayName("a change leaves no note, the notes are in another order, or a page of them leaves some out")
    fun everyChangeIsNoted() =
        Classroom(folder).open(grades = false) {
            newStudent()
            val student = one("SELECT id FROM students")
            client.patch("/api/v1/courses/${courseId()}/exercises/draw-dot") {
                bearer(instructor)
                json("""{"attempts":3}""")
            }
            client.post("/api/v1/students/$student/token") { bearer(instructor) }
            client.delete("/api/v1/students/$student/token") { bearer(instructor) }
            val id = add("Grace", "assistant").json().text("staff")
            client.post("/api/v1/staff/$id/token") { bearer(instructor) }
            client.delete("/api/v1/staff/$id") { bearer(instructor) }
            val noted = listOf("staff-revoke", "staff-token", "staff-add", "token-revoke", "token", "rules", "course")
            val entries = look(instructor, "/api/v1/audit").json().list("entries")
            assertEquals(noted.toSet(), entries.map { it.field("action") }.toSet())
            assertEquals(entries.map { it.field("at") }.sortedDescending(), entries.map { it.field("at") })
            assertEquals("Ada", entries.first { it.field("action") == "token" }.field("subjectName"))
            assertFalse(
                Regex("[A-Za-z0-9_-]{43}").containsMatchIn("$entries"),
                "a token or its hash is noted: $entries",
            )
            database.write { handle ->
                repeat(Paging.USUAL) { AuditNote("command", null, "course", "$it", "").write(handle, Instant.now()) }
            }
            val pages = mutableListOf(page(""))
            while (pages.last().second != "null") pages += page("?before=${pages.last().second}")
            assertEquals(listOf(Paging.USUAL, noted.size), pages.map { it.first.size })
            assertEquals(Paging.USUAL + noted.size, pages.flatMap { it.first }.toSet().size)
            look(instructor, "/api/v1/audit?before=none").assertProblem(400, "malformed-request")
            assertTrue("Earlier changes" in show("/instructor/audit"))
            assertTrue("Latest changes" in show("/instructor/audit?before=${pages[0].second}"))
        }

    @Test
    @DisplayName("the page adds nobody, shows no token, forgets a name that was typed, or lets a script through")
    fun thePageDoesItToo() =
        Classroom(folder).open(grades = false) {
            val page = "/instructor/staff"
            val shown = take(page, "name=%3Cb%3EGrace&role=assistant").bodyAsText()
            assertTrue("&lt;b&gt;Grace" in shown && "<b>Grace" !in shown, shown)
            val token = checkNotNull(Regex("""<code class="token">([^<]+)""").find(shown)) { shown }.groupValues[1]
            assertEquals(200, look(token, "/api/v1/exercises").status.value)
            assertTrue("Last here" in show(page) && token !in show(page))
            val refused = take(page, "name=Alan&role=dean")
            assertTrue(refused.status.value == 400 && "value=\"Alan\"" in refused.bodyAsText(), refused.bodyAsText())
            val first = listed()[0].field("staff")
            val last = take("$page/$first/revoke", "")
            assertTrue(
                last.status.value == 409 && "only instructor of all courses" in last.bodyAsText(),
                last.bodyAsText(),
            )
            val id = listed()[1].field("staff")
            assertEquals(302, take("$page/$id/revoke", "").status.value)
            assertTrue("Taken away on" in show(page))
            assertTrue("class=\"token\"" in take("$page/$id/token", "").bodyAsText())
        }

    @Test
    @DisplayName("an assistant is offered what only an instructor may do")
    fun anAssistantIsShownOnlyWhatIsTheirs() =
        Classroom(folder).open {
            val course = newCourse()
            val ada = newStudent(course)
            eventsToTheEnd(ada, submit(ada).json().text("id"))
            val token = add("Grace", "assistant").json().text("token")
            val student = one("SELECT id FROM students")
            val pages =
                listOf("", "/courses/$course/students", "/students/$student", "/courses/$course/exercises")
                    .map { "/instructor$it" } + "/instructor/exercises/draw-dot/similarity"
            for (page in pages) {
                val all = show(page, token)
                assertTrue(">Grace</span>" in all, "$page says not who is signed in: $all")
                val html = all.replace(Regex("""<form action="/instructor/students/[^"]*/view"[^>]*>"""), "")
                val targets = Regex("""(?:href|action)="(/instructor[^"?]*)""").findAll(html).map { it.groupValues[1] }
                for (target in targets) {
                    val answer = client.get(target) { header(HttpHeaders.Cookie, cookieOf(token)) }
                    assertEquals(200, answer.status.value, "$page leads to $target")
                }
                assertFalse(
                    Regex("""method="post"[^>]*action="/instructor|action="/instructor[^>]*post""") in html,
                    html,
                )
            }
        }

    @Test
    @DisplayName("the command adds, lists or shuts out nobody, or says nothing in Russian")
    fun theCommandDoesItToo() =
        Classroom(folder).open(grades = false) {
            val added = command("add", "Alan Turing", "--role", "instructor")
            val (id, token) = Regex("staff\t(.*)\ntoken\t(.*)\n").matchEntire(added)!!.destructured
            assertEquals(200, look(token, "/api/v1/staff").status.value)
            assertTrue(
                Regex("$id\tinstructor\t20\\S+Z\taccess\tall\tAlan Turing").containsMatchIn(command("list")),
                command("list"),
            )
            assertEquals("revoked\t$id\n", command("revoke", id))
            look(token, "/api/v1/staff").assertProblem(401, "not-signed-in")
            assertTrue("\trevoked\tall\tAlan Turing" in command("list"))
            assertTrue("token\t" in command("token", id))
            assertTrue("нет; кто есть" in command("token", "none", "--lang", "ru", exit = 2))
            assertTrue("command" in look(instructor, "/api/v1/audit").json().list("entries").map { it.field("by") })
        }

    @Test
    @DisplayName("of two changes that are asked for at once, one is made although the other cannot be")
    fun twoChangesAreOne() =
        Classroom(folder).open(grades = false) {
            val code = newCourse()
            val first = listed().single().field("staff")
            val name = listed().single().field("name")
            change(first, """{"name":"Boss","course":"none"}""").assertProblem(404, "unknown-course")
            change(first, """{"name":"Boss","course":"$code"}""").assertProblem(409, "last-instructor")
            assertEquals(name, listed().single().field("name"))
            assertEquals("Boss", change(first, """{"name":"Boss","course":null}""").json().field("name"))
        }

    @Test
    @DisplayName("staff of one course miss it, see another, keep what was changed, or count as staff of all")
    fun oneCourseIsGiven() =
        Classroom(folder).open(grades = false) {
            val code = newCourse()
            val own = courseId()
            val eve = newStudent(newCourse())
            val student = one("SELECT id FROM students")
            val other = one("SELECT course_id FROM students")
            val theirs = submit(eve).json().text("id")
            staffOf("none").assertProblem(404, "unknown-course")
            val added = staffOf(code).json()
            val (id, token) = added.text("staff") to added.text("token")
            assertEquals(own, listed().single { it.field("staff") == id }.field("course"))
            val students = { course: String -> "/api/v1/courses/$course/students" }
            assertEquals(200, look(token, students(own)).status.value)
            look(token, students(other)).assertProblem(404, "unknown-course")
            val desk = show("/instructor", token)
            for ((word, isThere) in listOf(
                own to true,
                other to false,
                theirs to false,
                "/instructor/staff" to false,
            )) {
                assertEquals(isThere, word in desk, "$word in $desk")
            }
            assertFalse(theirs in show("/instructor/latest", token))
            val viewing = "${cookieOf(token)}; $VIEW_COOKIE=$student"
            val page = client.get("/exercises") { header(HttpHeaders.Cookie, viewing) }.bodyAsText()
            assertFalse("Ada" in page, "the view of a student of another course: $page")
            val mine = submit(newStudent(code)).json().text("id")
            val beside = "/submissions/$mine/compare?first=$theirs&second="
            val read = client.get(beside + theirs) { header(HttpHeaders.Cookie, cookieOf(token)) }
            assertEquals(404, read.status.value, "read beside one of their own")
            val first = listed().first { it.field("staff") != id }.field("staff")
            change(first, """{"course":"$code"}""").assertProblem(409, "last-instructor")
            client.delete("/api/v1/staff/$first") { bearer(instructor) }.assertProblem(409, "last-instructor")
            assertEquals("course\tall\n", command("course", id, "all"))
            assertEquals(200, look(token, students(other)).status.value)
            assertTrue(theirs in show("/instructor", token))
            assertEquals(302, sendForm("/instructor/staff/$id/course", "course=$own").status.value)
            look(token, students(other)).assertProblem(404, "unknown-course")
            assertEquals("null", change(id, """{"course":null,"name":"Al"}""").json().field("course"))
            assertEquals("3", one("SELECT count(*) FROM audit WHERE action = 'staff-course'"))
        }

    @Test
    @DisplayName(
        "staff of one course are told of a role where nothing is, or an address of all courses is open to them",
    )
    fun whatIsNowhereIsNotFound() =
        Classroom(folder).open(grades = false) {
            val code = newCourse()
            val token = staffOf(code).json().text("token")
            val cookie = cookieOf(token)
            for (path in listOf("/instructor/none", "/none", "/instructor/staff/none/of/it")) {
                val page = client.get(path) { header(HttpHeaders.Cookie, cookie) }
                assertEquals(404, page.status.value, path)
                look(token, "/api/v1$path").assertProblem(404, "not-found")
            }
            for (path in listOf(
                "/instructor/staff",
                "/instructor/audit",
                "/instructor/exercises/draw-dot/similarity",
            )) {
                assertEquals(403, client.get(path) { header(HttpHeaders.Cookie, cookie) }.status.value, path)
            }
            look(token, "/api/v1/staff").assertProblem(403, "wrong-role")
            assertEquals(403, sendForm("/instructor/courses", "name=Mine", by = token).status.value)
            assertEquals("1", one("SELECT count(*) FROM courses"))
        }

    private suspend fun Visit.staffOf(course: String) =
        client.post("/api/v1/staff") {
            bearer(instructor)
            json("""{"name":"Alan","role":"instructor","course":"$course"}""")
        }

    private fun nameAndRole(one: kotlinx.serialization.json.JsonElement) = one.field("name") to one.field("role")

    private suspend fun Visit.page(query: String): Pair<List<String>, String> {
        val page = look(instructor, "/api/v1/audit$query").json()
        return page.list("entries").map { it.field("id") } to page.getValue("next").jsonPrimitive.content
    }

    private suspend fun Visit.add(
        name: String,
        role: String,
        key: String? = null,
    ): HttpResponse =
        client.post("/api/v1/staff") {
            bearer(instructor)
            key?.let { header("Idempotency-Key", it) }
            json("""{"name":"$name","role":"$role"}""")
        }

    private suspend fun Visit.rename(
        id: String,
        name: String,
    ) = change(id, """{"name":"$name"}""")

    private suspend fun Visit.change(
        id: String,
        changes: String,
    ) = client.patch("/api/v1/staff/$id") {
        bearer(instructor)
        json(changes)
    }

    private suspend fun Visit.listed(): JsonArray =
        Json.parseToJsonElement(look(instructor, "/api/v1/staff").bodyAsText()).jsonArray

    private suspend fun Visit.show(
        path: String,
        by: String = instructor,
    ): String {
        val cookie = cookieOf(by)
        val address = path + (if ('?' in path) "&" else "?") + "lang=en"
        return client.get(address) { header(HttpHeaders.Cookie, cookie) }.bodyAsText()
    }

    private suspend fun Visit.take(
        path: String,
        form: String,
    ): HttpResponse = sendForm("$path?lang=en", form)

    private fun command(
        vararg arguments: String,
        exit: Int = 0,
    ) = printedBy(folder, "staff", *arguments, exit = exit)

    private fun Visit.courseId() = one("SELECT id FROM courses")
}
