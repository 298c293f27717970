package rasterlab.grader.storage

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledOnOs
import org.junit.jupiter.api.condition.OS
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.ClassOfStudents
import rasterlab.grader.CommandWords
import rasterlab.grader.commandLine
import rasterlab.grader.submission.Submissions
import java.io.PrintWriter
import java.io.StringWriter
import java.nio.file.Path
import java.nio.file.attribute.PosixFilePermissions
import java.time.InstantSource
import kotlin.io.path.copyTo
import kotlin.io.path.exists
import kotlin.io.path.getPosixFilePermissions
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.readBytes
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText

class BackupsTest {
    @TempDir
    lateinit var folder: Path
    private val data get() = folder.resolve("data")
    private val copy get() = folder.resolve("copy.db")

    @Test
    @DisplayName("a backup of a running server lacks what was handed in last, or a restored one keeps what came later")
    fun aBackupIsTheDatabaseOfThatMoment() {
        val (first, second) =
            serving { database ->
                val students = ClassOfStudents(database, InstantSource.system())
                val ada = students.student("Ada")
                val first = students.handIn(ada)
                run("backup", "$copy", "--data", "$data")
                first to students.handIn(ada)
            }
        run("restore", "$copy", "--data", "$data")
        serving { database ->
            val submissions = Submissions(database)
            assertTrue(submissions.find(first) != null, "the submission before the backup is lost")
            assertEquals(null, submissions.find(second), "the submission after the backup is there")
        }
        Database.open(data.resolve("rasterlab.db.before-restore-1")).use {
            assertTrue(Submissions(it).find(second) != null, "what was there before is not kept aside")
        }
        assertEquals(emptyList<Path>(), data.listDirectoryEntries("*.part*") + folder.listDirectoryEntries("*.part*"))
    }

    @Test
    @DisplayName("an empty database is kept aside where there was none")
    fun aFolderWithoutDatabaseTakesOne() {
        serving { run("backup", "$copy", "--data", "$data") }
        val said = run("restore", "$copy", "--data", "$folder/new")
        assertEquals(1, said.trim().lines().size, said)
        assertEquals(emptyList<Path>(), folder.resolve("new").listDirectoryEntries("*before*"))
    }

    @Test
    @DisplayName("a database is put in the place of one that a server uses")
    fun aRunningServerKeepsItsDatabase() =
        serving {
            run("backup", "$copy", "--data", "$data")
            val said = run("restore", "$copy", "--data", "$data", exit = 2)
            assertTrue("a server is running with this database; stop it" in said, said)
            assertTrue(
                "с этой базой данных работает сервер" in
                    run("restore", "$copy", "--data", "$data", "--lang", "ru", exit = 2),
            )
        }

    @Test
    @DisplayName("a broken or foreign file is restored, and the database that was there is gone")
    fun onlyAWholeBackupIsRestored() {
        serving { run("backup", "$copy", "--data", "$data") }
        val before = data.resolve("rasterlab.db").readBytes()
        val half = folder.resolve("half.db").apply { writeBytes(copy.readBytes().copyOf(9000)) }
        val notes = folder.resolve("notes.db").apply { writeText("no database ".repeat(999)) }
        val empty = folder.resolve("empty.db").apply { writeText("") }
        for ((file, words) in mapOf(half to "whole database", notes to "database, or", empty to "database of a")) {
            val said = run("restore", "$file", "--data", "$data", exit = 2)
            assertTrue("$file: is not a $words" in said, said)
            assertEquals(1, said.trim().lines().size, said)
            assertFalse("Exception" in said, said)
        }
        assertTrue("there is no such file" in run("restore", "$folder/none.db", "--data", "$data", exit = 2))
        assertTrue(before.contentEquals(data.resolve("rasterlab.db").readBytes()), "the database was touched")
    }

    @Test
    @DisplayName("a refused file leaves an empty database and locks in a new folder, or a journal beside itself")
    fun aRefusedRestoreMakesNothing() {
        val notes = folder.resolve("notes.db").apply { writeText("no database ".repeat(999)) }
        for (file in listOf("$notes", "$folder/none.db")) run("restore", file, "--data", "$folder/new", exit = 2)
        assertEquals(listOf(notes), folder.listDirectoryEntries())
    }

    @Test
    @DisplayName("a file is written over, or a database made where there was none")
    fun aBackupNeedsANewFileAndADatabase() {
        assertTrue("there is no database" in run("backup", "$copy", "--data", "$data", exit = 2))
        assertFalse(data.exists(), "a folder was made")
        serving { }
        val taken = folder.resolve("taken").apply { writeText("mine") }
        assertTrue("is there already" in run("backup", "$taken", "--data", "$data", exit = 2))
        assertTrue("there is no folder" in run("backup", "$folder/none/copy", "--data", "$data", exit = 2))
        assertEquals("mine", taken.readBytes().decodeToString())
    }

    @Test
    @DisplayName("others may read the copy, which has hashes of tokens and everybody's sources")
    @DisabledOnOs(OS.WINDOWS)
    fun aCopyIsForItsOwner() {
        serving { run("backup", "$copy", "--data", "$data") }
        assertEquals("rw-------", rights(copy))
        val loose = copy.copyTo(folder.resolve("loose.db"))
        run("restore", "$loose", "--data", "$data")
        assertEquals("rw-------", rights(data.resolve("rasterlab.db")))
    }

    private fun rights(file: Path) = PosixFilePermissions.toString(file.getPosixFilePermissions())

    private fun <T> serving(work: (Database) -> T): T =
        DataFolder.take(data, url = null).use { Database.open(it.databaseFile).use(work) }

    private fun run(
        vararg arguments: String,
        exit: Int = 0,
    ): String {
        val printed = StringWriter()
        val commands =
            commandLine(CommandWords.asked(*arguments))
                .setOut(PrintWriter(printed, true))
                .setErr(PrintWriter(printed, true))
        assertEquals(exit, commands.execute(*arguments), "$printed")
        return "$printed"
    }
}
