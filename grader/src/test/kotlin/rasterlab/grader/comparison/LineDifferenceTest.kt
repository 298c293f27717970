package rasterlab.grader.comparison

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource

/** Lines of two texts stand beside each other; `/` ends a line here. */
class LineDifferenceTest {
    @ParameterizedTest(name = "{0}")
    @CsvSource(
        quoteCharacter = '`',
        value = [
            "equal texts differ, a/b, a/b, 1a=1a 2b=2b",
            "a changed line is removed and added, a/b/c, a/x/c, 1a=1a 2b~2x 3c=3c",
            "an added line changes those after it, a/b, a/x/b, 1a=1a +2x 2b=3b",
            "a removed first line is lost, a/b, b, -1a 2b=1b",
            "the rest of a change is lost, a/b/c/d, a/x/d, 1a=1a 2b~2x -3c 4d=3d",
            "the last lines are lost, a, a/b/c, 1a=1a +2b +3c",
            "the end of the last line is a line, a/, a, 1a=1a",
            "an empty text has a line, ``, a, +1a",
            "a line that moved is the same, a/b/c, c/a/b, +1c 1a=2a 2b=3b -3c",
        ],
    )
    fun setsLinesBesideEachOther(
        @Suppress("UNUSED_PARAMETER") mistake: String,
        first: String,
        second: String,
        expected: String,
    ) = assertEquals(expected, told(first.replace('/', '\n'), second.replace('/', '\n')))

    private fun told(
        first: String,
        second: String,
    ): String =
        LineDifference.of(first, second).orEmpty().joinToString(" ") { row ->
            val (from, to) = listOf(row.first, row.second).map { it?.run { "$number$text" }.orEmpty() }
            when (row.kind) {
                LineKind.SAME -> "$from=$to"
                LineKind.CHANGED -> "$from~$to"
                LineKind.REMOVED -> "-$from"
                LineKind.ADDED -> "+$to"
            }
        }

    @Test
    @DisplayName("Windows' ends of lines make every line another one, or a long text keeps the others waiting")
    fun longTextsAreNotCompared() {
        assertEquals("1a=1a 2b=2b", told("a\r\nb\r\n", "a\nb\n"))
        val longest = (1..LineDifference.MOST).joinToString("\n")
        val other = (1..LineDifference.MOST).joinToString("\n") { "-$it" }
        assertEquals(LineDifference.MOST, LineDifference.of(longest, other)?.size)
        assertEquals(null, LineDifference.of(longest, "$longest\n0"))
    }
}
