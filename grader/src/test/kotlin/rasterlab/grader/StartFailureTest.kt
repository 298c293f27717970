package rasterlab.grader

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledOnOs
import org.junit.jupiter.api.condition.OS
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource
import org.junit.jupiter.params.provider.ValueSource
import picocli.CommandLine.Model.CommandSpec
import rasterlab.grader.storage.CannotStart
import rasterlab.grader.storage.SqliteFile
import java.io.IOException
import java.io.PrintWriter
import java.io.StringWriter
import java.nio.file.Path
import java.util.concurrent.Callable
import kotlin.io.path.createDirectory
import kotlin.io.path.createFile
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

    @ParameterizedTest(name = "{0} stands for the folder that the server is started in")
    @ValueSource(strings = ["--data", "--exercises"])
    fun `an empty name is refused`(option: String) {
        assertEquals(
            "./lab grader serve: Invalid value for option '$option': must not be empty",
            said(option, "", "--workers", "0"),
        )
    }

    @ParameterizedTest(name = "{0} does not say which numbers it takes")
    @CsvSource("--workers, 1, 64", "--heap, 64, 65536", "--waiting, 1, 100000")
    fun `a word for a number is refused without the range`(
        option: String,
        least: Int,
        most: Int,
    ) {
        assertEquals(
            "./lab grader serve: $option nix: expected a whole number from $least to $most",
            said(option, "nix"),
        )
        assertTrue("$option nix: нужно целое число от $least до $most" in russian(option, "nix"))
    }

    @Test
    fun `a word that is none of the known is refused in capital letters`() {
        val printed = StringWriter()
        val commands = commandLine().setErr(PrintWriter(printed, true))
        commands.execute("course", "grades", "--course", "c", "--for", "moodel")
        assertEquals(
            "./lab grader course grades: --for: expected one of people, moodle, canvas, got 'moodel'; " +
                "did you mean 'moodle'?",
            printed.toString().trim(),
        )
    }

    private fun russian(vararg options: String): String {
        val printed = StringWriter()
        val commands = commandLine(CommandWords.asked("--lang", "ru")).setErr(PrintWriter(printed, true))
        assertEquals(2, commands.execute("serve", *options))
        return "$printed"
    }

    @Test
    fun `a name of two lines cuts off what is wrong with it`() {
        val said = said("--data", "$folder/a", "--db", "sqlite:$folder/none\nx/a")
        assertTrue("there is no folder $folder/none x" in said, said)
    }

    @Test
    fun `a folder that cannot be made is answered with a bare exception`() {
        val file = folder.resolve("a").createFile()
        val below = file.resolve("b/c")
        assertEquals("./lab grader serve: --data $below: $file is a file, expected a folder", said("--data", "$below"))
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    fun `a folder that the system refuses is answered with a bare exception`() {
        val said = said("--data", "/proc/x")
        assertTrue("--data /proc/x: no folder can be made in /proc; expected" in said, said)
        val base = said("--data", "$folder/a", "--db", "sqlite:/proc/x")
        assertTrue("/proc: the file x.lock cannot be made or written there; expected" in base, base)
    }

    private fun said(vararg options: String): String {
        val printed = StringWriter()
        val commands = commandLine().setErr(PrintWriter(printed, true))
        assertEquals(2, commands.execute("serve", "--port", "0", *options), "$printed")
        assertEquals(
            1,
            printed
                .toString()
                .trim()
                .lines()
                .size,
            "$printed",
        )
        return printed.toString().trim()
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
        val refused = assertThrows(CannotStart::class.java) { openDatabase(SqliteFile(file), folder) }
        assertEquals(1, refused.message.lines().size, refused.message)
        assertTrue(refused.cause != null, "the cause is dropped")
        return refused.message
    }
}
