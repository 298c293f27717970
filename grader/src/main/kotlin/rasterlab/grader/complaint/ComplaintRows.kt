package rasterlab.grader.complaint

import org.jdbi.v3.core.Handle
import rasterlab.grader.course.Identity
import rasterlab.grader.problem.Paging
import rasterlab.grader.problem.Rejection
import rasterlab.grader.regrade.RegradeState
import rasterlab.grader.storage.text
import java.sql.ResultSet
import java.time.Instant
import kotlin.jvm.optionals.getOrNull

/** The rows of complaints, within the transaction of [handle]. */
internal class ComplaintRows(
    private val handle: Handle,
) {
    /** Lists those of a submission, in the order of opening. */
    fun of(submission: String): List<CaseComplaint> =
        handle
            .createQuery("$SELECT WHERE c.submission_id = :submission ORDER BY c.opened_at, c.id")
            .bind("submission", submission)
            .map { row, _ -> complaint(row) }
            .list()

    /** @throws Rejection.UnknownComplaint where the submission has none of that id */
    fun find(
        submission: String,
        id: String,
    ): CaseComplaint =
        handle
            .createQuery("$SELECT WHERE c.id = :id AND c.submission_id = :submission")
            .bind("id", id)
            .bind("submission", submission)
            .map { row, _ -> complaint(row) }
            .findOne()
            .getOrNull() ?: throw Rejection.UnknownComplaint(id)

    /** Stores one against the result that counts now; false where that has one for the case already. */
    fun insert(
        id: String,
        submission: String,
        case: String,
        text: String,
        now: Instant,
    ): Boolean =
        handle
            .createUpdate(
                """INSERT INTO complaints (id, submission_id, result_id, case_name, text, opened_at)
                   SELECT :id, submission_id, id, :case, :text, :now FROM results
                   WHERE submission_id = :submission AND is_current = 1
                       AND NOT EXISTS (SELECT 1 FROM complaints WHERE result_id = results.id AND case_name = :case)""",
            ).bind("id", id)
            .bind("submission", submission)
            .bind("case", case)
            .bind("text", text)
            .bind("now", now.text())
            .execute() == 1

    /** Settles an open one; false where it is none any more. */
    fun settle(
        id: String,
        state: ComplaintState,
        by: Identity,
        text: String,
        regrade: String?,
        now: Instant,
    ): Boolean =
        handle
            .createUpdate(
                """UPDATE complaints SET state = :state, answer = :text, account_id = :by, answered_at = :now,
                       regrade_id = :regrade
                   WHERE id = :id AND state = 'open'""",
            ).bind("id", id)
            .bind("state", state.code)
            .bind("by", by.id)
            .bind("text", text)
            .bind("regrade", regrade)
            .bind("now", now.text())
            .execute() == 1

    /**
     * Lists those of a course, the open ones from the oldest on, or those that are settled from the latest on; one more
     * than the part has where there is one.
     *
     * @throws Rejection.Malformed where the course has none of the id behind which the part begins
     */
    fun ofCourse(
        course: String,
        open: Boolean,
        paging: Paging,
    ): List<ListedComplaint> {
        val last = paging.after?.let { moment(course, it) ?: throw paging.unknown() }
        val (state, at, order) = if (open) OPEN else SETTLED
        val later = if (open) ">" else "<"
        val behind = if (last == null) "" else "AND ($at, c.id) $later (:seenAt, :seen)"
        return handle
            .createQuery("$LISTED WHERE owners.course_id = :course AND $state $behind ORDER BY $order LIMIT :most")
            .bind("course", course)
            .bind("most", paging.reach)
            .apply {
                if (last != null) bind("seenAt", if (open) last.openedAt else last.settledAt).bind("seen", paging.after)
            }.map { row, _ ->
                val attempt = row.getInt("attempt")
                ListedComplaint(complaint(row), row.getString("student_name"), row.getString("exercise"), attempt)
            }.list()
    }

    /** How many wait in each course that has some, by the course's id. */
    fun openCounts(): Map<String, Int> =
        handle
            .createQuery(
                """SELECT owners.course_id, count(*) AS waiting FROM complaints c
                   JOIN submissions s ON s.id = c.submission_id JOIN students owners ON owners.id = s.student_id
                   WHERE c.state = 'open' GROUP BY owners.course_id""",
            ).map { row, _ -> row.getString("course_id") to row.getInt("waiting") }
            .list()
            .toMap()

    private class Moments(
        val openedAt: String,
        val settledAt: String,
    )

    private fun moment(
        course: String,
        id: String,
    ): Moments? =
        handle
            .createQuery("$LISTED WHERE c.id = :id AND owners.course_id = :course")
            .bind("id", id)
            .bind("course", course)
            .map { row, _ -> Moments(row.getString("opened_at"), row.getString("answered_at").orEmpty()) }
            .findOne()
            .getOrNull()

    private fun complaint(row: ResultSet) =
        CaseComplaint(
            row.getString("id"),
            row.getString("submission_id"),
            row.getString("case_name"),
            row.getInt("of_current") == 1,
            row.getString("text"),
            Instant.parse(row.getString("opened_at")),
            ComplaintState.entries.single { it.code == row.getString("state") },
            row.getString("answer")?.let {
                val role = row.getString("author_role") ?: "instructor"
                ComplaintAnswer(
                    it,
                    row.getString("author_name").orEmpty(),
                    role,
                    Instant.parse(row.getString("answered_at")),
                )
            },
            row.getString("regrade_id")?.let { id ->
                ComplaintRegrade(id, RegradeState.entries.single { it.code == row.getString("regrade_state") })
            },
        )

    private companion object {
        const val COLUMNS =
            """c.*, r.is_current AS of_current, instructors.name AS author_name, instructors.role AS author_role,
                   regrades.state AS regrade_state"""
        const val ROWS =
            """complaints c JOIN results r ON r.id = c.result_id
               LEFT JOIN instructors ON instructors.id = c.account_id LEFT JOIN regrades ON regrades.id = c.regrade_id"""
        const val SELECT = "SELECT $COLUMNS FROM $ROWS"
        const val LISTED =
            """SELECT $COLUMNS, owners.shown_name AS student_name, s.exercise, s.attempt FROM $ROWS
               JOIN submissions s ON s.id = c.submission_id JOIN students owners ON owners.id = s.student_id"""
        val OPEN = Triple("c.state = 'open'", "c.opened_at", "c.opened_at, c.id")
        val SETTLED = Triple("c.state <> 'open'", "c.answered_at", "c.answered_at DESC, c.id DESC")
    }
}
