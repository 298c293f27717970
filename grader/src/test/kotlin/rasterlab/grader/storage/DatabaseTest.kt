package rasterlab.grader.storage

import org.jdbi.v3.core.JdbiException
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path

class DatabaseTest {
    @TempDir
    lateinit var folder: Path

    @Test
    fun aFailedStatementDoesNotRepeatItsValues() {
        Database.open(folder.resolve("test.db")).use { database ->
            val failure =
                assertThrows<JdbiException> {
                    database.write { it.createUpdate("UPDATE nothing SET x = :x").bind("x", "a secret").execute() }
                }
            assertFalse("a secret" in failure.stackTraceToString(), failure.stackTraceToString())
        }
    }
}
