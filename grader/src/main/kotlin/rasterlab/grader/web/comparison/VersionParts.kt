package rasterlab.grader.web.comparison

import kotlinx.html.FlowContent
import kotlinx.html.TR
import kotlinx.html.ThScope
import kotlinx.html.a
import kotlinx.html.article
import kotlinx.html.code
import kotlinx.html.div
import kotlinx.html.figcaption
import kotlinx.html.figure
import kotlinx.html.h3
import kotlinx.html.img
import kotlinx.html.p
import kotlinx.html.section
import kotlinx.html.span
import kotlinx.html.table
import kotlinx.html.tbody
import kotlinx.html.td
import kotlinx.html.th
import kotlinx.html.thead
import kotlinx.html.tr
import rasterlab.exercises.published.PublishedCase
import rasterlab.grader.comparison.CasePair
import rasterlab.grader.comparison.LineKind
import rasterlab.grader.comparison.LineRow
import rasterlab.grader.comparison.NumberedLine
import rasterlab.grader.comparison.VersionPair
import rasterlab.grader.web.PageTexts
import rasterlab.grader.web.describe
import rasterlab.grader.web.scrolling
import rasterlab.grader.web.status

/** The lines beside each other; a narrow window has those of the earlier version above those of the later one. */
internal fun FlowContent.lineTable(
    texts: PageTexts,
    pair: VersionPair,
    rows: List<LineRow>,
) {
    val counts = LineKind.entries.associateWith { kind -> rows.count { it.kind == kind } }
    val changed = counts.getValue(LineKind.CHANGED)
    p {
        val (removed, added) = counts.getValue(LineKind.REMOVED) to counts.getValue(LineKind.ADDED)
        +texts.say("compare.counts", changed, removed, added)
    }
    scrolling(texts.say("compare.lines")) {
        table("versions") {
            thead {
                tr {
                    listOf(pair.first, pair.second).forEach { version ->
                        th(scope = ThScope.col, classes = "number") { span("unseen") { +texts.say("compare.number") } }
                        th(scope = ThScope.col) { +attempt(texts, version) }
                    }
                }
            }
            tbody {
                rows.forEach { row ->
                    tr(row.kind.code) {
                        val same = row.kind == LineKind.SAME
                        line(row.first, "first", if (same) null else texts.say("compare.before"), "−")
                        line(row.second, "second", if (same) null else texts.say("compare.after"), "+")
                    }
                }
            }
        }
    }
}

/** @param said tells whoever is read to which version a line that differs is of; null where it does not */
private fun TR.line(
    one: NumberedLine?,
    side: String,
    said: String?,
    sign: String,
) {
    td("number $side") { one?.let { +"${it.number}" } }
    td("$side line") {
        if (one == null) return@td
        if (said != null) {
            span("sign") {
                attributes["aria-hidden"] = "true"
                +sign
            }
            span("unseen") { +"$said: " }
        }
        code { +one.text }
    }
}

/** A case in both versions: verdict, points, words, and each picture beside its like. */
internal fun FlowContent.versionsOfCase(
    texts: PageTexts,
    pair: VersionPair,
    case: CasePair,
) = article("case card") {
    h3 { +case.either.title }
    div("beside") {
        listOf(pair.first to case.first, pair.second to case.second).forEach { (version, shown) ->
            section {
                p("by") { +attempt(texts, version) }
                if (shown == null) p { +texts.say("compare.case.none") } else stand(texts, shown)
            }
        }
    }
    val both = listOfNotNull(case.first, case.second)
    val kinds = both.flatMap { one -> one.pictures.map { it.kind } }.distinct()
    kinds.forEach { kind ->
        div("beside two") {
            listOf(pair.first to case.first, pair.second to case.second).forEach { (version, shown) ->
                val picture = shown?.pictures?.find { it.kind == kind }
                figure {
                    val name = "${attempt(texts, version)}: ${texts.picture(kind)}"
                    if (picture != null) {
                        a(picture.url) {
                            img(src = picture.url, alt = "${case.either.title}, $name\n${texts.describe(picture)}") {
                                attributes["loading"] = "lazy"
                            }
                        }
                    }
                    figcaption { +(if (picture == null) texts.say("compare.picture.none", name) else name) }
                }
            }
        }
    }
}

private fun FlowContent.stand(
    texts: PageTexts,
    case: PublishedCase,
) {
    div("row") {
        status(texts, case.verdict.codeFor(case.points, case.of), "")
        span("earned") { +texts.say("result.case.points", case.points, case.of) }
    }
    if (case.message.isNotEmpty()) p("words") { +case.message }
}
