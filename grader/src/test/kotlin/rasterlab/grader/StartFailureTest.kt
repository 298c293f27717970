package rasterlab.grader

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import picocli.CommandLine.Model.CommandSpec
import rasterlab.grader.storage.CannotStart
import java.io.IOException
import java.io.PrintWriter
import java.io.StringWriter
import java.nio.file.Path
import java.util.concurrent.Callable
import kotlin.io.path.createDirectory
import kotlin.io.path.writeText

class StartFailureTest {
    @TempDir
    lateinit var folder: Path

    @Test
    fun `an unforeseen failure prints its stack`() {
        val broken =
            Callable<Int> { throw IllegalStateException("no judge\nat all", IOException("read-only folder\nhere")) }
        val printed = StringWriter()
        val commands =
            commandLine()
                .addSubcommand("break", CommandSpec.wrapWithoutInspection(broken))
                .setErr(PrintWriter(printed, true))
        // Set again: only subcommands that are there already take the handler.
        commands.executionExceptionHandler = commands.executionExceptionHandler
        assertEquals(70, commands.execute("break"))
        val line = printed.toString().trim()
        assertTrue("failed: IOException: read-only folder; " in line, line)
        assertEquals(1, line.lines().size, line)
    }

    @Test
    fun `a file that is no database is refused without the reason`() {
        val file = folder.resolve("notes.db").apply { writeText("not a database ".repeat(100)) }
        assertTrue("not a database" in refusal(file), refusal(file))
    }

    @Test
    fun `a database that cannot be opened is called one of another program`() {
        val place = folder.resolve("folder.db").createDirectory()
        val message = refusal(place)
        assertTrue("not a database" !in message && "$place: cannot be used" in message, message)
    }

    private fun refusal(file: Path): String {
        val refused = assertThrows(CannotStart::class.java) { openDatabase(file) }
        assertEquals(1, refused.message.lines().size, refused.message)
        assertTrue(refused.cause != null, "the cause is dropped")
        return refused.message
    }
}
