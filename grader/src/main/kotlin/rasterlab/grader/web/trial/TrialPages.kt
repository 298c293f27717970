// Copies of submissions that staff change and run. Start with TrialPages.
package rasterlab.grader.web.trial

import io.ktor.http.HttpStatusCode
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.respondRedirect
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import kotlinx.html.DIV
import kotlinx.html.FlowContent
import kotlinx.html.FormEncType
import kotlinx.html.FormMethod
import kotlinx.html.InputType
import kotlinx.html.a
import kotlinx.html.button
import kotlinx.html.div
import kotlinx.html.form
import kotlinx.html.h2
import kotlinx.html.id
import kotlinx.html.input
import kotlinx.html.li
import kotlinx.html.p
import kotlinx.html.section
import kotlinx.html.stream.createHTML
import kotlinx.html.ul
import rasterlab.exercises.Exercise
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Identity
import rasterlab.grader.report.onEachChange
import rasterlab.grader.report.respondEvents
import rasterlab.grader.report.submissionId
import rasterlab.grader.similarity.written
import rasterlab.grader.storage.Secrets
import rasterlab.grader.submission.HandedForm
import rasterlab.grader.submission.Live
import rasterlab.grader.submission.State
import rasterlab.grader.submission.Submission
import rasterlab.grader.submission.receiveFields
import rasterlab.grader.trial.StaffCopy
import rasterlab.grader.trial.TrialDesk
import rasterlab.grader.web.FORM_AGAIN
import rasterlab.grader.web.FormAgain
import rasterlab.grader.web.PageTexts
import rasterlab.grader.web.editor
import rasterlab.grader.web.problem
import rasterlab.grader.web.requireOwnForm
import rasterlab.grader.web.respondFragment
import rasterlab.grader.web.respondPage
import rasterlab.grader.web.result
import rasterlab.grader.web.sourceField
import rasterlab.grader.web.staffHere
import rasterlab.grader.web.status
import rasterlab.grader.web.texts

/** The rows that the field of a program has at least. */
private const val ROWS = 24

/** Lets staff change a copy of a submission and run it, and shows what comes of it. */
fun Route.trialPages(
    accounts: Accounts,
    desk: TrialDesk,
    live: Live,
) {
    get("/instructor/submissions/{id}/trials") {
        val who = call.staffHere(accounts)
        val submission = desk.submissions.seenBy(who, call.submissionId())
        desk.exercises.written(submission.exercise)
        call.respondEditor(who, desk, submission, submission.source, HttpStatusCode.OK) {}
    }
    post("/instructor/submissions/{id}/trials") {
        call.requireOwnForm()
        val who = call.staffHere(accounts)
        val submission = desk.submissions.seenBy(who, call.submissionId())
        val exercise = desk.exercises.written(submission.exercise)
        val form = HandedForm.of(exercise, call.receiveFields())
        call.attributes.put(
            FORM_AGAIN,
            FormAgain { status, code, added ->
                call.respondEditor(who, desk, submission, form.kept, status) {
                    problem(call.texts(), status, code, added(call.texts().language))
                }
            },
        )
        val source = form.source()
        val begun = desk.trials.run(who, submission, exercise, source, form.once(source))
        desk.ring(begun.id)
        call.respondRedirect(address(begun))
    }
    get("/instructor/trials/{trial}") {
        val who = call.staffHere(accounts)
        call.respondTrial(who, desk, call.trial(desk))
    }
    get("/instructor/trials/{trial}/fragment") {
        call.staffHere(accounts)
        val texts = call.texts()
        val trial = call.trial(desk)
        call.respondFragment(createHTML(prettyPrint = false).div { outcome(texts, desk, trial) })
    }
    get("/instructor/trials/{trial}/events") {
        call.staffHere(accounts)
        val id = call.trial(desk).id
        call.respondEvents {
            onEachChange(live, submission = null) {
                val state = desk.trials.find(id).state
                send("{}", event = if (state == State.DONE) "done" else "changed")
                state != State.DONE
            }
        }
    }
}

