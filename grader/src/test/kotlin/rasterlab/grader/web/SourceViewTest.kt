package rasterlab.grader.web

import com.sun.management.ThreadMXBean
import kotlinx.html.div
import kotlinx.html.stream.createHTML
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource
import org.junit.jupiter.params.provider.ValueSource
import java.lang.management.ManagementFactory

class SourceViewTest {
    @ParameterizedTest(name = "line {0}, column {1} is not ''{2}''")
    @CsvSource("1, 1, a", "2, 0, b", "3, 1, ''", "4, 1, c", "5, 1, d", "6, 1, ''", "0, 0, ''", "7, 1, ''")
    fun findsALine(
        line: Int,
        column: Int,
        expected: String,
    ) = assertEquals(expected, partOfLine("a\nb\r\n\nc  \rd\n", line, column))

    @Test
    fun showsOfALongLineWhatIsAroundTheColumn() {
        val line = "a".repeat(1_000) + "X" + "b".repeat(1_000)
        assertEquals("a".repeat(300) + "…", partOfLine(line, 1, 0))
        assertEquals("…" + "a".repeat(149) + "X" + "b".repeat(150) + "…", partOfLine(line, 1, 1_001))
        assertEquals("…" + "b".repeat(150), partOfLine(line, 1, 2_001))
    }

    @Test
    fun numbersTheLinesThatPeopleWrite() {
        for (end in listOf("", "\n", "\r\n")) {
            val head = "<ol class=\"source\" tabindex=\"0\" aria-label=\"Dot\">"
            val two = "$head<li><code>a</code></li><li><code>b</code></li></ol>"
            assertEquals(two, shown("a\nb$end").inner())
        }
        val long = shown("a\n".repeat(5_002))
        assertEquals(5_000, Regex("<li>").findAll(long).count())
        assertTrue("aria-label=\"Dot\"><code>a\na\n</code></pre>" in long)
    }

    @ParameterizedTest(name = "a source of {0} fills the memory")
    @ValueSource(strings = ["\n", "<", "a"])
    fun costsLittleMoreThanItsLength(sign: String) {
        val source = sign.repeat(256 * 1024)
        shown("warm")
        val threads = ManagementFactory.getThreadMXBean() as ThreadMXBean
        val before = threads.currentThreadAllocatedBytes
        shown(source)
        partOfLine(source, 200_000, 1)
        val mib = (threads.currentThreadAllocatedBytes - before) shr 20
        assertTrue(mib <= 32, "$mib MiB were allocated")
    }

    private fun shown(source: String) = createHTML(prettyPrint = false).div { sourceLines(source, "Dot") }

    private fun String.inner() = removePrefix("<div>").removeSuffix("</div>")
}
