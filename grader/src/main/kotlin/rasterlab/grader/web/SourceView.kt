package rasterlab.grader.web

import kotlinx.html.FlowContent
import kotlinx.html.LI
import kotlinx.html.code
import kotlinx.html.li
import kotlinx.html.ol
import kotlinx.html.pre
import rasterlab.grader.comment.CommentedLines

/** More lines than people write; those behind them are shown without numbers, which cost ten times as much. */
internal const val NUMBERED_MOST = 5_000
private const val SHOWN_BEFORE = 150
private const val SHOWN_MOST = 300

/**
 * A source with its lines numbered.
 *
 * @param title what readers that speak call it
 * @param marked whether something is said about that line
 * @param behind what stands below that line
 */
fun FlowContent.sourceLines(
    source: String,
    title: String,
    marked: (Int) -> Boolean = { false },
    behind: LI.(Int) -> Unit = {},
) {
    val rest = lineStart(source, NUMBERED_MOST + 1)?.takeIf { it < source.length }
    val numbered = source.substring(0, rest ?: source.length).removeSuffix("\n").removeSuffix("\r")
    ol("source") {
        // Keys scroll it; it stays a list to readers that speak.
        attributes["tabindex"] = "0"
        attributes["aria-label"] = title
        numbered.lineSequence().forEachIndexed { index, line ->
            li("noted".takeIf { marked(index + 1) }) {
                code { +line }
                behind(index + 1)
            }
        }
    }
    if (rest != null) {
        pre("source") {
            scrolledByKeys(title)
            code { +source.substring(rest) }
        }
    }
}

/**
 * The source beside a message about that place: the line, or of a long one some of it around the column, with "…" where something is left out. Empty where there is no such line.
 */
internal fun partOfLine(
    source: String,
    line: Int,
    column: Int,
): String {
    val start = lineStart(source, line) ?: return ""
    val end = source.indexOfAny(charArrayOf('\r', '\n'), start).let { if (it < 0) source.length else it }
    val from = if (end - start <= SHOWN_MOST) start else (start + column - SHOWN_BEFORE).coerceIn(start, end)
    val until = minOf(end, from + SHOWN_MOST)
    val before = if (from > start) "…" else ""
    return before + if (until < end) source.substring(from, until) + "…" else source.substring(from, until).trimEnd()
}

/** Where that line begins, counted from 1 as the compiler does; null where there are fewer. */
private fun lineStart(
    source: String,
    line: Int,
): Int? {
    if (line < 1) return null
    var at = 0
    var number = 1
    while (number < line) {
        while (at < source.length && source[at] !in "\r\n") at++
        if (at == source.length) return null
        at += if (source.startsWith("\r\n", at)) 2 else 1
        number++
    }
    return at
}

/** The lines that something is about, in words. */
internal fun PageTexts.place(lines: CommentedLines?): String =
    when {
        lines == null -> say("comment.whole")
        lines.first == lines.last -> say("result.line", "${lines.first}")
        else -> say("comment.lines", "${lines.first}", "${lines.last}")
    }
