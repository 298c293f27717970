package rasterlab.grader.comment

import org.jdbi.v3.core.Handle
import org.jdbi.v3.core.statement.Query
import rasterlab.grader.course.Identity
import rasterlab.grader.problem.Paging
import rasterlab.grader.problem.Rejection
import rasterlab.grader.storage.text
import rasterlab.grader.submission.Submission
import java.sql.ResultSet
import java.time.Instant
import kotlin.jvm.optionals.getOrNull

/** The rows of comments, within the transaction of [handle]. */
internal class CommentRows(
    private val handle: Handle,
) {
    /**
     * Reads comments of a submission, in the order of writing.
     *
     * @param after the last one that was read; null to begin with the first
     */
    fun of(
        submission: String,
        after: LineComment? = null,
        most: Int = Int.MAX_VALUE,
    ): List<LineComment> =
        query(
            "$SELECT WHERE c.submission_id = :submission ${if (after == null) "" else LATER} $ORDER LIMIT :most",
            after,
        ).bind("submission", submission)
            .bind("most", most)
            .map { row, _ -> comment(row) }
            .list()

    /** @throws Rejection.UnknownComment where the submission has none of that id */
    fun find(
        submission: String,
        id: String,
    ): LineComment = seek(submission, id) ?: throw Rejection.UnknownComment(id)

    /** The one of that id; null where the submission has none. */
    fun seek(
        submission: String,
        id: String,
    ): LineComment? =
        query("$SELECT WHERE c.id = :id AND c.submission_id = :submission", after = null)
            .bind("id", id)
            .bind("submission", submission)
            .map { row, _ -> comment(row) }
            .findOne()
            .getOrNull()

    /** @throws Rejection.ForeignComment where it is not one of [who] */
    fun own(
        who: Identity,
        submission: Submission,
        id: String,
    ): LineComment = find(submission.id, id).also { if (it.by != who.id) throw Rejection.ForeignComment() }

    /** How many the student wrote, or all others together. */
    fun countBy(
        who: Identity,
        submission: Submission,
    ): Int {
        val whose = if (who is Identity.StudentIdentity) "=" else "<>"
        return handle
            .createQuery("SELECT count(*) FROM comments WHERE submission_id = :id AND author_id $whose :student")
            .bind("id", submission.id)
            .bind("student", submission.student)
            .mapTo(Int::class.javaObjectType)
            .one()
    }

    fun insert(
        id: String,
        submission: String,
        by: String,
        thread: String?,
        lines: CommentedLines?,
        text: String,
        now: Instant,
    ) {
        handle
            .createUpdate(
                """INSERT INTO comments (id, submission_id, author_id, thread_id, line, last_line, text, written_at)
                   VALUES (:id, :submission, :by, :thread, :first, :last, :text, :now)""",
            ).bind("id", id)
            .bind("submission", submission)
            .bind("by", by)
            .bind("thread", thread)
            .bind("first", lines?.first)
            .bind("last", lines?.last)
            .bind("text", text)
            .bind("now", now.text())
            .execute()
    }

    fun setOpen(
        thread: String,
        open: Boolean,
    ) {
        handle
            .createUpdate("UPDATE comments SET is_open = :open WHERE id = :id")
            .bind("open", if (open) 1 else 0)
            .bind("id", thread)
            .execute()
    }

    fun edit(
        id: String,
        text: String,
        now: Instant,
    ) {
        handle
            .createUpdate("UPDATE comments SET text = :text, edited_at = :now WHERE id = :id")
            .bind("text", text)
            .bind("now", now.text())
            .bind("id", id)
            .execute()
    }

    fun hasAnswers(id: String): Boolean =
        handle
            .createQuery("SELECT count(*) FROM comments WHERE thread_id = :id")
            .bind("id", id)
            .mapTo(Int::class.javaObjectType)
            .one() > 0

    fun delete(id: String) {
        handle.createUpdate("DELETE FROM comments WHERE id = :id").bind("id", id).execute()
    }

    /**
     * Reads open questions of a course, the oldest first, one more than the part has where there is one.
     *
     * @throws Rejection.Malformed where no comment has the id behind which the part begins
     */
    fun questions(
        course: String,
        paging: Paging,
    ): List<OpenQuestion> {
        val before = paging.after?.let { id -> beginning(id) ?: throw paging.unknown() }
        return query("$QUESTIONS ${if (before == null) "" else LATER} $ORDER LIMIT :most", before)
            .bind("course", course)
            .bind("most", paging.reach)
            .map { row, _ ->
                val attempt = row.getInt("attempt")
                OpenQuestion(comment(row), row.getString("student_name"), row.getString("exercise"), attempt)
            }.list()
    }

    fun openCounts(): Map<String, Int> =
        handle
            .createQuery(
                """SELECT owners.course_id, count(*) AS open FROM comments c
                   JOIN submissions s ON s.id = c.submission_id JOIN students owners ON owners.id = s.student_id
                   WHERE c.is_open = 1 GROUP BY owners.course_id""",
            ).map { row, _ -> row.getString("course_id") to row.getInt("open") }
            .list()
            .toMap()

    private fun beginning(id: String): LineComment? =
        query("$SELECT WHERE c.id = :id", after = null)
            .bind("id", id)
            .map {
                row,
                _,
                ->
                comment(row)
            }.findOne()
            .getOrNull()

    private fun query(
        sql: String,
        after: LineComment?,
    ): Query =
        handle.createQuery(sql).apply {
            if (after != null) bind("seenAt", after.writtenAt.text()).bind("seen", after.id)
        }

    private fun comment(row: ResultSet) =
        LineComment(
            row.getString("id"),
            row.getString("submission_id"),
            row.getString("thread_id"),
            row.getInt("line").takeUnless { row.wasNull() }?.let { CommentedLines(it, row.getInt("last_line")) },
            row.getString("author_id"),
            row.getString("author_name").orEmpty(),
            row.getString("author_role"),
            row.getString("text"),
            Instant.parse(row.getString("written_at")),
            row.getString("edited_at")?.let(Instant::parse),
            row.getInt("is_open") == 1,
        )

    private companion object {
        const val AUTHOR =
            """c.*, coalesce(students.shown_name, instructors.name) AS author_name,
                   CASE WHEN students.id IS NOT NULL THEN 'student' ELSE coalesce(instructors.role, 'instructor') END
                       AS author_role"""
        const val AUTHORS =
            """comments c LEFT JOIN students ON students.id = c.author_id
               LEFT JOIN instructors ON instructors.id = c.author_id"""
        const val SELECT = "SELECT $AUTHOR FROM $AUTHORS"
        const val QUESTIONS =
            """SELECT $AUTHOR, owners.shown_name AS student_name, s.exercise, s.attempt FROM $AUTHORS
               JOIN submissions s ON s.id = c.submission_id JOIN students owners ON owners.id = s.student_id
               WHERE c.is_open = 1 AND owners.course_id = :course"""
        const val LATER = "AND (c.written_at > :seenAt OR (c.written_at = :seenAt AND c.id > :seen))"
        const val ORDER = "ORDER BY c.written_at, c.id"
    }
}
