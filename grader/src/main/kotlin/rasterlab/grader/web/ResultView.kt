package rasterlab.grader.web

import kotlinx.html.ButtonType
import kotlinx.html.DIV
import kotlinx.html.FlowContent
import kotlinx.html.a
import kotlinx.html.article
import kotlinx.html.button
import kotlinx.html.code
import kotlinx.html.details
import kotlinx.html.div
import kotlinx.html.figcaption
import kotlinx.html.figure
import kotlinx.html.h2
import kotlinx.html.h3
import kotlinx.html.img
import kotlinx.html.li
import kotlinx.html.ol
import kotlinx.html.p
import kotlinx.html.pre
import kotlinx.html.section
import kotlinx.html.span
import kotlinx.html.strong
import kotlinx.html.summary
import kotlinx.html.ul
import rasterlab.exercises.published.PublishedCase
import rasterlab.exercises.published.PublishedDiagnostic
import rasterlab.exercises.published.PublishedPicture
import rasterlab.exercises.published.PublishedPoints
import rasterlab.exercises.score.CasePicture
import rasterlab.exercises.score.CaseReport
import rasterlab.exercises.score.Disclosure
import rasterlab.exercises.score.GradingVerdict
import rasterlab.exercises.score.Report
import rasterlab.grader.report.InLab
import rasterlab.grader.report.LabFiles
import rasterlab.grader.report.SubmissionView
import kotlin.jvm.optionals.getOrNull

private const val MINUTE_SECONDS = 60
private const val STEP_SECONDS = 5

/**
 * Everything that is known of a submission by now.
 *
 * @param files that show failed cases in the lab
 * @param sheet that was answered; null where there is none
 * @param below what stands below a case beside its result
 * @param page address of the page that it is on
 * @param api address under which its files are
 */
fun DIV.result(
    texts: PageTexts,
    view: SubmissionView,
    source: String,
    files: LabFiles,
    sheet: SheetResult?,
    below: FlowContent.(PublishedCase) -> Unit = {},
    page: String = "/submissions/${view.id}",
    api: String = "/api/v1/submissions/${view.id}",
) {
    div("verdict card") {
        status(texts, view.verdict, view.state)
        progress(texts, view, page)
        view.points?.let { points(texts, it, view.penalty, files.asksForPrograms) }
        if (!view.current) p("earlier") { +texts.say("result.earlier", view.revision) }
        if (view.verdict == "internal") p { +texts.say("result.internal") }
    }
    if (view.diagnostics.isNotEmpty()) diagnostics(texts, view.diagnostics, source)
    // Until all are judged, a verdict may still change: a mistake that all share is paid for once.
    if (view.verdict != null && view.cases.isNotEmpty()) {
        h2 { +texts.say("result.cases") }
        if (view.cases.flatMap { it.pictures }.any { isOfPixels(it) }) p("legend") { +texts.say("result.legend") }
        alike(view.cases).forEach { group ->
            val show = { case: PublishedCase ->
                case(texts, case, files, api, sheet, below)
            }
            show(group.first())
            if (group.size > 1) others(texts, group.drop(1), show)
        }
    }
    view.speed?.let { speedChart(texts, it) }
    view.isolation?.takeIf { it.isNotEmpty() && files.asksForPrograms }?.let { isolation ->
        p("isolation") {
            +texts.say("result.isolation", Report.isolationIn(texts.language, isolation))
            if (isolation == Report.PROCESS_LIMITS) +" ${texts.say("result.weak")}"
        }
    }
}

/** Cases that are told the same, as one row that opens. */
private fun FlowContent.others(
    texts: PageTexts,
    cases: List<PublishedCase>,
    show: (PublishedCase) -> Unit,
) = details("alike") {
    summary { +texts.say("result.alike", cases.size) }
    cases.forEach(show)
}

private fun FlowContent.progress(
    texts: PageTexts,
    view: SubmissionView,
    page: String,
) {
    if (view.verdict != null) return
    p {
        when (view.state) {
            "queued" -> {
                +(if (view.position > 0) texts.say("result.position", view.position) else texts.say("trial.waits"))
                view.waitSeconds?.let { +" ${texts.say("result.wait", texts.roughly(it))}" }
            }

            else -> {
                +texts.say("result.running", view.cases.size)
            }
        }
        +" "
        a(page) { +texts.say("result.reload") }
    }
}

