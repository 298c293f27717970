package rasterlab.grader

import ch.qos.logback.classic.Logger
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledOnOs
import org.junit.jupiter.api.condition.OS
import org.junit.jupiter.api.io.TempDir
import org.slf4j.LoggerFactory
import java.nio.file.Path
import java.nio.file.attribute.PosixFilePermissions
import kotlin.io.path.createFile
import kotlin.io.path.getPosixFilePermissions
import kotlin.io.path.setPosixFilePermissions

class LogsTest {
    @TempDir
    lateinit var folder: Path
    private val root = LoggerFactory.getLogger(Logger.ROOT_LOGGER_NAME) as Logger

    @AfterEach
    fun stop() {
        root.getAppender("file")?.stop()
        root.detachAppender("file")
    }

    @Test
    @DisplayName("others may read the log, whether it is new or was there")
    @DisabledOnOs(OS.WINDOWS)
    fun theLogIsForItsOwner() {
        val old = folder.resolve("old.log").createFile()
        old.setPosixFilePermissions(PosixFilePermissions.fromString("rw-r--r--"))
        for (file in listOf(old, folder.resolve("new.log"))) {
            logTo(file)
            assertEquals("rw-------", PosixFilePermissions.toString(file.getPosixFilePermissions()))
            stop()
        }
    }
}
