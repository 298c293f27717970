package rasterlab.grader.adjustment

import io.ktor.client.request.delete
import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.patch
import io.ktor.client.request.post
import io.ktor.client.statement.HttpResponse
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonObject
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
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
import rasterlab.grader.sendForm
import rasterlab.grader.text
import java.nio.file.Path

/** Points from staff stand beside those of grading, with their reason, and count wherever points are told. */
@Tag("slow")
class AdjustmentsTest {
    @TempDir
    lateinit var folder: Path

    @Test
    @DisplayName("points by hand do not count, are not told with their reason, or do not go when they are taken back")
    fun countWhereverPointsAreTold() =
        Classroom(folder).open {
            val course = newCourse()
            val student = newStudent(course)
            val id = handIn(student)
            val given = give(id, """{"points":3,"reason":"nice <comments>"}""").json()
            assertEquals(listOf("7", "10"), listOf("total", "of").map(given::text))
            assertEquals(listOf("3", "4"), listOf("points", "before").map(given.list("adjustments")[0]::field))
            give(id, """{"points":-9,"reason":"late talk"}""")
            assertEquals("0" to 2, total(student, id) to manual(student, id).size)
            assertEquals("number,name,draw-dot,total\r\n1,Ada,0,0\r\n", grades(course))
            val late = look(instructor, "/api/v1/submissions/$id/points").json().list("adjustments")[1].field("id")
            val left = client.delete("/api/v1/submissions/$id/points/$late") { bearer(instructor) }.json()
            assertEquals("7", left.text("total"))
            assertFalse(
                left.list("adjustments")[1].jsonObject["revokedAt"] is JsonNull,
                "who took it back is not noted",
            )
            assertEquals(listOf("nice <comments>"), manual(student, id).map { it.field("reason") })
            assertEquals("number,name,draw-dot,total\r\n1,Ada,7,7\r\n", grades(course))
            val best = look(student, "/api/v1/exercises/draw-dot").json()
            assertTrue("7" in "${best["best"]}", "$best")
            val notes = listOf("points 3, before 4", "points -9, before 7", "points-revoke -9")
            val noted = "SELECT action || ' ' || detail FROM audit WHERE action LIKE 'points%' ORDER BY noted_at, rowid"
            assertEquals(notes, texts(noted))
            val changes = show("/instructor/audit", instructor)
            assertTrue("<div>points by hand taken back</div>" in changes, changes)
            assertTrue("""<a href="/submissions/$id">Ada</a>""" in changes, changes)
        }

    @Test
    @DisplayName("points survive no regrade, or one counts twice")
    fun staysWhenItIsGradedAgain() =
        Classroom(folder).open {
            val course = newCourse()
            val student = newStudent(course)
            val id = handIn(student)
            give(id, """{"points":2,"reason":"fine"}""")
            val begun =
                client.post("/api/v1/courses/$course/exercises/draw-dot/regrade") {
                    bearer(instructor)
                    json("{}")
                }
            val regrade = begun.json().text("regrade")
            look(instructor, "/api/v1/regrades/$regrade/events").bodyAsText()
            val change =
                look(instructor, "/api/v1/regrades/$regrade")
                    .json()
                    .list("changes")
                    .single()
                    .jsonObject
            assertEquals(listOf("4", "4"), listOf("before", "after").map { change.getValue(it).field("points") })
            assertEquals("6", total(student, id))
        }

    @Test
    @DisplayName("a student gives points, what are none are given, or a repeated request gives them twice")
    fun refusesWhatCannotBe() =
        Classroom(folder).open {
            val student = newStudent()
            val id = handIn(student)
            val fine = """{"points":1,"reason":"r"}"""
            give(id, fine, by = student).assertProblem(403, "wrong-role")
            look(student, "/api/v1/submissions/$id/points").assertProblem(403, "wrong-role")
            give("none", fine).assertProblem(404, "unknown-submission")
            for (points in listOf("0", "1001", "-1001", "1.5", "\"x\"", "null")) {
                give(id, """{"points":$points,"reason":"r"}""").assertProblem(422, "bad-adjustment")
            }
            for (reason in listOf(" ", "x".repeat(201), "a\\nb")) {
                give(id, """{"points":1,"reason":"$reason"}""").assertProblem(422, "bad-adjustment")
            }
            for (body in listOf("""{"points":1}""", """{"points":[],"reason":"r"}""")) {
                give(id, body).assertProblem(400, "malformed-request")
            }
            repeat(2) { assertEquals("5", give(id, fine, key = "once").json().text("total")) }
            give(id, """{"points":2,"reason":"r"}""", key = "once").assertProblem(422, "idempotency-key-reused")
            val one = texts("SELECT id FROM adjustments").single()
            revoke(id, one, by = student).assertProblem(403, "wrong-role")
            revoke(handIn(student), one).assertProblem(404, "unknown-adjustment")
            assertEquals(200, revoke(id, one).status.value)
            revoke(id, one).assertProblem(422, "bad-adjustment")
        }

