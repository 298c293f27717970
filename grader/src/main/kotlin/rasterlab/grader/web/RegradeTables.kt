package rasterlab.grader.web

import io.ktor.http.Parameters
import kotlinx.html.DIV
import kotlinx.html.FORM
import kotlinx.html.FlowContent
import kotlinx.html.FormMethod
import kotlinx.html.InputType
import kotlinx.html.ThScope
import kotlinx.html.a
import kotlinx.html.button
import kotlinx.html.details
import kotlinx.html.div
import kotlinx.html.form
import kotlinx.html.h2
import kotlinx.html.input
import kotlinx.html.label
import kotlinx.html.li
import kotlinx.html.p
import kotlinx.html.section
import kotlinx.html.span
import kotlinx.html.summary
import kotlinx.html.table
import kotlinx.html.tbody
import kotlinx.html.td
import kotlinx.html.th
import kotlinx.html.thead
import kotlinx.html.tr
import kotlinx.html.ul
import rasterlab.exercises.Exercise
import rasterlab.grader.regrade.CaseChange
import rasterlab.grader.regrade.Gradable
import rasterlab.grader.regrade.Regrade
import rasterlab.grader.regrade.RegradeChange
import rasterlab.grader.regrade.RegradeChoice
import rasterlab.grader.regrade.RegradePoints
import rasterlab.grader.regrade.RegradeState
import rasterlab.grader.regrade.Regrades

/** Asks which submissions to grade again, with what was chosen before where that was refused. */
internal fun FlowContent.regradeForm(
    texts: PageTexts,
    address: String,
    graded: List<Gradable>,
    typed: Parameters?,
) = section("card") {
    p { +texts.say("regrade.about") }
    form(address, method = FormMethod.post) {
        val chosen = typed?.get("of") ?: RegradeChoice.ALL.code
        RegradeChoice.entries.forEach { one ->
            label("consent") {
                input(InputType.radio, name = "of") {
                    value = one.code
                    checked = one.code == chosen
                }
                span { +texts.say("regrade.of.${one.code}") }
            }
        }
        submissionChoice(texts, graded, typed?.getAll("submission").orEmpty())
        label("consent") {
            input(InputType.checkBox, name = "dry") {
                value = "yes"
                checked = typed == null || typed["dry"] == "yes"
            }
            span { +texts.say("regrade.dry") }
        }
        button { +texts.say("regrade.do") }
    }
}

private fun FORM.submissionChoice(
    texts: PageTexts,
    graded: List<Gradable>,
    chosen: List<String>,
) = details {
    if (chosen.isNotEmpty()) attributes["open"] = "open"
    summary { +texts.say("regrade.some", graded.size) }
    graded.sortedWith(compareBy({ it.name }, { it.attempt })).forEach { one ->
        label("consent") {
            input(InputType.checkBox, name = "submission") {
                value = one.submission
                checked = one.submission in chosen
            }
            span { +texts.say("regrade.one", one.name, one.attempt, one.points, one.of) }
        }
    }
}

/** Earlier regrades, each with its state. */
internal fun FlowContent.regradeTable(
    texts: PageTexts,
    regrades: List<Regrade>,
    exercise: Exercise?,
) {
    h2 { +texts.say("regrade.earlier") }
    scrolling(texts.say("regrade.earlier")) {
        table {
            heading(texts, "begun", "of", "state", "graded")
            tbody {
                regrades.forEach { one ->
                    tr {
                        td { a(regradeAddress(one)) { +texts.time(one.begunAt) } }
                        td {
                            +texts.chosen(one, exercise)
                        }
                        td { +texts.say("regrade.state.${one.state.code}") }
                        td("number") { +texts.say("regrade.progress", one.done, one.total) }
                    }
                }
            }
        }
    }
}

private fun kotlinx.html.TABLE.heading(
    texts: PageTexts,
    vararg columns: String,
) = thead {
    tr {
        columns.forEach {
            th(scope = ThScope.col, classes = "number".takeIf { _ -> it in NUMBERS }) {
                +texts.say("regrade.column.$it")
            }
        }
    }
}

private val NUMBERS = setOf("graded", "before", "after")

