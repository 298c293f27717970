package rasterlab.grader.complaint

import rasterlab.exercises.published.PublishedCase
import rasterlab.exercises.score.GradingVerdict
import rasterlab.grader.comment.CommentText
import rasterlab.grader.course.AuditNote
import rasterlab.grader.course.Course
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Identity
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.problem.ListPart
import rasterlab.grader.problem.Paging
import rasterlab.grader.problem.Rejection
import rasterlab.grader.regrade.RegradeChoice
import rasterlab.grader.regrade.Regrades
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.Repeatable
import rasterlab.grader.storage.Secrets
import rasterlab.grader.submission.Submission
import java.time.InstantSource

/**
 * Keeps complaints and their answers; whoever calls has made sure that they may see the submission.
 *
 * @param judged the cases of a submission that has a result, as far as its student sees them
 * @param ring tells that something is to be graded, by its id
 */
class ComplaintDesk(
    private val database: Database,
    private val courses: Courses,
    private val exercises: Exercises,
    private val regrades: Regrades,
    private val judged: (Identity.StudentIdentity, String) -> List<PublishedCase>,
    private val ring: (String) -> Unit,
    private val clock: InstantSource,
) {
    /** Reads all of a submission, in the order of opening. */
    fun of(submission: String): List<CaseComplaint> = database.read { ComplaintRows(it).of(submission) }

    /**
     * Opens a complaint against the result that counts now.
     *
     * @param case name of a case that did not get all its points
     * @param key what the sender calls this request, so that repeating it opens no other one
     * @throws Rejection.BadComplaint where there is none such, or it has a complaint already
     */
    fun open(
        student: Identity.StudentIdentity,
        submission: Submission,
        case: String,
        text: CommentText,
        key: String?,
    ): CaseComplaint {
        val request = Repeatable("complaints ${student.id}", key, "${submission.id} $case ${text.text}")
        database.read(request::made)?.let { return find(submission, it) }
        val found =
            judged(student, submission.id).find { it.name == case } ?: throw Rejection.BadComplaint("case", case)
        if (!found.canBeComplainedOf()) throw Rejection.BadComplaint("passed")
        return database.write { handle ->
            val rows = ComplaintRows(handle)
            request.made(handle)?.let { return@write rows.find(submission.id, it) }
            val id = Secrets.newId()
            val now = clock.instant()
            if (!rows.insert(id, submission.id, case, text.text, now)) throw Rejection.BadComplaint("twice")
            request.remember(handle, id, now)
            rows.find(submission.id, id)
        }
    }

    /**
     * Accepts an open complaint or declines it.
     *
     * @param regrade whether the case is graded again, and what comes of it counts; only for what is accepted, and by an
     *     instructor
     * @throws Rejection.BadComplaint where it is settled already
     */
    fun answer(
        who: Identity.StaffIdentity,
        submission: Submission,
        id: String,
        accepted: Boolean,
        text: CommentText,
        regrade: Boolean,
    ): CaseComplaint {
        if (regrade && !accepted) throw Rejection.BadComplaint("regrade")
        if (regrade && who !is Identity.Instructor) throw Rejection.WrongRole("instructor")
        val found = find(submission, id)
        if (found.state != ComplaintState.OPEN) throw Rejection.BadComplaint("settled")
        val course = courses.ofStudent(submission.student) ?: throw Rejection.UnknownStudent(submission.student)
        val begun = if (regrade) gradeAgain(who, course, submission, found) else null
        val state = if (accepted) ComplaintState.ACCEPTED else ComplaintState.DECLINED
        val action = if (accepted) "complaint-accept" else "complaint-decline"
        return database.write { handle ->
            val rows = ComplaintRows(handle)
            val now = clock.instant()
            if (!rows.settle(id, state, who, text.text, begun, now)) throw Rejection.BadComplaint("settled")
            AuditNote(who.id, course.id, action, submission.id, found.case).write(handle, now)
            rows.find(submission.id, id)
        }
    }

    /**
     * Begins the regrade of that one case, the same where it is asked for twice. What is said of the speed, of hidden cases
     * without a name, or of a case that the exercise has no more, cannot be replaced alone: there it is the whole result.
     */
    private fun gradeAgain(
        who: Identity,
        course: Course,
        submission: Submission,
        complaint: CaseComplaint,
    ): String {
        val exercise = exercises.named(submission.exercise)
        val one = listOf(submission.id)
        val key = "complaint ${complaint.id}"
        val case = exercise.cases().find { it.name() == complaint.case }
        val begun = regrades.start(course, exercise, RegradeChoice.SOME, one, dry = false, who.id, key, case)
        ring(begun.id)
        return begun.id
    }

    /** @throws Rejection.UnknownComplaint where the submission has none of that id */
    fun find(
        submission: Submission,
        id: String,
    ): CaseComplaint = database.read { ComplaintRows(it).find(submission.id, id) }

    /**
     * Reads complaints of a course: those that wait from the oldest on, or those that are settled from the latest on.
     *
     * @throws Rejection.Malformed where the course has none of the id behind which the part begins
     */
    fun ofCourse(
        course: String,
        open: Boolean,
        paging: Paging,
    ): ListPart<ListedComplaint> =
        database.read { handle ->
            paging.cut(ComplaintRows(handle).ofCourse(course, open, paging)) { it.complaint.id }
        }

    /** How many wait in each course that has some, by the course's id. */
    fun openCounts(): Map<String, Int> = database.read { ComplaintRows(it).openCounts() }
}

/** Whether it did not earn all its points. */
fun PublishedCase.canBeComplainedOf(): Boolean = verdict.codeFor(points, of) != GradingVerdict.OK.code()
