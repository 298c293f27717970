package rasterlab.grader.storage

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledOnOs
import org.junit.jupiter.api.condition.OS
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import java.nio.file.attribute.PosixFilePermissions
import kotlin.io.path.createDirectory
import kotlin.io.path.createLinkPointingTo
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.io.path.exists
import kotlin.io.path.getPosixFilePermissions
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.setPosixFilePermissions
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
            assertFalse(folder.resolve("two").exists(), "a refused server leaves its folder")
        }
    }

    @Test
    @DisplayName("a link or another spelling leads a second server to the same database")
    @DisabledOnOs(OS.WINDOWS)
    fun givesOneDatabaseToOneServerWhateverItIsCalled() {
        val real = folder.resolve("real").createDirectory()
        val link = folder.resolve("link").createSymbolicLinkPointingTo(real)
        DataFolder.take(folder.resolve("one"), "sqlite:$real/shared.db").use { one ->
            Database.open(one.databaseFile).close()
            val file = folder.resolve("other.db").createSymbolicLinkPointingTo(real.resolve("shared.db"))
            for (name in listOf(file, link.resolve("shared.db"), folder.resolve("one/../real/./shared.db"))) {
                refuses("another server is using it") { DataFolder.take(folder.resolve("two"), "sqlite:$name") }
            }
        }
        val second = folder.resolve("second.db").createLinkPointingTo(real.resolve("shared.db"))
        refuses("2 names (hard links)") { DataFolder.take(folder.resolve("two"), "sqlite:$second") }
        folder.resolve("early.db").createSymbolicLinkPointingTo(real.resolve("late.db"))
        DataFolder.take(folder.resolve("one"), "sqlite:$folder/early.db").use {
            refuses("another server is using it") { DataFolder.take(folder.resolve("two"), "sqlite:$real/late.db") }
        }
        DataFolder.take(real, url = null).use {
            refuses("another server is using it") { DataFolder.take(link, url = null) }
        }
    }

    @Test
    @DisplayName("others may read the database, its journal or the log in a folder that was there before")
    @DisabledOnOs(OS.WINDOWS)
    fun filesAreForTheirOwnerAlone() {
        val data = folder.resolve("open").createDirectory()
        data.setPosixFilePermissions(PosixFilePermissions.fromString("rwxr-xr-x"))
        val old = data.resolve("rasterlab.db-wal").apply { writeText("") }
        old.setPosixFilePermissions(PosixFilePermissions.fromString("rw-r--r--"))
        DataFolder.take(data, url = null).use { taken ->
            Database.open(taken.databaseFile).use { database ->
                database.write { it.execute("UPDATE secrets SET name = name") }
                val rights =
                    data.listDirectoryEntries().associate {
                        it.name to PosixFilePermissions.toString(it.getPosixFilePermissions())
                    }
                assertTrue("rasterlab.db-wal" in rights && "server.lock" in rights, "$rights")
                assertEquals(setOf("rw-------"), rights.values.toSet(), "$rights")
            }
        }
    }

    @Test
    fun saysWhatIsWrong() {
        val file = folder.resolve("file").apply { writeText("x") }
        refuses("is a file, expected a folder") { DataFolder.take(file, url = null) }
        refuses("is a file, expected a folder") { DataFolder.take(file.resolve("below"), url = null) }
        refuses("expected sqlite:FILE or postgresql:") { DataFolder.take(folder, "mysql://host/db") }
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
