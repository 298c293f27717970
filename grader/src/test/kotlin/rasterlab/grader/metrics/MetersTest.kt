package rasterlab.grader.metrics

import io.ktor.client.request.get
import io.ktor.client.statement.bodyAsText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.json
import rasterlab.grader.postgres.TestDatabases
import rasterlab.grader.submission.State
import rasterlab.grader.submission.Submission
import rasterlab.grader.text
import java.nio.file.Path
import java.time.Instant
import java.time.InstantSource

open class MetersTest {
    @TempDir
    lateinit var folder: Path

    @Test
    @DisplayName("who watches the server does not see what it grades, how long it takes and how long is waited")
    fun aGradedSubmissionIsCounted() =
        Classroom(folder).open {
            val student = newStudent()
            eventsToTheEnd(student, submit(student).json().text("id"))
            val lines = metrics()
            assertTrue("""rasterlab_submissions{state="done"} 1.0""" in lines, "$lines")
            assertTrue("""rasterlab_submissions{state="queued"} 0.0""" in lines, "$lines")
            assertTrue("""rasterlab_results_total{verdict="wrong"} 1.0""" in lines, "$lines")
            assertTrue("""rasterlab_grading_seconds_count{exercise="draw-dot"} 1""" in lines, "$lines")
            assertTrue("rasterlab_queue_wait_seconds_count 1" in lines, "$lines")
            assertTrue("rasterlab_oldest_waiting_seconds 0.0" in lines, "$lines")
            for (name in listOf("rasterlab_heap_bytes ", "rasterlab_disk_free_bytes ", "jvm_threads_live_threads ")) {
                assertEquals(1, lines.count { it.startsWith(name) }, name)
            }
            assertTrue("""hikaricp_connections_max{pool="writer"} 1.0""" in lines, "$lines")
        }

    @Test
    @DisplayName("a person, a token or a source stands in what watchers read, or what was sent makes lines")
    fun nobodyIsNamed() =
        Classroom(folder).open {
            val student = newStudent()
            val before = metrics().size
            val id = submit(student, "class Mine { }").json().text("id")
            eventsToTheEnd(student, id)
            repeat(20) { client.get("/no/such/page/$it") }
            val text = metrics().joinToString("\n")
            for (secret in listOf("Ada", student, instructor, id, "Mine", "such")) assertFalse(secret in text, secret)
            // The first attempt at an exercise makes the lines of its timer.
            assertTrue(text.lines().size - before < 20, text)
        }

    @Test
    @DisplayName("children are not counted, or a wait is told of an attempt that is not the first")
    fun childrenAndFirstWaitsAreCounted() {
        val now = Instant.parse("2026-11-28T12:00:00Z")
        TestDatabases.open(folder).use { database ->
            val meters = Meters(database, { 3 }, InstantSource.fixed(now))
            meters.waited(submission(now.minusSeconds(7), tries = 1))
            meters.waited(submission(now.minusSeconds(50), tries = 2))
            meters.waited(submission(now.plusSeconds(50), tries = 1))
            val lines = meters.text().lines()
            assertTrue("rasterlab_children 3.0" in lines, "$lines")
            assertTrue("rasterlab_queue_wait_seconds_sum 7.0" in lines, "$lines")
            assertTrue("""rasterlab_queue_wait_seconds_bucket{le="5.0"} 1""" in lines, "$lines")
            assertTrue("rasterlab_queue_wait_seconds_count 2" in lines, "$lines")
        }
    }

    private suspend fun Visit.metrics() = client.get("/metrics").bodyAsText().lines()

    private fun submission(
        received: Instant,
        tries: Int,
    ) = Submission("s", "p", "draw-dot", "r1", 1, "", 1, received, State.RUNNING, tries, 0, 0, null)
}
