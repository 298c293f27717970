package rasterlab.grader.web

import io.ktor.http.ContentType
import io.ktor.http.HttpStatusCode
import io.ktor.http.Parameters
import io.ktor.http.withCharset
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.respondText
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import kotlinx.html.FlowContent
import kotlinx.html.a
import kotlinx.html.article
import kotlinx.html.div
import kotlinx.html.h2
import kotlinx.html.id
import kotlinx.html.p
import kotlinx.html.stream.createHTML
import rasterlab.exercises.Exercise
import rasterlab.exercises.published.PublishedCase
import rasterlab.exercises.score.Disclosure
import rasterlab.grader.adjustment.Adjustments
import rasterlab.grader.classroom.GroupComments
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Identity
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.report.Results
import rasterlab.grader.report.SubmissionView
import rasterlab.grader.report.submissionId
import rasterlab.grader.submission.Submission
import rasterlab.grader.submission.Submissions
import java.time.Instant

/** One submission; the page asks for its inner part again whenever the server says that something is new. */
fun Route.resultPages(
    accounts: Accounts,
    exercises: Exercises,
    submissions: Submissions,
    results: Results,
    page: ResultPage,
) {
    get("/submissions/{id}") { page.show(call, call.someone(accounts)) }
    get("/submissions/{id}/fragment") {
        val who = call.someone(accounts)
        val submission = submissions.seenBy(who, call.submissionId())
        val texts = call.texts()
        call.respondFragment(
            createHTML(prettyPrint = false).div {
                val view = results.view(who, submission.id, texts.language)
                val sheet = SheetResult.of(exercises.at(submission.exercise, view.revision), submission.source)
                val below = page.cases.below(texts, who, submission, typed = null)
                page.toGroup(this, texts, submission)
                result(texts, view, submission.source, results.files(submission), sheet, below)
            },
        )
    }
}

/** Whether some of its cases are hidden, those that the deadline opens or others. */
internal fun Exercise.hidesCases(): Boolean = cases().any { it.visibility() != Disclosure.OPEN }

/** The effect of the deadline on this submission, where there is one. */
private fun FlowContent.deadline(
    texts: PageTexts,
    view: SubmissionView,
    hidesCases: Boolean,
) {
    val due = view.deadline?.let { texts.time(Instant.parse(it)) } ?: return
    if (view.late) {
        p("late") {
            val words = if (view.penalty > 0) "result.late.charged" else "result.late"
            +texts.say(words, due, view.penalty)
        }
    }
    val said =
        when {
            view.opened -> if (hidesCases) "result.opened" else "result.over"
            !hidesCases -> "result.due"
            view.opensLater -> "result.due.later"
            else -> "result.due.hidden"
        }
    p("plan") { +texts.say(said, due) }
}

/** The inner part of a page. */
suspend fun ApplicationCall.respondFragment(html: String) =
    respondText(html, ContentType.Text.Html.withCharset(Charsets.UTF_8))

/** Shows what was handed in, on the page of its submission, with what there is to say about it. */
fun interface HandedView {
    /**
     * @param title of that part of the page
     * @param typed what a form of the page held that was refused, or null
     */
    fun show(
        place: FlowContent,
        texts: PageTexts,
        who: Identity,
        submission: Submission,
        title: String,
        typed: Parameters?,
    )
}

/** Tells what stands below the cases of a submission beside their results. */
fun interface CaseView {
    /** @param typed what a form of the page held that was refused, or null */
    fun below(
        texts: PageTexts,
        who: Identity,
        submission: Submission,
        typed: Parameters?,
    ): FlowContent.(PublishedCase) -> Unit
}