/** Says which submissions were chosen, or which case alone. */
private fun PageTexts.chosen(
    regrade: Regrade,
    exercise: Exercise?,
): String {
    val case = regrade.case ?: return say("regrade.of.${regrade.choice.code}")
    return say("regrade.only", exercise?.caseTitle(case, language) ?: case)
}

/** How far a regrade has come, what it changes, and what may be decided. */
internal fun DIV.regrade(
    texts: PageTexts,
    regrade: Regrade,
    regrades: Regrades,
    exercise: Exercise?,
) {
    section("card") {
        p("total") { +texts.say("regrade.state.${regrade.state.code}") }
        p {
            +texts.say(
                "regrade.stand",
                texts.chosen(regrade, exercise),
                regrade.revision,
                regrade.done,
                regrade.total,
            )
        }
        if (regrade.failed > 0) p { +texts.say("regrade.failed", regrade.failed) }
        p { +texts.say(if (regrade.dry) "regrade.next.${regrade.state.code}" else "regrade.wet.${regrade.state.code}") }
        div("ways") {
            decisions(regrade).forEach { decision ->
                form("${regradeAddress(regrade)}/$decision", method = FormMethod.post) {
                    button { +texts.say("regrade.$decision") }
                }
            }
        }
    }
    if (regrade.state == RegradeState.GRADING) {
        p { a(regradeAddress(regrade)) { +texts.say("result.reload") } }
    } else {
        changes(texts, regrades.changes(regrade), exercise)
    }
}

private fun decisions(regrade: Regrade): List<String> =
    when (regrade.state) {
        RegradeState.GRADING -> listOf("discard")
        RegradeState.GRADED -> listOf("accept", "discard")
        RegradeState.ACCEPTED -> listOf("undo")
        RegradeState.DISCARDED, RegradeState.UNDONE -> emptyList()
    }

private fun FlowContent.changes(
    texts: PageTexts,
    all: List<RegradeChange>,
    exercise: Exercise?,
) {
    val graded = all.filter { it.after != null }
    h2 { +texts.say("regrade.changes") }
    p {
        +texts.say(
            "regrade.counts",
            graded.count { it.gain > 0 },
            graded.count { it.gain < 0 },
            graded.count {
                it.gain ==
                    0
            },
        )
    }
    val shown = graded.filter { it.gain != 0 || it.cases.isNotEmpty() }
    if (shown.isEmpty()) return
    scrolling(texts.say("regrade.changes")) {
        table("regraded") {
            heading(texts, "student", "before", "after", "cases")
            tbody { shown.forEach { one -> tr { changed(texts, one, exercise) } } }
        }
    }
}

private fun kotlinx.html.TR.changed(
    texts: PageTexts,
    one: RegradeChange,
    exercise: Exercise?,
) {
    td {
        a("/submissions/${one.submission}") { +one.name }
        span("earlier") { +texts.say("table.attempt.number", one.attempt) }
    }
    td("number") { points(texts, one.before) }
    td("number") {
        one.after?.let { points(texts, it) }
        if (one.gain != 0) span(if (one.gain > 0) "gains" else "loses") { +signed(one.gain) }
    }
    td {
        ul { one.cases.forEach { case -> li { +told(texts, case, exercise) } } }
    }
}

private fun FlowContent.points(
    texts: PageTexts,
    points: RegradePoints,
) {
    span("unbroken") { +"${points.points} / ${points.of}" }
    span("earlier") { +texts.verdict(points.verdict) }
}

/** The difference with its sign, a minus as people write it. */
internal fun signed(points: Int) = if (points > 0) "+$points" else "−${-points}"

private fun told(
    texts: PageTexts,
    case: CaseChange,
    exercise: Exercise?,
): String {
    val title = exercise?.caseTitle(case.name, texts.language) ?: case.name
    val (before, after) =
        listOf(case.before, case.after).map {
            if (it ==
                null
            ) {
                texts.say("regrade.case.none")
            } else {
                texts.say("regrade.case", texts.verdict(it.first), it.second)
            }
        }
    return texts.say("regrade.case.change", title, before, after)
}
