package rasterlab.grader.report

import rasterlab.exercises.published.PublishedSpeed
import rasterlab.exercises.score.CaseReport
import rasterlab.exercises.topic.CaseRules
import rasterlab.grader.course.Identity
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.problem.Rejection
import rasterlab.grader.submission.Live
import rasterlab.grader.submission.QueuePlace
import rasterlab.grader.submission.Reports
import rasterlab.grader.submission.Submission
import kotlin.jvm.optionals.getOrNull

/** Results of copies that staff run. Nothing is hidden in them; there is no deadline, and nothing beside grading. */
class CopiedResults(
    private val reports: Reports,
    private val results: Results,
    private val live: Live,
    private val exercises: Exercises,
) {
    /**
     * @param copy as if it were a submission
     * @param result id of its result; null as long as there is none
     * @param address under which its pictures are
     */
    fun view(
        copy: Submission,
        result: String?,
        address: String,
        language: String,
    ): SubmissionView {
        val recorded = result?.let(reports::at)
        val revision = recorded?.revision ?: copy.revision
        val exercise = exercises.at(copy.exercise, revision)
        val words =
            CaseWords(
                language,
                title = { exercise?.caseTitle(it.name(), language) ?: it.name() },
                reason = { null },
                rule = { case -> exercise?.let { CaseRules.of(it, case.name()).getOrNull() } },
                address = address,
            )
        val against = GradedAgainst(revision, exercises.isCurrent(copy.exercise, revision))
        val due = Due(at = null, late = false, passed = false, opensLater = false)
        val running = live.casesOf(copy.id)
        return copy.view(STAFF, QueuePlace.NONE, running, recorded, against, due, words, emptyList()) {
            exercise?.let { known -> PublishedSpeed.of(known.topic(), it) }
        }
    }

    /** @param picture its kind with the ending of its file, such as "difference.png" */
    fun picture(
        result: String?,
        case: String,
        picture: String,
        language: String,
    ): ByteArray {
        val found = cases(result).firstOrNull { it.name() == case }?.pictures().orEmpty()
        return pictureIn(found, picture, language) ?: throw Rejection.UnknownPicture(case, picture)
    }

    fun scene(
        copy: Submission,
        result: String?,
        case: String,
    ): SavedFile {
        val found = cases(result).firstOrNull { it.name() == case && it.scene().isNotEmpty() }
        val scene = found?.scene() ?: throw Rejection.UnknownScene(case)
        return SavedFile(results.files(copy).scene(case), "application/json", scene)
    }

    /** The changed text, as a file. */
    fun source(copy: Submission): SavedFile = results.sourceFile(copy)

    fun files(copy: Submission): LabFiles = results.files(copy)

    private fun cases(result: String?): List<CaseReport> =
        result
            ?.let(reports::at)
            ?.report
            ?.cases()
            .orEmpty()

    private companion object {
        /** Stands for all staff, who see the same. */
        val STAFF = Identity.Instructor("")
    }
}
