package rasterlab.grader.worker

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.postgres.OnPostgres
import rasterlab.grader.postgres.Relay
import java.nio.file.Path

/** Worker processes on one database. */
@OnPostgres
@Tag("slow")
class WorkersTest {
    @TempDir
    lateinit var folder: Path

    @Test
    @DisplayName("a worker that an instructor drains drops what it grades, takes more, or stays on the list")
    fun endsWhatItGrades() =
        SharedCourse(folder, "drained").use { course ->
            val ada = course.student("Ada")
            val worker = course.worker("first")
            assertEquals(listOf("first"), course.workers.all().map { it.worker.name })
            repeat(5) { course.handIn(ada) }
            course.await("expected a submission to be taken") { course.heldBy("first").isNotEmpty() }
            val taken = course.heldBy("first")
            course.workers.drain("first", drains = true, by = "test")
            assertEquals(0, worker.exit())
            val done = course.rows("SELECT id FROM submissions WHERE state = 'done'")
            assertTrue(done.containsAll(taken), "taken $taken, done $done")
            assertEquals(
                emptyList<String>(),
                course.rows("SELECT id FROM submissions WHERE state <> 'done' AND tries > 0"),
            )
            assertEquals(emptyList<String>(), course.workers.all().map { it.worker.name })
            course.worker("first")
            course.awaitAllDone()
            course.requireEachOnce()
        }

    @Test
    @DisplayName("a worker that is told to end keeps others waiting for what it grades, or counts that as a try")
    fun putsBackWhatItGrades() =
        SharedCourse(folder, "stopped").use { course ->
            val worker = course.worker("first")
            val id = course.handInEndless(course.student("Ada"))
            course.await("expected the submission to be taken") { course.heldBy("first") == listOf(id) }
            worker.signal("TERM")
            assertEquals(TERMINATED, worker.exit())
            assertEquals(listOf("queued 0"), course.rows("SELECT state || ' ' || tries FROM submissions"))
            assertEquals(emptyList<String>(), course.workers.all().map { it.worker.name })
            course.worker("second")
            course.await("expected the other to take it up") { course.heldBy("second") == listOf(id) }
        }

    @Test
    @DisplayName("a worker that was cut off writes a second result, or one that starts anew waits for its own lease")
    fun cutOffInTheMiddle() =
        SharedCourse(folder, "cut").use { course ->
            val ada = course.student("Ada")
            val first = course.worker("first")
            course.handIn(ada)
            course.await("expected the submission to be taken") { course.heldBy("first").isNotEmpty() }
            first.signal("STOP")
            course.expire("first")
            val second = course.worker("second")
            course.awaitAllDone()
            first.signal("CONT")
            course.await("expected the late result to be told") {
                "was given to another worker" in course.logOf("first")
            }
            course.requireEachOnce()

            course.handIn(ada)
            course.await("expected it to be taken") { course.rows(TAKEN).isNotEmpty() }
            val holder = course.rows(TAKEN).single().substringBefore(' ')
            (if (holder == "first") first else second).kill()
            (if (holder == "first") second else first).kill()
            course.worker(holder)
            course.awaitAllDone()
            course.requireEachOnce()
        }

    @Test
    @DisplayName("a worker that a split network cut off writes a second result, or takes nothing when it is mended")
    fun goesOnAfterASplitNetwork() =
        SharedCourse(folder, "split").use { course ->
            val ada = course.student("Ada")
            Relay(course.address).use { network ->
                course.worker("first", through = network.address)
                val id = course.handIn(ada)
                course.await("expected the submission to be taken") { course.heldBy("first") == listOf(id) }
                network.cut()
                course.expire("first")
                val second = course.worker("second")
                course.awaitAllDone()
                second.kill()
                val next = course.handIn(ada)
                network.mend()
                course.awaitAllDone()
                course.requireEachOnce()
                assertEquals(listOf("done"), course.rows("SELECT state FROM submissions WHERE id = '$next'"))
            }
        }

    @Test
    @DisplayName("a worker waits for a ring that another process is taking, and takes no other meanwhile")
    fun passesOverARingThatAnotherTakes() =
        SharedCourse(folder, "rings").use { course ->
            val ada = course.student("Ada")
            repeat(2) { course.handIn(ada) }
            course.database.write { it.execute(RING) }
            course.connection().use { other ->
                other.autoCommit = false
                other.createStatement().use { it.executeQuery("SELECT * FROM scheduled_tasks FOR UPDATE") }
                course.worker("first")
                course.await("expected a submission to be graded meanwhile") { course.rows(DONE).isNotEmpty() }
                other.rollback()
            }
            course.awaitAllDone()
            course.requireEachOnce()
        }

    @Test
    @DisplayName("two workers of one name, or one without a shared database, start")
    fun refusesToStart() =
        SharedCourse(folder, "refused").use { course ->
            course.worker("first")
            val same = course.start("worker", "--db", course.address, "--data", "$folder/same", "--name", "first")
            assertEquals(2, same.exit())
            for (db in listOf(listOf("--db", "sqlite:$folder/a.db"), emptyList())) {
                assertEquals(2, course.start("worker", "--data", "$folder/none", *db.toTypedArray()).exit())
            }
        }

    private companion object {
        /** Java exits with it at that signal, whatever was done before. */
        const val TERMINATED = 143

        /** A ring that was due before all others. */
        const val RING =
            """INSERT INTO scheduled_tasks (task_name, task_instance, execution_time, picked, version)
               VALUES ('grade', 'first of all', '2000-01-01T00:00:00Z', false, 1)"""
        const val DONE = "SELECT id FROM submissions WHERE state = 'done'"
        const val TAKEN = "SELECT lease FROM submissions WHERE state = 'running'"
    }
}