/** A time to wait, in steps of five seconds up to a minute and in minutes above. */
private fun PageTexts.roughly(seconds: Int): String =
    if (seconds > MINUTE_SECONDS - STEP_SECONDS) {
        say("exam.minutes", (seconds + MINUTE_SECONDS - 1) / MINUTE_SECONDS)
    } else {
        say("exam.seconds", (seconds + STEP_SECONDS - 1) / STEP_SECONDS * STEP_SECONDS)
    }

/**
 * @param percent that lateness costs
 * @param byKind whether they are of several kinds, as those of programs are
 */
private fun FlowContent.points(
    texts: PageTexts,
    points: PublishedPoints,
    percent: Int,
    byKind: Boolean,
) {
    p("total") {
        +texts.say("result.points", points.total, points.of)
        if (points.hints > 0) span("hint-cost") { +texts.say("table.hints", points.hints) }
        if (points.late > 0) span("hint-cost") { +texts.say("result.late.cost", points.late, percent) }
    }
    if (points.manual.isNotEmpty()) {
        ul("manual") {
            points.manual.forEach { one -> li { +texts.say("result.manual", one.signed(), one.reason) } }
        }
    }
    if (!byKind) return
    val kinds = listOf("accuracy" to points.accuracy, "stability" to points.stability, "speed" to points.speed)
    ul("points") {
        kinds.forEach { (kind, earned) ->
            li {
                +"${texts.say("result.$kind")} "
                strong { +"$earned" }
            }
        }
    }
}

private fun FlowContent.diagnostics(
    texts: PageTexts,
    diagnostics: List<PublishedDiagnostic>,
    source: String,
) = section {
    h2 { +texts.say("result.diagnostics") }
    ul("diagnostics") {
        diagnostics.forEach { diagnostic ->
            li {
                if (diagnostic.line > 0) span("place") { +place(texts, diagnostic) }
                span("message") { sentence(diagnostic.message) }
                partOfLine(source, diagnostic.line, diagnostic.column).takeIf { it.isNotBlank() }?.let { line ->
                    pre {
                        scrolledByKeys(place(texts, diagnostic))
                        code { +line.trim() }
                    }
                }
                folded(texts, diagnostic.message)
            }
        }
    }
}

private fun place(
    texts: PageTexts,
    diagnostic: PublishedDiagnostic,
) = if (diagnostic.column > 0) {
    texts.say("result.line.column", diagnostic.line, diagnostic.column)
} else {
    texts.say("result.line", diagnostic.line)
}

private fun FlowContent.case(
    texts: PageTexts,
    case: PublishedCase,
    files: LabFiles,
    address: String,
    sheet: SheetResult?,
    below: FlowContent.(PublishedCase) -> Unit,
) = article("case card") {
    div("row") {
        status(texts, case.verdict.codeFor(case.points, case.of), "")
        h3 { +case.title }
        if (case.visibility != Disclosure.OPEN.code()) span("hidden-case") { +texts.say("result.hidden") }
        span("earned") { +earned(texts, case) }
    }
    case.tolerance.getOrNull()?.let { compared ->
        p("rule") {
            +texts.say("result.compared", compared)
            case.rule.getOrNull()?.let { +" ${texts.say("result.rule", it)}" }
        }
    }
    val step = sheet?.step(case.name)
    if (sheet != null && step != null) {
        stepResult(texts, sheet, step)
    } else if (case.message.isNotEmpty()) {
        message(texts, case.message)
    }
    case.why.getOrNull()?.let { p("why") { +texts.say("result.why", it) } }
    if (case.pictures.isNotEmpty()) pictures(texts, case.title, case.pictures)
    if (case.scene.isNotEmpty() && !case.passed()) inLab(texts, case.name, files, address)
    below(case)
}

