package rasterlab.grader.worker

import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.post
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.exercises.score.Message
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.assertProblem
import rasterlab.grader.bearer
import rasterlab.grader.cookieOf
import rasterlab.grader.json
import rasterlab.grader.one
import rasterlab.grader.sendForm
import rasterlab.grader.text
import java.nio.file.Path
import java.time.Duration
import java.time.Instant

/** An instructor looks at who grades, and drains one. */
class WorkerRoutesTest {
    @TempDir
    lateinit var folder: Path

    @Test
    @DisplayName("who is drained is said to take work, or nobody is noted to have asked for it")
    fun tellsWhoIsDrained() =
        Classroom(folder).open {
            assertEquals(listOf("server" to "taking"), all().map { it.text("worker") to it.text("state") })
            assertEquals(Classroom.ISOLATION.describe("en"), all().single().text("isolation"))
            assertEquals("draining", client.post("$WORKERS/server/drain") { bearer(instructor) }.json().text("state"))
            assertEquals("draining", all().single().text("state"))
            assertTrue("Takes no more work" in page(), page())
            assertEquals(302, sendForm("$PAGE/server/resume", "").status.value)
            assertTrue("Takes work" in page() && "Drain" in page(), page())
            assertEquals("taking", all().single().text("state"))
            assertEquals("taking", client.post("$WORKERS/server/resume") { bearer(instructor) }.json().text("state"))
            client.post("$WORKERS/nobody/drain") { bearer(instructor) }.assertProblem(404, "unknown-worker")
            val audit = look(instructor, "/api/v1/audit").bodyAsText()
            assertTrue("worker-drain" in audit && "worker-resume" in audit, audit)
        }

    @Test
    @DisplayName("asking for what is so already is written as a change")
    fun notesOnlyWhatChanged() =
        Classroom(folder).open {
            for (ask in listOf("resume", "resume", "drain", "drain", "resume", "resume")) {
                assertEquals(200, client.post("$WORKERS/server/$ask") { bearer(instructor) }.status.value)
            }
            val noted = "SELECT count(*) FROM audit WHERE action = 'worker-"
            assertEquals(listOf("1", "1"), listOf("drain'", "resume'").map { one(noted + it) })
        }

    @Test
    @DisplayName("one that is silent is not told from the others, and stays for ever")
    fun tellsWhoIsLost() =
        Classroom(folder).open(grades = false) {
            var now = Instant.parse("2026-03-29T00:59:59Z")
            val workers = Workers(database, { now }, Duration.ofMinutes(1))
            val ada = Worker.here("ada", serves = false, Classroom.ISOLATION, slots = 2)
            workers.begin(ada)
            now += Duration.ofSeconds(61)
            workers.begin(ada.copy(name = "bob"))
            assertEquals(
                listOf("ada" to WorkerState.LOST, "bob" to WorkerState.TAKING),
                workers.all().map { it.worker.name to it.state },
            )
            assertTrue(workers.seen(ada))
            assertEquals(listOf(WorkerState.TAKING, WorkerState.TAKING), workers.all().map { it.state })
            now += Duration.ofDays(1) + Duration.ofSeconds(1)
            workers.begin(ada.copy(name = "cleo"))
            assertEquals(listOf("cleo"), workers.all().map { it.worker.name })
        }

    @Test
    @DisplayName("a worker is shown for ever with the isolation of its start, or draining ends when it changes")
    fun tellsTheIsolationThatThereIsNow() =
        Classroom(folder).open(grades = false) {
            var said = Message.of("isolation.image-making")
            val workers = Workers(database, { Instant.EPOCH }, Duration.ofMinutes(1))
            val presence = Presence(workers) { Worker("ada", "host", serves = false, said, slots = 1) }
            presence.begin()
            workers.drain("ada", drains = true, "somebody")
            said = Message.of("isolation.plain")
            assertTrue(presence.seen())
            assertEquals(
                said,
                workers
                    .all()
                    .single()
                    .worker.isolation,
            )
        }

    private suspend fun Visit.all(): List<JsonObject> =
        Json.parseToJsonElement(look(instructor, WORKERS).bodyAsText()).jsonArray.map { it.jsonObject }

    private suspend fun Visit.page(): String {
        val cookie = cookieOf(instructor)
        return client.get(PAGE) { header(HttpHeaders.Cookie, cookie) }.bodyAsText()
    }

    private companion object {
        const val PAGE = "/instructor/workers"
        const val WORKERS = "/api/v1/workers"
    }
}