private fun ApplicationCall.trial(desk: TrialDesk) = desk.trials.find(parameters.getOrFail("trial"))

private fun address(trial: StaffCopy) = "/instructor/trials/${trial.id}"

/** The student, the exercise and the attempt that a copy is of. */
private fun PageTexts.original(
    desk: TrialDesk,
    submission: Submission,
): String {
    val exercise = desk.exercises.find(submission.exercise)?.title(language) ?: submission.exercise
    val student = desk.submissions.listed(submission.id)?.student
    return say("questions.of", student.orEmpty(), exercise, submission.attempt)
}

private suspend fun ApplicationCall.respondEditor(
    who: Identity.StaffIdentity,
    desk: TrialDesk,
    submission: Submission,
    source: String,
    status: HttpStatusCode,
    trouble: FlowContent.() -> Unit,
) {
    val texts = texts()
    respondPage(texts, who, texts.say("trial.title", texts.original(desk, submission)), status) {
        trouble()
        p { a("/submissions/${submission.id}") { +texts.say("trial.back") } }
        changing(texts, desk, submission, source)
        others(texts, desk.trials.of(submission.id).items)
        editor()
    }
}

private suspend fun ApplicationCall.respondTrial(
    who: Identity.StaffIdentity,
    desk: TrialDesk,
    trial: StaffCopy,
) {
    val texts = texts()
    val original = checkNotNull(desk.submissions.find(trial.submission)) { "no original of ${trial.id}" }
    respondPage(texts, who, texts.say("trial.title", texts.original(desk, original))) {
        p("ways") {
            a("/submissions/${trial.submission}") { +texts.say("trial.back") }
            a("#edit") { +texts.say("trial.edit") }
        }
        p("plan") {
            val by = trial.by.ifEmpty { texts.say("staff.role.instructor") }
            +texts.say("trial.by", by, texts.time(trial.begunAt))
        }
        div {
            id = "live"
            attributes["aria-live"] = "polite"
            if (trial.state != State.DONE) {
                attributes["data-events"] = "${address(trial)}/events"
                attributes["data-fragment"] = "${address(trial)}/fragment"
            }
            outcome(texts, desk, trial)
        }
        changing(texts, desk, original, trial.source)
        others(
            texts,
            desk.trials
                .of(trial.submission)
                .items
                .filter { it.id != trial.id },
        )
        editor()
    }
}

private fun DIV.outcome(
    texts: PageTexts,
    desk: TrialDesk,
    trial: StaffCopy,
) {
    val copy = desk.copy(trial)
    val view = desk.view(trial, texts.language)
    result(texts, view, trial.source, desk.results.files(copy), sheet = null, {
    }, address(trial), "/api/v1/trials/${trial.id}")
}

private fun FlowContent.changing(
    texts: PageTexts,
    desk: TrialDesk,
    submission: Submission,
    source: String,
) = section("card apart") {
    id = "edit"
    h2 { +texts.say("trial.edit") }
    p { +texts.say("trial.about") }
    form(
        "/instructor/submissions/${submission.id}/trials",
        encType = FormEncType.multipartFormData,
        method = FormMethod.post,
    ) {
        input(InputType.hidden, name = HandedForm.ONCE) { value = Secrets.newId() }
        val form = desk.exercises.find(submission.exercise)?.form() ?: Exercise.TaskKind.WRITE
        sourceField(texts.say("trial.source"), form.ending(), source, ROWS)
        button { +texts.say("trial.do") }
    }
}

private fun FlowContent.others(
    texts: PageTexts,
    trials: List<StaffCopy>,
) {
    if (trials.isEmpty()) return
    h2 { +texts.say("trial.others") }
    ul {
        trials.forEach { one ->
            li {
                val by = one.by.ifEmpty { texts.say("staff.role.instructor") }
                a(address(one)) { +texts.say("trial.by", by, texts.time(one.begunAt)) }
                +" "
                status(texts, one.verdict, one.state.code)
            }
        }
    }
}
