package rasterlab.grader.lti

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.CommandWords
import rasterlab.grader.commandLine
import rasterlab.grader.storage.Database
import java.io.PrintWriter
import java.io.StringWriter
import java.nio.file.Path
import java.time.Instant

/** Registers platforms on the server's machine. */
class LtiCommandTest {
    @TempDir
    lateinit var folder: Path

    private fun run(vararg arguments: String): Pair<Int, String> {
        val all = arrayOf("lti", *arguments, "--data", "$folder")
        val printed = StringWriter()
        val code =
            commandLine(CommandWords.asked(*all))
                .setOut(PrintWriter(printed, true))
                .setErr(PrintWriter(printed, true))
                .execute(*all)
        return code to printed.toString()
    }

    private fun add(keys: String = "https://m.example/k") =
        run(
            "add",
            "Moodle",
            "--issuer=https://m.example",
            "--client-id=c",
            "--deployment=1",
            "--keys-url=$keys",
            "--token-url=https://m.example/t",
            "--login-url=https://m.example/l",
        )

    @Test
    @DisplayName("a platform is not kept, is kept twice or with an address that others can read, or does not go")
    fun registersAndForgets() {
        Database.open(folder.resolve("rasterlab.db")).close()
        assertEquals(0 to "", run("list"))
        assertEquals(2, add(keys = "http://m.example/k").first)
        val (code, line) = add()
        assertEquals(0, code, line)
        assertTrue(line.trim().endsWith("\thttps://m.example\tc\t1\tMoodle"), line)
        assertEquals(0 to line, run("list"))
        val again = add()
        assertEquals(2, again.first)
        assertTrue("already" in again.second && again.second.lines().size == 2, again.second)
        assertEquals(2, run("remove", "nobody").first)
        assertEquals(0 to line, run("remove", line.substringBefore('\t')))
        assertEquals(0 to "", run("list"))
    }

    @Test
    @DisplayName("a new key is not made or signs nothing, or the one before is gone or stays for good")
    fun changesTheKey() {
        Database.open(folder.resolve("rasterlab.db")).close()
        val (code, first) = run("key")
        assertEquals(0, code, first)
        assertEquals(0 to first, run("key"))
        val (signs, before) = run("key", "--new").second.trim().lines()
        assertNotEquals(first.trim(), signs)
        assertEquals(first.trim(), before.substringBefore('\t'))
        val now = Instant.now()
        val until = Instant.parse(before.substringAfter('\t'))
        assertTrue(until > now && until <= now + ToolKey.KEPT, before)
        assertEquals(
            3,
            run("key", "--new")
                .second
                .trim()
                .lines()
                .size,
        )
    }
}
