package rasterlab.grader.submission

import kotlinx.coroutines.runBlocking
import kotlinx.coroutines.withTimeout
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.exercises.Grading
import rasterlab.exercises.score.GradingVerdict
import rasterlab.exercises.score.ScorePoints
import rasterlab.grader.ClassOfStudents
import rasterlab.grader.Classroom
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.storage.Database
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.sql.Connection
import java.sql.DriverManager
import java.time.InstantSource
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit.SECONDS
import kotlin.time.Duration.Companion.seconds

/** The database is locked, or its disk full, while submissions wait and are graded; then it is free again. */
@Tag("slow")
class StorageFullTest {
    @TempDir
    lateinit var folder: Path
    private val clock = InstantSource.system()
    private val begun = CountDownLatch(1)
    private val goOn = CountDownLatch(1)
    private val mounted = mutableListOf<Path>()

    @AfterEach
    fun unmount() = mounted.forEach { run("umount", "$it") }

    @Test
    @DisplayName("a result is lost, or comes a minute late, when the database is locked as it is written")
    fun gradesOnAfterTheDatabaseWasLocked() {
        val file = folder.resolve("test.db")
        gradesOn(file) { failed ->
            DriverManager.getConnection("jdbc:sqlite:$file").use { other ->
                other.execute("BEGIN IMMEDIATE")
                goOn.countDown()
                failed()
                other.execute("ROLLBACK")
            }
        }
    }

    @Test
    @DisplayName("a result is lost, or comes a minute late, when the disk is full as it is written")
    fun gradesOnAfterTheDiskWasFull() {
        val disk = Files.createDirectory(folder.resolve("disk"))
        assumeTrue(run("mount", "-t", "tmpfs", "-o", "size=80m", "tmpfs", "$disk"), "a small disk cannot be mounted")
        mounted.add(disk)
        gradesOn(disk.resolve("test.db")) { failed ->
            val filler = disk.resolve("filler")
            fill(filler)
            goOn.countDown()
            failed()
            Files.delete(filler)
        }
    }

    /**
     * Hands in two, brings the trouble about while the first is graded, and ends it when a write has failed.
     *
     * @param trouble calls what it is given to wait for that
     */
    private fun gradesOn(
        file: Path,
        trouble: (() -> Unit) -> Unit,
    ) = Database.open(file, BUSY_MILLIS).use { database ->
        val students = ClassOfStudents(database, clock)
        val ids = List(2) { students.handIn(students.student("Ada $it")) }
        val submissions = Submissions(database)
        val live = Live()
        val failed = CountDownLatch(1)
        queue(database, live, failed).use { queue ->
            queue.start()
            assertTrue(begun.await(120, SECONDS), "grading has not begun")
            trouble { assertTrue(failed.await(120, SECONDS), "no write of a result failed") }
            awaitAll(live) { ids.all { submissions.find(it)?.state == State.DONE } }
        }
        assertEquals(listOf(1, 1), ids.map { submissions.find(it)?.tries })
    }

    private fun awaitAll(
        live: Live,
        done: () -> Boolean,
    ) = runBlocking {
        withTimeout(120.seconds) {
            while (true) {
                val seen = live.stand(null)
                if (done()) break
                live.awaitChange(null, seen)
            }
        }
    }

    /** @param failed told when an attempt asks whether the server stops, as it does only after a failure */
    private fun queue(
        database: Database,
        live: Live,
        failed: CountDownLatch,
    ): GradingQueue {
        val steady = SteadyClock(clock)
        val leases = Leases(database, Reports(database), clock, steady)
        val grading =
            Grading { _, _, _, _ ->
                begun.countDown()
                goOn.await()
                Classroom.report(GradingVerdict.OK, ScorePoints(6, 3, 1, 10))
            }
        val attempts =
            Attempts(database, leases, Exercises(listOf(Classroom.EXERCISE)), grading, live) {
                failed.countDown()
                false
            }
        return GradingQueue(database, Submissions(database), leases, attempts, live, steady, workers = 1)
    }

    private fun fill(file: Path) {
        val block = ByteArray(1 shl 12)
        try {
            Files.newOutputStream(file).use { out -> while (true) out.write(block) }
        } catch (full: IOException) {
            assertTrue(Files.size(file) > 0, "the disk took nothing: $full")
        }
    }

    private fun run(vararg command: String): Boolean =
        try {
            ProcessBuilder(*command).redirectErrorStream(true).start().run {
                inputStream.readAllBytes()
                waitFor() == 0
            }
        } catch (missing: IOException) {
            false
        }

    private fun Connection.execute(sql: String) = createStatement().use { it.execute(sql) }

    private companion object {
        const val BUSY_MILLIS = 50
    }
}
