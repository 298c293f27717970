package rasterlab.grader.comparison

import rasterlab.exercises.published.PublishedCase
import rasterlab.grader.course.Identity
import rasterlab.grader.problem.Rejection
import rasterlab.grader.report.Results
import rasterlab.grader.report.SubmissionView
import rasterlab.grader.submission.Listed
import rasterlab.grader.submission.Submission
import rasterlab.grader.submission.Submissions

/** A case in two results; null where one has none of that name. */
data class CasePair(
    val first: PublishedCase?,
    val second: PublishedCase?,
) {
    val either = checkNotNull(first ?: second) { "a case of neither result" }

    /** Whether both results say the same of it. */
    val isSame
        get() =
            first != null &&
                second != null &&
                listOf(first.verdict, first.points, first.of, first.message) ==
                listOf(second.verdict, second.points, second.of, second.message)
}

/** A submission with its result as far as the reader may see it. */
class Version(
    val submission: Submission,
    val view: SubmissionView,
)

/**
 * Two submissions of a student for an exercise, the earlier one first.
 *
 * @param lines null where a text is too long to be compared
 */
class VersionPair(
    val first: Version,
    val second: Version,
    val lines: List<LineRow>?,
) {
    /** The cases in the order of the later result; those that only the earlier one has come last. */
    val cases: List<CasePair> =
        (second.view.cases + first.view.cases).map { it.name }.distinct().map { name ->
            CasePair(first.view.cases.find { it.name == name }, second.view.cases.find { it.name == name })
        }
}

/** Finds two submissions of a student for an exercise, for whoever may see them. */
class VersionPairs(
    private val submissions: Submissions,
    private val results: Results,
) {
    /** Lists the submissions that [id] can be set beside, and itself, the latest first. */
    fun choices(
        who: Identity,
        id: String,
    ): List<Listed> = submissions.seenBy(who, id).let { submissions.ofStudent(it.student, it.exercise) }

    /**
     * Sets two beside each other.
     *
     * @param other id of a submission of the same student for the same exercise
     * @throws Rejection.UnknownSubmission where it is none of those
     */
    fun of(
        who: Identity,
        id: String,
        other: String,
        language: String,
    ): VersionPair {
        val both = listOf(id, other).map { submissions.seenBy(who, it) }
        if (both.distinctBy { it.student to it.exercise }.size > 1) throw Rejection.UnknownSubmission(other)
        val (first, second) = both.sortedBy { it.attempt }.map { Version(it, results.view(who, it.id, language)) }
        return VersionPair(first, second, LineDifference.of(first.submission.source, second.submission.source))
    }
}
