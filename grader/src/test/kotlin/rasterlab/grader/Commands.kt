package rasterlab.grader

import org.junit.jupiter.api.Assertions.assertEquals
import java.io.PrintWriter
import java.io.StringWriter
import java.nio.file.Path

/** Runs `./lab grader` on the database of the [Classroom] in [folder], checks its exit code and returns what it prints. */
fun printedBy(
    folder: Path,
    vararg arguments: String,
    exit: Int = 0,
): String {
    val printed = StringWriter()
    val commands =
        commandLine(CommandWords.asked(*arguments))
            .setOut(PrintWriter(printed, true))
            .setErr(PrintWriter(printed, true))
    val database = "sqlite:${folder.resolve("test.db")}"
    assertEquals(exit, commands.execute(*arguments, "--db", database), "$printed")
    return "$printed"
}