    @Test
    @DisplayName("a submission without a result is given points")
    fun waitsForAResult() =
        Classroom(folder).open(grades = false) {
            val id = submit(newStudent()).json().text("id")
            give(id, """{"points":1,"reason":"r"}""").assertProblem(422, "bad-adjustment")
        }

    @Test
    @DisplayName("the page gives no points, loses what was typed, or the student does not read why")
    fun onThePage() =
        Classroom(folder).open {
            val student = newStudent()
            val id = handIn(student)
            val page = "/instructor/submissions/$id"
            assertEquals(403, send("$page/points", "points=1&reason=r", by = student).status.value)
            val refused = send("$page/points", "points=0&reason=why+not")
            assertEquals(422, refused.status.value)
            assertTrue("value=\"why not\"" in refused.bodyAsText(), refused.bodyAsText())
            assertEquals(302, send("$page/points", "points=-1&reason=%3Cb%3E").status.value)
            val seen = show("/submissions/$id?lang=en", student)
            assertTrue("3 of 10 points" in seen && "<li>−1 from your teachers: &lt;b&gt;</li>" in seen, seen)
            assertFalse("/instructor/" in seen, "a student is shown the forms")
            assertTrue("−1 от преподавателя: &lt;b&gt;" in show("/submissions/$id?lang=ru", student))
            assertTrue("−1 from staff" in show("/exercises/draw-dot?lang=en", student))
            val revoke = Regex("action=\"([^\"]*/revoke)\"").find(show("/submissions/$id?lang=en", instructor))
            assertEquals(302, send(checkNotNull(revoke).groupValues[1], "").status.value)
            assertTrue("taken back" in show("/submissions/$id?lang=en", instructor))
            assertFalse("from your teachers" in show("/submissions/$id?lang=en", student))
            val regrade = send("$page/regrade", "").headers[HttpHeaders.Location].orEmpty()
            assertTrue(regrade.startsWith("/instructor/regrades/"), regrade)
        }

    private suspend fun Visit.handIn(student: String): String {
        val id = submit(student).json().text("id")
        eventsToTheEnd(student, id)
        return id
    }

    private suspend fun Visit.give(
        id: String,
        body: String,
        by: String = instructor,
        key: String? = null,
    ): HttpResponse =
        client.patch("/api/v1/submissions/$id/points") {
            bearer(by)
            key?.let { header("Idempotency-Key", it) }
            json(body)
        }

    private suspend fun Visit.revoke(
        id: String,
        adjustment: String,
        by: String = instructor,
    ): HttpResponse = client.delete("/api/v1/submissions/$id/points/$adjustment") { bearer(by) }

    private suspend fun Visit.points(
        student: String,
        id: String,
    ): JsonObject = look(student, "/api/v1/submissions/$id").json().getValue("points").jsonObject

    private suspend fun Visit.total(
        student: String,
        id: String,
    ): String = points(student, id).text("total")

    private suspend fun Visit.manual(
        student: String,
        id: String,
    ): List<JsonElement> = points(student, id).list("manual")

    private suspend fun Visit.grades(course: String): String =
        look(instructor, "/api/v1/courses/$course/grades.csv").bodyAsText()

    private suspend fun Visit.show(
        path: String,
        by: String,
    ): String {
        val cookie = cookieOf(by)
        return client.get(path) { header(HttpHeaders.Cookie, cookie) }.bodyAsText()
    }

    private suspend fun Visit.send(
        path: String,
        body: String,
        by: String = instructor,
    ): HttpResponse = sendForm("$path?lang=en", body, by)

    private fun Visit.texts(sql: String): List<String> =
        database.read { it.createQuery(sql).mapTo(String::class.java).list() }
}
