package rasterlab.grader.report

import io.ktor.http.ContentDisposition
import io.ktor.http.ContentType
import io.ktor.http.HttpHeaders
import io.ktor.http.withCharset
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.header
import io.ktor.server.response.respondBytes
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.util.getOrFail
import rasterlab.exercises.Exercise
import rasterlab.exercises.published.PublishedSpeed
import rasterlab.exercises.score.CasePicture
import rasterlab.exercises.score.CaseReport
import rasterlab.exercises.topic.CaseRules
import rasterlab.grader.adjustment.Adjustments
import rasterlab.grader.course.Identity
import rasterlab.grader.course.identity
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.problem.Rejection
import rasterlab.grader.problem.language
import rasterlab.grader.problem.pictureLanguage
import rasterlab.grader.problem.respondJson
import rasterlab.grader.rules.CourseRules
import rasterlab.grader.submission.Live
import rasterlab.grader.submission.Reports
import rasterlab.grader.submission.Submission
import rasterlab.grader.submission.Submissions
import java.time.InstantSource
import kotlin.jvm.optionals.getOrNull

/** Ends the name of a picture. */
private const val PNG = ".png"

/** The state of one submission, with its report. */
class Results(
    private val submissions: Submissions,
    private val reports: Reports,
    private val live: Live,
    private val exercises: Exercises,
    private val rules: CourseRules,
    private val adjustments: Adjustments,
    private val clock: InstantSource,
) {
    private val reasons = Reasons()

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
        val due = due(submission)
        val words =
            CaseWords(
                language,
                title = { exercise?.caseTitle(it.name(), language) ?: it.name() },
                reason = { case ->
                    exercise
                        ?.takeIf { recorded != null && case.isOpenTo(who, due) }
                        ?.let { reasons.of(it, case.name(), language) }
                },
                rule = { case -> exercise?.let { CaseRules.of(it, case.name()).getOrNull() } },
            )
        val manual = adjustments.counting(id)
        return submission.view(who, submissions.place(id), live.casesOf(id), recorded, against, due, words, manual) {
            exercise?.let { known -> PublishedSpeed.of(known.topic(), it) }
        }
    }

    private fun due(submission: Submission) =
        Due.of(
            rules.of(submission.student, submission.exercise),
            rules.shows(submission.student, submission.exercise),
            submission,
            clock.instant(),
        )

    /**
     * @param picture its kind with [PNG] behind it, such as "difference.png"
     * @param language in which its numbers are written
     */
    fun picture(
        who: Identity,
        id: String,
        case: String,
        picture: String,
        language: String,
    ): ByteArray {
        val pictures =
            seen(
                who,
                id,
            ).firstOrNull { it.name() == case && it.pictures().isNotEmpty() }?.pictures().orEmpty()
        return pictureIn(pictures, picture, language) ?: throw Rejection.UnknownPicture(case, picture)
    }

    /** A case that [who] may see, as a file that the lab opens. */
    fun scene(
        who: Identity,
        id: String,
        case: String,
    ): SavedFile {
        val found = seen(who, id).firstOrNull { it.name() == case && it.scene().isNotEmpty() }
        val scene = found?.scene() ?: throw Rejection.UnknownScene(case)
        return SavedFile(files(submissions.seenBy(who, id)).scene(case), "application/json", scene)
    }

    /** The text that was handed in, as a file. */
    fun source(
        who: Identity,
        id: String,
    ): SavedFile = sourceFile(submissions.seenBy(who, id))

    /** The text of [submission], as a file. */
    internal fun sourceFile(submission: Submission) =
        SavedFile(files(submission).source, form(submission).mediaType(), submission.source)

    /** Names of files that lead from the submission to the lab. */
    fun files(submission: Submission): LabFiles {
        val inLab = InLab.of(exercises.find(submission.exercise))
        return LabFiles(submission.exercise, submission.attempt, form(submission), inLab)
    }

    private fun form(submission: Submission) = exercises.find(submission.exercise)?.form() ?: Exercise.TaskKind.WRITE

    /** The judged cases with what [who] may not see taken out. */
    private fun seen(
        who: Identity,
        id: String,
    ): List<CaseReport> {
        val due = due(submissions.seenBy(who, id))
        val recorded = reports.of(id)?.report?.seenBy(who, due)
        return recorded?.cases() ?: live.casesOf(id).map { it.seenBy(who, due) }
    }
}

/** The file of one of [pictures], whose name is [picture]; null where it is none of them. */
internal fun pictureIn(
    pictures: List<CasePicture>,
    picture: String,
    language: String,
): ByteArray? =
    CasePicture
        .of(pictures, picture.removeSuffix(PNG))
        .getOrNull()
        ?.png(language)
        ?.takeIf { picture.endsWith(PNG) }

/** Serves results to the owner and to staff, inside `authenticate`. */
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
    get("/submissions/{id}/source") {
        call.respondFile(results.source(call.identity(), call.submissionId()))
    }
    get("/submissions/{id}/cases/{case}/scene.json") {
        val case = call.parameters.getOrFail("case")
        call.respondFile(results.scene(call.identity(), call.submissionId(), case))
    }
    get("/submissions/{id}/cases/{case}/{picture}") {
        val picture =
            results.picture(
                call.identity(),
                call.submissionId(),
                call.parameters.getOrFail("case"),
                call.parameters.getOrFail("picture"),
                call.pictureLanguage(),
            )
        call.response.header(HttpHeaders.CacheControl, "private, max-age=3600")
        call.respondBytes(picture, ContentType.Image.PNG)
    }
}

fun ApplicationCall.submissionId(): String = parameters.getOrFail("id")

internal suspend fun ApplicationCall.respondFile(file: SavedFile) {
    val saved = ContentDisposition.Attachment.withParameter(ContentDisposition.Parameters.FileName, file.name)
    response.header(HttpHeaders.ContentDisposition, saved.toString())
    response.header(HttpHeaders.CacheControl, "private, no-store")
    respondBytes(file.text.encodeToByteArray(), ContentType.parse(file.mediaType).withCharset(Charsets.UTF_8))
}
