package rasterlab.grader.report

import io.ktor.http.ContentType
import io.ktor.http.HttpHeaders
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.header
import io.ktor.server.response.respondBytes
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.util.getOrFail
import rasterlab.exercises.score.CasePicture
import rasterlab.grader.course.Identity
import rasterlab.grader.course.identity
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.exercise.language
import rasterlab.grader.problem.Rejection
import rasterlab.grader.problem.respondJson
import rasterlab.grader.submission.Live
import rasterlab.grader.submission.Reports
import rasterlab.grader.submission.Submissions
import kotlin.jvm.optionals.getOrNull

/** Ends the name of a picture. */
private const val PNG = ".png"

/** What there is to know about one submission. */
class Results(
    private val submissions: Submissions,
    private val reports: Reports,
    private val live: Live,
    private val exercises: Exercises,
) {
    /** @param language of the messages and of the cases' titles, "en" or "ru" */
    fun view(
        who: Identity,
        id: String,
        language: String = "en",
    ): SubmissionView {
        val submission = submissions.seenBy(who, id)
        val recorded = reports.of(id)
        val revision = recorded?.revision ?: submission.revision
        val exercise = exercises.at(submission.exercise, revision)
        val against = GradedAgainst(revision, exercises.isCurrent(submission.exercise, revision))
        return submission.view(who, submissions.position(id), live.casesOf(id), recorded, against, language) { name ->
            exercise?.caseTitle(name, language) ?: name
        }
    }

    /** @param picture its kind with [PNG] behind it, such as "difference.png" */
    fun picture(
        who: Identity,
        id: String,
        case: String,
        picture: String,
    ): ByteArray {
        submissions.seenBy(who, id)
        val cases =
            reports
                .of(id)
                ?.report
                ?.seenBy(who)
                ?.cases() ?: live.casesOf(id).map { it.seenBy(who) }
        val pictures = cases.firstOrNull { it.name() == case && it.pictures().isNotEmpty() }?.pictures().orEmpty()
        val found = CasePicture.of(pictures, picture.removeSuffix(PNG)).getOrNull()
        return found?.png()?.takeIf { picture.endsWith(PNG) } ?: throw Rejection.UnknownPicture(case, picture)
    }
}

/** Inside `authenticate`: for the owner and for instructors. */
fun Route.results(
    results: Results,
    live: Live,
) {
    get("/submissions/{id}") {
        call.respondJson(results.view(call.identity(), call.submissionId(), call.language()))
    }
    get("/submissions/{id}/events") {
        val who = call.identity()
        val id = call.submissionId()
        results.view(who, id)
        call.respondEvents { follow(live, id) { results.view(who, id) } }
    }
    get("/submissions/{id}/cases/{case}/{picture}") {
        val picture =
            results.picture(
                call.identity(),
                call.submissionId(),
                call.parameters.getOrFail("case"),
                call.parameters.getOrFail("picture"),
            )
        call.response.header(HttpHeaders.CacheControl, "private, max-age=3600")
        call.respondBytes(picture, ContentType.Image.PNG)
    }
}

fun ApplicationCall.submissionId(): String = parameters.getOrFail("id")
