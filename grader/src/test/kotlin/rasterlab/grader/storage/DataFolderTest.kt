package rasterlab.grader.storage

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.io.path.writeText

class DataFolderTest {
    @TempDir
    lateinit var folder: Path

    @Test
    fun isForOneServerAtATime() {
        DataFolder.take(folder.resolve("data"), url = null).use {
            refuses("another server is using it") { DataFolder.take(folder.resolve("data"), url = null) }
        }
        DataFolder.take(folder.resolve("data"), url = null).close()
    }

    @Test
    fun givesOneDatabaseToOneServer() {
        val url = "sqlite:${folder.resolve("shared.db")}"
        DataFolder.take(folder.resolve("one"), url).use { one ->
            assertEquals(folder.resolve("shared.db"), one.databaseFile)
            refuses("another server is using it") { DataFolder.take(folder.resolve("two"), url) }
        }
    }

    @Test
    fun saysWhatIsWrong() {
        val file = folder.resolve("file").apply { writeText("x") }
        refuses("is a file, expected a folder") { DataFolder.take(file, url = null) }
        refuses("is a file, expected a folder") { DataFolder.take(file.resolve("below"), url = null) }
        refuses("PostgreSQL comes later") { DataFolder.take(folder, "postgresql://host/db") }
        refuses("plain file name") { DataFolder.take(folder, "sqlite::memory:") }
        refuses("there is no folder") { DataFolder.take(folder, "sqlite:$folder/none/x.db") }
        refuses("expected a file") { DataFolder.take(folder, "sqlite:$folder") }
    }

    private fun refuses(
        words: String,
        take: () -> Unit,
    ) {
        val message = assertThrows(CannotStart::class.java) { take() }.message
        assertTrue(words in message && '\n' !in message, "expected '$words' in one line, got '$message'")
    }
}
