package rasterlab.grader.trial

import io.ktor.http.ContentType
import io.ktor.http.HttpHeaders
import io.ktor.http.HttpStatusCode.Companion.Accepted
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.header
import io.ktor.server.response.respondBytes
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import kotlinx.serialization.Serializable
import rasterlab.grader.course.staff
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.problem.idempotencyKey
import rasterlab.grader.problem.language
import rasterlab.grader.problem.paging
import rasterlab.grader.problem.pictureLanguage
import rasterlab.grader.problem.respondJson
import rasterlab.grader.problem.respondPart
import rasterlab.grader.report.CopiedResults
import rasterlab.grader.report.SubmissionView
import rasterlab.grader.report.respondFile
import rasterlab.grader.similarity.written
import rasterlab.grader.storage.text
import rasterlab.grader.submission.Submission
import rasterlab.grader.submission.Submissions
import rasterlab.grader.submission.receiveSource

@Serializable
private data class TrialAnswer(
    val id: String,
    val submission: String,
    val by: String,
    val begunAt: String,
    val state: String,
    val verdict: String?,
)

@Serializable
private data class WholeTrialAnswer(
    val trial: TrialAnswer,
    val result: SubmissionView,
)

/** Lets staff run changed copies of submissions, inside `authenticate`. */
fun Route.trials(desk: TrialDesk) {
    get("/submissions/{id}/trials") {
        val submission = desk.submissions.seenBy(call.staff(), call.parameters.getOrFail("id"))
        val part = desk.trials.of(submission.id, call.paging())
        call.respondPart(part.map(::answer))
    }
    post("/submissions/{id}/trials") {
        val who = call.staff()
        val submission = desk.submissions.seenBy(who, call.parameters.getOrFail("id"))
        val exercise = desk.exercises.written(submission.exercise)
        val source = call.receiveSource(exercise.form())
        val begun = desk.trials.run(who, submission, exercise, source, call.idempotencyKey())
        desk.ring(begun.id)
        call.response.header(HttpHeaders.Location, "/api/v1/trials/${begun.id}")
        call.respondJson(answer(begun), Accepted)
    }
    get("/trials/{trial}") {
        call.staff()
        val trial = call.trial(desk)
        call.respondJson(WholeTrialAnswer(answer(trial), desk.view(trial, call.language())))
    }
    get("/trials/{trial}/source") {
        call.staff()
        call.respondFile(desk.results.source(desk.copy(call.trial(desk))))
    }
    get("/trials/{trial}/cases/{case}/scene.json") {
        call.staff()
        val trial = call.trial(desk)
        val case = call.parameters.getOrFail("case")
        call.respondFile(desk.results.scene(desk.copy(trial), trial.result, case))
    }
    get("/trials/{trial}/cases/{case}/{picture}") {
        call.staff()
        val (case, picture) = listOf("case", "picture").map { call.parameters.getOrFail(it) }
        val shown = desk.results.picture(call.trial(desk).result, case, picture, call.pictureLanguage())
        call.response.header(HttpHeaders.CacheControl, "private, max-age=3600")
        call.respondBytes(shown, ContentType.Image.PNG)
    }
}

/**
 * The services that copies need.
 *
 * @param ring tells that something is to be graded, by its id
 */
class TrialDesk(
    val trials: StaffCopies,
    val submissions: Submissions,
    val exercises: Exercises,
    val results: CopiedResults,
    val ring: (String) -> Unit,
) {
    /** The copy as if it were a submission: it has the exercise, the attempt and the hidden cases of the original. */
    fun copy(trial: StaffCopy): Submission {
        val original = checkNotNull(submissions.find(trial.submission)) { "no original of ${trial.id}" }
        return original.copy(
            id = trial.id,
            source = trial.source,
            revision = trial.revision,
            state = trial.state,
            receivedAt = trial.begunAt,
            hintCost = 0,
            penalty = 0,
            dueAt = null,
        )
    }

    fun view(
        trial: StaffCopy,
        language: String,
    ): SubmissionView = results.view(copy(trial), trial.result, "/api/v1/trials/${trial.id}", language)
}

private fun ApplicationCall.trial(desk: TrialDesk) = desk.trials.find(parameters.getOrFail("trial"))

private fun answer(one: StaffCopy) =
    TrialAnswer(one.id, one.submission, one.by, one.begunAt.text(), one.state.code, one.verdict)