/** The page of one submission; to an instructor it has the forms for points beside. */
class ResultPage(
    private val exercises: Exercises,
    private val submissions: Submissions,
    private val results: Results,
    private val adjustments: Adjustments,
    private val groups: GroupComments,
    private val handed: HandedView,
    internal val cases: CaseView,
    private val free: (Identity) -> Boolean,
) {
    suspend fun show(
        call: ApplicationCall,
        who: Identity,
    ) = show(call, who, typed = null, refused = null)

    /** Has what was typed shown again where what [call] goes on to do with it is refused. */
    fun showAgain(
        call: ApplicationCall,
        who: Identity,
        typed: Parameters,
    ) = call.attributes.put(
        FORM_AGAIN,
        FormAgain {
            status,
            code,
            added,
            ->
            show(call, who, typed, Refused(status, code, added(call.texts().language)))
        },
    )

    private suspend fun show(
        call: ApplicationCall,
        who: Identity,
        typed: Parameters?,
        refused: Refused?,
    ) {
        val texts = call.texts()
        val submission = submissions.seenBy(who, call.submissionId())
        val view = results.view(who, submission.id, texts.language)
        val files = results.files(submission)
        val exercise = exercises.at(submission.exercise, view.revision)
        val sheet = SheetResult.of(exercise, submission.source)
        val heading = "${title(texts, who, submission)}\u00a0— ${texts.say("result.title", submission.attempt)}"
        call.respondPage(texts, who, heading, refused?.status ?: HttpStatusCode.OK) {
            refused?.let { problem(texts, it.status, it.code, it.details) }
            p("plan") { +texts.say("result.received", texts.time(submission.receivedAt)) }
            deadline(texts, view, exercise?.hidesCases() ?: true)
            div {
                id = "live"
                attributes["aria-live"] = "polite"
                if (view.verdict == null) {
                    attributes["data-events"] = "/api/v1/submissions/${submission.id}/events"
                    attributes["data-fragment"] = "/submissions/${submission.id}/fragment"
                }
                toGroup(this, texts, submission)
                result(texts, view, submission.source, files, sheet, cases.below(texts, who, submission, typed))
            }
            ways(texts, who, submission, files.asksForPrograms)
            val title = texts.say(if (files.asksForPrograms) "result.source" else "result.handed")
            handed.show(this, texts, who, submission, title, typed)
            if (who is Identity.StaffIdentity && view.verdict != null) {
                marking(texts, submission, adjustments.of(submission.id), who is Identity.Instructor, typed)
            }
        }
    }

    /** Shows what staff say to all who gave the wrong answers of a submission. */
    internal fun toGroup(
        place: FlowContent,
        texts: PageTexts,
        submission: Submission,
    ) {
        val told = exercises.find(submission.exercise)?.let { groups.to(submission, it) } ?: return
        place.article("card apart thread") {
            h2 { +texts.say("group.heading") }
            div("said") {
                p("by") { +texts.say("comment.at", texts.time(told.writtenAt)) }
                p("words") { +told.text }
            }
        }
    }

    /** Where to go from here; during an exam nowhere. */
    private fun FlowContent.ways(
        texts: PageTexts,
        who: Identity,
        submission: Submission,
        isProgram: Boolean,
    ) {
        if (!free(who)) return
        val several = submissions.ofStudent(submission.student, submission.exercise).size > 1
        if (!several && who !is Identity.StaffIdentity) return
        div("ways") {
            if (several) a("/submissions/${submission.id}/compare") { +texts.say("compare.open") }
            if (who is Identity.StaffIdentity) {
                if (isProgram) a("/instructor/submissions/${submission.id}/trials") { +texts.say("trial.open") }
                viewButton(texts, submission.student, submission.id)
            }
        }
    }

    /** The exercise, and to an instructor the student. */
    private fun title(
        texts: PageTexts,
        who: Identity,
        submission: Submission,
    ): String {
        val title = exercises.find(submission.exercise)?.title(texts.language) ?: submission.exercise
        val student = submissions.listed(submission.id)?.student.takeIf { who is Identity.StaffIdentity }
        return listOfNotNull(student, title).joinToString(" — ")
    }
}
