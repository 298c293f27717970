// Pages on which staff see programs that are alike. Start with SimilarPages; what they show comes from the package similarity.
package rasterlab.grader.web.similarity

import io.ktor.server.application.ApplicationCall
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.util.getOrFail
import kotlinx.html.FlowContent
import kotlinx.html.a
import kotlinx.html.code
import kotlinx.html.div
import kotlinx.html.h2
import kotlinx.html.li
import kotlinx.html.ol
import kotlinx.html.p
import kotlinx.html.section
import kotlinx.html.span
import rasterlab.exercises.Exercise
import rasterlab.exercises.score.CaseReport
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Course
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Identity
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.problem.Rejection
import rasterlab.grader.similarity.HandedProgram
import rasterlab.grader.similarity.Likeness
import rasterlab.grader.similarity.Program
import rasterlab.grader.similarity.Similar
import rasterlab.grader.similarity.SimilarityFinder
import rasterlab.grader.similarity.respondPrograms
import rasterlab.grader.similarity.written
import rasterlab.grader.web.PageTexts
import rasterlab.grader.web.classroom.waysOfClass
import rasterlab.grader.web.courseOf
import rasterlab.grader.web.instructorHere
import rasterlab.grader.web.respondPage
import rasterlab.grader.web.stacked
import rasterlab.grader.web.staffHere
import rasterlab.grader.web.texts
import kotlin.math.roundToInt

/** Programs that are alike, of one course or of all, for staff: a list of pairs, and two of them side by side. */
fun Route.similarPages(
    accounts: Accounts,
    courses: Courses,
    exercises: Exercises,
    similar: Similar,
) {
    fun ApplicationCall.desk(course: Course?) =
        SimilarDesk(course, exercises.written(parameters.getOrFail("id")), similar)
    get("/instructor/exercises/{id}/similarity") {
        val who = call.staffHere(accounts)
        call.desk(course = null).showPairs(call, who)
    }
    get("/instructor/exercises/{id}/similarity/{first}/{second}") {
        val who = call.staffHere(accounts)
        call.desk(course = null).showBeside(call, who)
    }
    get("/instructor/courses/{course}/exercises/{id}/similarity") {
        val who = call.staffHere(accounts)
        call.desk(call.courseOf(courses)).showPairs(call, who)
    }
    get("/instructor/courses/{course}/exercises/{id}/similarity/{first}/{second}") {
        val who = call.staffHere(accounts)
        call.desk(call.courseOf(courses)).showBeside(call, who)
    }
    get("/instructor/exercises/{id}/programs.zip") {
        call.instructorHere(accounts)
        call.respondPrograms(exercises.written(call.parameters.getOrFail("id")), similar)
    }
}

private val NUMBERS = listOf("rare", "shared", "longest", "wrong")

/** @param course whose programs are compared; null for those of all */
private class SimilarDesk(
    private val course: Course?,
    private val exercise: Exercise,
    private val similar: Similar,
) {
    private val address =
        (course?.let { "/instructor/courses/${it.id}" } ?: "/instructor") +
            "/exercises/${exercise.id()}/similarity"

    suspend fun showPairs(
        call: ApplicationCall,
        who: Identity.StaffIdentity,
    ) {
        val texts = call.texts()
        val report = similar.of(exercise, course?.id)
        val title = texts.say("similar.title", exercise.title(texts.language))
        call.respondPage(texts, who, if (course == null) title else "$title — ${course.name}") {
            course?.let { waysOfClass(texts, it, exercise, "similarity") }
            p { +texts.say("similar.about") }
            val counted = if (course == null) "similar.count" else "similar.count.course"
            p { +texts.say(counted, report.programs, report.leftOut.size) }
            if (report.pairs.isEmpty()) p { +texts.say("similar.none") } else pairTable(texts, report.pairs)
            if (who is Identity.Instructor && course == null) {
                p { a("/instructor/exercises/${exercise.id()}/programs.zip") { +texts.say("similar.export") } }
            }
        }
    }

    private fun FlowContent.pairTable(
        texts: PageTexts,
        pairs: List<Likeness>,
    ) {
        val columns: List<Pair<String, FlowContent.(Likeness) -> Unit>> =
            listOf(
                "pair" to { one ->
                    a("$address/${one.first.submission}/${one.second.submission}") {
                        +"${one.first.name} – ${one.second.name}"
                    }
                },
                "courses" to { one -> +listOf(one.first.course, one.second.course).distinct().joinToString(" – ") },
                "rare" to { +"${it.pair.rare}" },
                "shared" to { +texts.say("similar.percent", (it.pair.shared * 100).roundToInt()) },
                "longest" to { +"${it.pair.longest}" },
                "wrong" to { one -> +"${one.sameWrong.count { !CaseReport.isWithheld(it) }}" },
            )
        val shown = columns.filter { (name) -> course == null || name != "courses" }
        stacked(
            texts.say("similar.title", exercise.title(texts.language)),
            shown.map { (name, content) -> texts.say("similar.column.$name") to content },
            pairs,
            NUMBERS.mapTo(mutableSetOf()) { texts.say("similar.column.$it") },
        )
    }

    suspend fun showBeside(
        call: ApplicationCall,
        who: Identity.StaffIdentity,
    ) {
        val texts = call.texts()
        val (first, second) = listOf("first", "second").map { program(call.parameters.getOrFail(it)) }
        val programs = listOf(first, second).map { Program(it.submission, it.student, it.source) }
        val alike = SimilarityFinder(programs, exercise.starter())
        call.respondPage(texts, who, "${first.name} – ${second.name}") {
            p { a(address) { +texts.say("similar.back") } }
            p { +texts.say("similar.marked") }
            sameWrong(texts, similar.sameWrong(first.submission, second.submission))
            div("beside") {
                programSource(texts, first, alike.lines(programs[0], programs[1]))
                programSource(texts, second, alike.lines(programs[1], programs[0]))
            }
        }
    }

    private fun program(submission: String): HandedProgram =
        similar.find(submission, course?.id)?.takeIf { it.exercise == exercise.id() }
            ?: throw Rejection.UnknownSubmission(submission)

    private fun FlowContent.sameWrong(
        texts: PageTexts,
        names: List<String>,
    ) {
        val (withheld, cases) = names.partition(CaseReport::isWithheld)
        val titles = cases.map { exercise.caseTitle(it, texts.language) }
        if (titles.isNotEmpty()) p { +texts.say("similar.wrong", titles.size, titles.joinToString("; ")) }
        if (withheld.isNotEmpty()) p { +texts.say("similar.withheld") }
    }
}

private fun FlowContent.programSource(
    texts: PageTexts,
    one: HandedProgram,
    alike: Set<Int>,
) = section {
    h2 { a("/submissions/${one.submission}") { +one.name } }
    p { +"${one.course}, ${texts.time(one.receivedAt)}" }
    ol("source") {
        one.source.removeSuffix("\n").lineSequence().forEachIndexed { index, line ->
            li("in-both".takeIf { index + 1 in alike }) {
                if (index + 1 in alike) span("unseen") { +"${texts.say("similar.alike")}: " }
                code { +line }
            }
        }
    }
}
