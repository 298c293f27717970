package rasterlab.grader.web

import kotlinx.html.FlowContent
import kotlinx.html.FlowOrPhrasingContent
import kotlinx.html.ThScope
import kotlinx.html.a
import kotlinx.html.div
import kotlinx.html.span
import kotlinx.html.table
import kotlinx.html.tbody
import kotlinx.html.td
import kotlinx.html.th
import kotlinx.html.thead
import kotlinx.html.tr
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.submission.Listed
import java.time.Instant

/** A moment that breaks only between day and time; its zone is told beside it. */
internal fun FlowOrPhrasingContent.moment(
    texts: PageTexts,
    at: Instant,
) = texts
    .minute(at)
    .split(' ')
    .forEach {
        span("unbroken") { +it }
        +" "
    }

private val DATE = Regex("\\d{4}-\\d{2}-\\d{2}")

/** A sentence whose dates are not broken at the end of a line. */
internal fun FlowOrPhrasingContent.unbrokenTimes(sentence: String) {
    var told = 0
    for (date in DATE.findAll(sentence)) {
        +sentence.substring(told, date.range.first)
        span("unbroken") { +date.value }
        told = date.range.last + 1
    }
    +sentence.substring(told)
}

/** One student's attempts at one exercise. */
fun FlowContent.attemptTable(
    texts: PageTexts,
    exercises: Exercises,
    rows: List<Listed>,
) = listing(texts, exercises, rows, listOf("attempt" to ::attemptLink), "attempts")

/** Everybody's submissions. */
fun FlowContent.classTable(
    texts: PageTexts,
    exercises: Exercises,
    rows: List<Listed>,
) = listing(
    texts,
    exercises,
    rows,
    listOf(
        "student" to { _, row -> row.student },
        "exercise" to { _, row ->
            exercises.find(row.submission.exercise)?.title(texts.language) ?: row.submission.exercise
        },
        "attempt" to ::attemptLink,
    ),
)

private fun attemptLink(
    texts: PageTexts,
    row: Listed,
) = texts.say("table.attempt.number", row.submission.attempt)

private fun FlowContent.listing(
    texts: PageTexts,
    exercises: Exercises,
    rows: List<Listed>,
    first: List<Pair<String, (PageTexts, Listed) -> String>>,
    named: String? = null,
) = div("scroll") {
    table(named) {
        thead {
            tr {
                (first.map { it.first } + listOf("verdict", "points", "received")).forEach { column ->
                    val classes = "number".takeIf { column == "points" }
                    th(scope = ThScope.col, classes = classes) { +texts.say("table.$column", texts.zoneName) }
                }
            }
        }
        tbody {
            rows.forEach { row ->
                tr {
                    first.forEachIndexed { index, (_, text) ->
                        td {
                            when (index) {
                                0 -> a("/submissions/${row.submission.id}") { +text(texts, row) }
                                else -> +text(texts, row)
                            }
                        }
                    }
                    td {
                        status(texts, row.verdict, row.submission.state.code)
                        if (!exercises.isCurrent(row.submission.exercise, row.revision)) {
                            span("earlier") { +texts.say("table.earlier") }
                        }
                    }
                    td("number") {
                        +(row.points?.let { "$it / ${row.of}" } ?: "–")
                        if (row.points != null && row.submission.hintCost > 0) {
                            span("hint-cost") { +texts.say("table.hints", row.submission.hintCost) }
                        }
                        if (row.points != null && row.submission.penalty > 0) {
                            span("hint-cost") { +texts.say("table.late.cost", row.submission.penalty) }
                        }
                        if (row.points != null && row.given != 0) {
                            span("hint-cost") { +texts.say("table.given", signed(row.given)) }
                        }
                    }
                    td {
                        moment(texts, row.submission.receivedAt)
                        if (row.late) span("late") { +texts.say("table.late") }
                    }
                }
            }
        }
    }
}

/** A verdict, or the state as long as there is none: told by sign, colour and word. */
fun FlowOrPhrasingContent.status(
    texts: PageTexts,
    verdict: String?,
    state: String,
) {
    val kind = verdict ?: state
    span("status $kind") {
        span("sign") {
            attributes["aria-hidden"] = "true"
            +sign(kind)
        }
        +(if (verdict == null) texts.say("state.$state") else texts.verdict(verdict))
    }
}

internal fun sign(kind: String) =
    when (kind) {
        "ok" -> "✓"
        "wrong" -> "✕"
        "queued", "running" -> "…"
        "internal" -> "?"
        "not_run" -> "·"
        else -> "!"
    }
