// Two versions of a student's work beside each other: points, lines and pictures. Start with ComparePages.
package rasterlab.grader.web.comparison

import io.ktor.server.application.ApplicationCall
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import kotlinx.html.FlowContent
import kotlinx.html.FormMethod
import kotlinx.html.ThScope
import kotlinx.html.a
import kotlinx.html.button
import kotlinx.html.details
import kotlinx.html.div
import kotlinx.html.form
import kotlinx.html.h2
import kotlinx.html.label
import kotlinx.html.option
import kotlinx.html.p
import kotlinx.html.select
import kotlinx.html.span
import kotlinx.html.summary
import kotlinx.html.table
import kotlinx.html.tbody
import kotlinx.html.td
import kotlinx.html.th
import kotlinx.html.thead
import kotlinx.html.tr
import rasterlab.grader.comparison.Version
import rasterlab.grader.comparison.VersionPair
import rasterlab.grader.comparison.VersionPairs
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Identity
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.report.submissionId
import rasterlab.grader.submission.Listed
import rasterlab.grader.web.PageTexts
import rasterlab.grader.web.respondPage
import rasterlab.grader.web.scrolling
import rasterlab.grader.web.someone
import rasterlab.grader.web.status
import rasterlab.grader.web.texts

/** Shows two submissions of one student for an exercise beside each other, to the student and to staff. */
fun Route.comparePages(
    accounts: Accounts,
    exercises: Exercises,
    pairs: VersionPairs,
) {
    get("/submissions/{id}/compare") {
        val who = call.someone(accounts)
        val id = call.submissionId()
        val choices = pairs.choices(who, id)
        val later = call.request.queryParameters["second"] ?: id
        val earlier = call.request.queryParameters["first"] ?: choices.besides(later)
        val pair = earlier?.let { pairs.of(who, it, later, call.texts().language) }
        call.respondVersions(who, id, exercises, choices, pair)
    }
}

/** The attempt before that one, or the one after it where it is the first. */
private fun List<Listed>.besides(id: String): String? {
    val place = indexOfFirst { it.submission.id == id }
    return (getOrNull(place + 1) ?: getOrNull(place - 1))?.submission?.id
}

private suspend fun ApplicationCall.respondVersions(
    who: Identity,
    id: String,
    exercises: Exercises,
    choices: List<Listed>,
    pair: VersionPair?,
) {
    val texts = texts()
    val shown = choices.first()
    val exercise = exercises.find(shown.submission.exercise)?.title(texts.language) ?: shown.submission.exercise
    val student = shown.student.takeIf { who is Identity.StaffIdentity }
    respondPage(texts, who, listOfNotNull(student, exercise, texts.say("compare.title")).joinToString(" — ")) {
        p { a("/submissions/$id") { +texts.say("compare.back") } }
        if (pair == null) {
            p { +texts.say("compare.one") }
        } else {
            choice(texts, id, choices, pair)
            points(texts, pair)
            h2 { +texts.say("compare.lines") }
            val lines = pair.lines
            if (lines == null) p { +texts.say("compare.long") } else lineTable(texts, pair, lines)
            caseColumns(texts, pair)
        }
    }
}

private fun FlowContent.choice(
    texts: PageTexts,
    id: String,
    choices: List<Listed>,
    pair: VersionPair,
) = form("/submissions/$id/compare", method = FormMethod.get, classes = "card lines") {
    listOf("first" to pair.first, "second" to pair.second).forEach { (field, chosen) ->
        label {
            span { +texts.say("compare.$field") }
            select {
                name = field
                choices.forEach { one ->
                    option {
                        value = one.submission.id
                        selected = one.submission.id == chosen.submission.id
                        +"${texts.say("table.attempt.number", one.submission.attempt)} · "
                        +texts.time(one.submission.receivedAt)
                    }
                }
            }
        }
    }
    div("ways") { button { +texts.say("compare.do") } }
}

private fun FlowContent.points(
    texts: PageTexts,
    pair: VersionPair,
) = scrolling(texts.say("table.points")) {
    val both = listOf(pair.first, pair.second)
    table("versions-points") {
        thead {
            tr {
                td {}
                both.forEach {
                    th(
                        scope = ThScope.col,
                    ) { a("/submissions/${it.submission.id}") { +attempt(texts, it) } }
                }
            }
        }
        tbody {
            tr {
                th(scope = ThScope.row) { +texts.say("table.verdict") }
                both.forEach { td { status(texts, it.view.verdict, it.view.state) } }
            }
            val rows =
                listOf<Pair<String, (Version) -> String?>>(
                    "result.accuracy" to {
                        it.view.points
                            ?.accuracy
                            ?.toString()
                    },
                    "result.stability" to {
                        it.view.points
                            ?.stability
                            ?.toString()
                    },
                    "result.speed" to {
                        it.view.points
                            ?.speed
                            ?.toString()
                    },
                    "table.points" to { version -> version.view.points?.let { "${it.total} / ${it.of}" } },
                )
            rows.forEach { (title, told) ->
                tr {
                    th(scope = ThScope.row) { +texts.say(title) }
                    both.forEach { td { +(told(it) ?: "–") } }
                }
            }
            tr {
                th(scope = ThScope.row) { +texts.say("table.received", texts.zoneName) }
                both.forEach { td { +texts.minute(it.submission.receivedAt) } }
            }
        }
    }
}

internal fun attempt(
    texts: PageTexts,
    one: Version,
) = texts.say("table.attempt.number", one.submission.attempt)

private fun FlowContent.caseColumns(
    texts: PageTexts,
    pair: VersionPair,
) {
    if (pair.cases.isEmpty()) return
    val (same, changed) = pair.cases.partition { it.isSame }
    h2 { +texts.say("compare.cases") }
    if (changed.isEmpty()) p { +texts.say("compare.cases.none") }
    changed.forEach { versionsOfCase(texts, pair, it) }
    if (same.isEmpty()) return
    details {
        summary { +texts.say("compare.same", same.size) }
        same.forEach { versionsOfCase(texts, pair, it) }
    }
}
