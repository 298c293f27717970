/*
 * Two submissions of one student for one exercise, beside each other: their lines, points and cases.
 * Read LineDifference, VersionPairs, ComparisonRoutes, in this order.
 */
package rasterlab.grader.comparison

import com.github.difflib.DiffUtils
import com.github.difflib.algorithm.myers.MyersDiffWithLinearSpace

enum class LineKind {
    SAME,
    CHANGED,
    REMOVED,
    ADDED,
    ;

    /** Lower-case, as in the HTTP API. */
    val code get() = name.lowercase()
}

/** @param number of the line in its text, from 1 */
data class NumberedLine(
    val number: Int,
    val text: String,
)

/**
 * Lines that stand beside each other.
 *
 * @param first of the earlier text; null where the line was added
 * @param second of the later text; null where the line was removed
 */
data class LineRow(
    val first: NumberedLine?,
    val second: NumberedLine?,
) {
    val kind
        get() =
            when {
                first == null -> LineKind.ADDED
                second == null -> LineKind.REMOVED
                first.text == second.text -> LineKind.SAME
                else -> LineKind.CHANGED
            }
}

/**
 * Finds the fewest lines that differ: E. W. Myers, An O(ND) difference algorithm and its variations, Algorithmica 1,
 * 1986, pages 251–266, in linear space.
 */
object LineDifference {
    /** The most lines of a text that are compared: the time grows with the lines times those that differ. */
    const val MOST = 2_000

    /** Sets the lines of two texts beside each other; null where one has more than [MOST]. */
    fun of(
        first: String,
        second: String,
    ): List<LineRow>? {
        val texts = listOf(first, second).map(::lines)
        if (texts.any { it.size > MOST }) return null
        // Each line is compared as a number, however long it is.
        val numbers = HashMap<String, Int>()
        val (from, to) = texts.map { lines -> lines.map { numbers.getOrPut(it) { numbers.size } } }
        val rows = ArrayList<LineRow>()
        var left = 0
        var right = 0

        fun take(
            leftTo: Int,
            rightTo: Int,
        ) {
            while (left < leftTo || right < rightTo) {
                val before = if (left < leftTo) NumberedLine(left + 1, texts[0][left++]) else null
                val after = if (right < rightTo) NumberedLine(right + 1, texts[1][right++]) else null
                rows += LineRow(before, after)
            }
        }
        // A change may come as lines that are added and others that are removed, one behind the other.
        var leftEnd = 0
        var rightEnd = 0
        val deltas = DiffUtils.diff(from, to, MyersDiffWithLinearSpace()).deltas
        for (delta in deltas.sortedWith(compareBy({ it.source.position }, { it.target.position }))) {
            if (delta.source.position > leftEnd) {
                take(leftEnd, rightEnd)
                take(delta.source.position, delta.target.position)
            }
            leftEnd = delta.source.position + delta.source.size()
            rightEnd = delta.target.position + delta.target.size()
        }
        take(leftEnd, rightEnd)
        take(from.size, to.size)
        return rows
    }

    private fun lines(text: String) =
        if (text.isEmpty()) emptyList() else text.removeSuffix("\n").removeSuffix("\r").lines()
}