/** The way from a failed case to the lab, where both methods draw it side by side. */
private fun FlowContent.inLab(
    texts: PageTexts,
    case: String,
    files: LabFiles,
    address: String,
) = details {
    summary { +texts.say("result.lab") }
    p { +texts.say(if (files.asksForPrograms) "result.lab.both" else "result.lab.one") }
    when (val inLab = files.inLab) {
        InLab.Known -> Unit
        is InLab.Like -> p { +texts.say("result.lab.like", inLab.id) }
        InLab.FromFolder -> p { +texts.say("result.lab.folder") }
    }
    ul {
        li {
            +"${texts.say("result.lab.case")} "
            a("$address/cases/$case/scene.json") { +files.scene(case) }
        }
        if (files.asksForPrograms) {
            li {
                +"${texts.say("result.lab.source")} "
                a("$address/source") { +files.source }
            }
        }
    }
    pre("command") {
        code { +files.command(case) }
    }
    button(classes = "plain copy", type = ButtonType.button) { +texts.say("result.lab.copy") }
}

private fun earned(
    texts: PageTexts,
    case: PublishedCase,
) = if (case.points < 0) {
    CaseReport.pointsOf(case.points, case.of)
} else {
    texts.say("result.case.points", case.points, case.of)
}

/** Tells people who do not see a picture what is on it; where it is a part of a larger one, which. */
internal fun PageTexts.describe(picture: PublishedPicture): String {
    val part = picture.part.getOrNull()?.takeIf { !it.isWhole } ?: return picture.text
    return (listOf(part.message().`in`(language)) + picture.rows()).joinToString("\n")
}

private fun isOfPixels(difference: PublishedPicture) =
    difference.kind == CasePicture.DIFFERENCE && difference.rows().isNotEmpty()

private fun FlowContent.pictures(
    texts: PageTexts,
    case: String,
    pictures: List<PublishedPicture>,
) {
    pictures.firstNotNullOfOrNull { it.part.getOrNull() }?.takeIf { !it.isWhole }?.let { part ->
        p("legend") { +texts.say("result.part", part.message().`in`(texts.language)) }
    }
    val pixels = pictures.any { isOfPixels(it) }
    div(if (pixels) "pictures pixels" else "pictures") {
        pictures.forEach { picture ->
            val name = texts.picture(picture.kind)
            figure {
                a(picture.url) { img(src = picture.url, alt = "$case: $name\n${texts.describe(picture)}") }
                figcaption { +name }
            }
        }
    }
    val turns =
        listOf(CasePicture.EXPECTED, CasePicture.ACTUAL).mapNotNull { kind ->
            pictures.find { it.kind == kind }
        }
    if (turns.size == 2) {
        details {
            summary { +texts.say("result.blink") }
            div(if (pixels) "blink pixels" else "blink") {
                turns.forEach {
                    img(
                        src = it.url,
                        alt = "$case: ${texts.picture(it.kind)}",
                    )
                }
            }
        }
    }
    pictures.find { it.kind == CasePicture.DIFFERENCE }?.let { difference ->
        details {
            summary { +texts.say("result.astext") }
            if (isOfPixels(difference)) {
                pre("picture-text") {
                    scrolledByKeys(texts.say("result.astext"))
                    +difference.rows().joinToString("\n")
                }
            } else {
                p { +difference.text }
            }
        }
    }
}

/** The least number of failures, told the same, that are shown as one row which opens. */
private const val MANY = 3

/** Whether it earned all its points. */
internal fun PublishedCase.passed(): Boolean = verdict.codeFor(points, of) == GradingVerdict.OK.code()

/** The cases in their order, many failures with one verdict and one message as a group at the place of the first. */
internal fun alike(cases: List<PublishedCase>): List<List<PublishedCase>> =
    cases
        .groupBy { listOf(it.verdict.codeFor(it.points, it.of), it.message, it.visibility) }
        .values
        .flatMap { group ->
            val alike = group.size >= MANY && group.none { it.passed() } && group.first().message.isNotEmpty()
            if (alike) listOf(group) else group.map(::listOf)
        }.sortedBy { cases.indexOf(it.first()) }
