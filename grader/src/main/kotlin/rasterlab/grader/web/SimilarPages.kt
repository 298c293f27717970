package rasterlab.grader.web

import io.ktor.server.application.ApplicationCall
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.util.getOrFail
import kotlinx.html.FlowContent
import kotlinx.html.ThScope
import kotlinx.html.a
import kotlinx.html.code
import kotlinx.html.details
import kotlinx.html.div
import kotlinx.html.h2
import kotlinx.html.li
import kotlinx.html.ol
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
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Identity
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.problem.Rejection
import rasterlab.grader.similarity.HandedProgram
import rasterlab.grader.similarity.Likeness
import rasterlab.grader.similarity.LikenessReport
import rasterlab.grader.similarity.Program
import rasterlab.grader.similarity.Similar
import rasterlab.grader.similarity.SimilarityFinder
import rasterlab.grader.similarity.respondPrograms
import rasterlab.grader.similarity.written
import kotlin.math.roundToInt

/** Programs that are alike, for staff: a list of pairs, and two of them side by side. */
fun Route.similarPages(
    accounts: Accounts,
    exercises: Exercises,
    similar: Similar,
) {
    get("/instructor/exercises/{id}/similarity") {
        val who = call.staffHere(accounts)
        val exercise = exercises.written(call.parameters.getOrFail("id"))
        call.respondPairs(who, exercise, similar.of(exercise))
    }
    get("/instructor/exercises/{id}/programs.zip") {
        call.instructorHere(accounts)
        call.respondPrograms(exercises.written(call.parameters.getOrFail("id")), similar)
    }
    get("/instructor/exercises/{id}/similarity/{first}/{second}") {
        val who = call.staffHere(accounts)
        val exercise = exercises.written(call.parameters.getOrFail("id"))
        val (first, second) =
            listOf("first", "second").map { place ->
                val id = call.parameters.getOrFail(place)
                similar.find(id)?.takeIf { it.exercise == exercise.id() } ?: throw Rejection.UnknownSubmission(id)
            }
        call.respondSideBySide(who, exercise, first, second, similar.sameWrong(first.submission, second.submission))
    }
}

/** Links to the lists of pairs, for each exercise that programs are written for. */
fun FlowContent.similarLinks(
    texts: PageTexts,
    exercises: Exercises,
) = details {
    summary { +texts.say("similar.choose") }
    ul {
        exercises.all.filter { it.form() == Exercise.TaskKind.WRITE }.forEach {
            li { a("/instructor/exercises/${it.id()}/similarity") { +it.title(texts.language) } }
        }
    }
}

private suspend fun ApplicationCall.respondPairs(
    who: Identity.StaffIdentity,
    exercise: Exercise,
    report: LikenessReport,
) {
    val texts = texts()
    respondPage(texts, who, texts.say("similar.title", exercise.title(texts.language))) {
        p { +texts.say("similar.about") }
        p { +texts.say("similar.count", report.programs, report.leftOut.size) }
        if (report.pairs.isEmpty()) p { +texts.say("similar.none") } else pairTable(texts, exercise, report.pairs)
        if (who is Identity.Instructor) {
            p { a("/instructor/exercises/${exercise.id()}/programs.zip") { +texts.say("similar.export") } }
        }
    }
}

private fun FlowContent.pairTable(
    texts: PageTexts,
    exercise: Exercise,
    pairs: List<Likeness>,
) = div("scroll") {
    table {
        thead {
            tr {
                listOf("pair", "courses", "rare", "shared", "longest", "wrong").forEach {
                    th(scope = ThScope.col, classes = "number".takeIf { _ -> it in NUMBERS }) {
                        +texts.say("similar.column.$it")
                    }
                }
            }
        }
        tbody {
            pairs.forEach { one ->
                tr {
                    td { a(address(exercise, one.first, one.second)) { +"${one.first.name} – ${one.second.name}" } }
                    td { +listOf(one.first.course, one.second.course).distinct().joinToString(" – ") }
                    td("number") { +"${one.pair.rare}" }
                    td("number") { +texts.say("similar.percent", percent(one.pair.shared)) }
                    td("number") { +"${one.pair.longest}" }
                    td("number") { +"${one.sameWrong.size}" }
                }
            }
        }
    }
}

private val NUMBERS = setOf("rare", "shared", "longest", "wrong")

private fun percent(share: Double) = (share * 100).roundToInt()

private fun address(
    exercise: Exercise,
    first: HandedProgram,
    second: HandedProgram,
) = "/instructor/exercises/${exercise.id()}/similarity/${first.submission}/${second.submission}"

private suspend fun ApplicationCall.respondSideBySide(
    who: Identity.StaffIdentity,
    exercise: Exercise,
    first: HandedProgram,
    second: HandedProgram,
    sameWrong: List<String>,
) {
    val texts = texts()
    val programs = listOf(first, second).map { Program(it.submission, it.student, it.source) }
    val alike = SimilarityFinder(programs, exercise.starter())
    respondPage(texts, who, "${first.name} – ${second.name}") {
        p { a("/instructor/exercises/${exercise.id()}/similarity") { +texts.say("similar.back") } }
        p { +texts.say("similar.marked") }
        if (sameWrong.isNotEmpty()) p { +texts.say("similar.wrong", sameWrong.size, sameWrong.joinToString()) }
        div("beside") {
            programSource(texts, first, alike.lines(programs[0], programs[1]))
            programSource(texts, second, alike.lines(programs[1], programs[0]))
        }
    }
}

private fun FlowContent.programSource(
    texts: PageTexts,
    one: HandedProgram,
    alike: Set<Int>,
) = section {
    h2 { a("/submissions/${one.submission}") { +one.name } }
    p { +"${one.course}, ${one.receivedAt.forPeople()} UTC" }
    ol("source") {
        one.source.removeSuffix("\n").lineSequence().forEachIndexed { index, line ->
            li("in-both".takeIf { index + 1 in alike }) {
                if (index + 1 in alike) span("unseen") { +"${texts.say("similar.alike")}: " }
                code { +line }
            }
        }
    }
}
