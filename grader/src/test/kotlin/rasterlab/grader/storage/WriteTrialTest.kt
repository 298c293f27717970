package rasterlab.grader.storage

import io.ktor.client.request.get
import org.jdbi.v3.core.JdbiException
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.Classroom
import rasterlab.grader.assertProblem
import java.nio.file.Path
import java.time.Duration

class WriteTrialTest {
    @TempDir
    lateinit var folder: Path
    private var now = 0L

    @Test
    @DisplayName("a server says that it is ready where nothing can be written")
    fun isNotReadyWithoutWrites() =
        Classroom(folder).run {
            open(grades = false) {
                refuseWrites(database)
                client.get("/readyz").assertProblem(503, "storage")
            }
        }

    @Test
    @DisplayName("each question waits for the disk, or one that went well counts for ever")
    fun oneThatWentWellCountsForASecond() {
        Database.open(folder.resolve("test.db")).use { database ->
            val trial = WriteTrial(database) { now }
            trial.require()
            assertEquals(0, rows(database), "something is left behind")
            refuseWrites(database)
            now = Duration.ofMillis(999).toNanos()
            trial.require()
            now = Duration.ofSeconds(1).toNanos()
            assertThrows(JdbiException::class.java) { trial.require() }
        }
    }

    @Test
    @DisplayName("one that failed counts as one that went well")
    fun oneThatFailedIsMadeAgain() {
        Database.open(folder.resolve("test.db")).use { database ->
            refuseWrites(database)
            val trial = WriteTrial(database) { now }
            repeat(2) { assertThrows(JdbiException::class.java) { trial.require() } }
        }
    }

    private fun refuseWrites(database: Database) {
        database.write {
            it.execute("CREATE TRIGGER refused BEFORE INSERT ON secrets BEGIN SELECT raise(ABORT, 'refused'); END")
        }
    }

    private fun rows(database: Database): Int =
        database.read { it.createQuery("SELECT count(*) FROM secrets").mapTo(Int::class.javaObjectType).one() }
}
