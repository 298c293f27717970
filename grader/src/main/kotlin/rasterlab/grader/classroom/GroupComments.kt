package rasterlab.grader.classroom

import org.jdbi.v3.core.Handle
import org.jdbi.v3.core.statement.SqlStatement
import rasterlab.exercises.Exercise
import rasterlab.grader.comment.CommentText
import rasterlab.grader.course.AuditNote
import rasterlab.grader.course.Course
import rasterlab.grader.course.Identity
import rasterlab.grader.problem.Rejection
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.text
import rasterlab.grader.submission.Submission
import java.sql.ResultSet
import java.time.Instant
import java.time.InstantSource
import kotlin.jvm.optionals.getOrNull

/**
 * A comment of staff to all who gave the same wrong answers, now or later.
 *
 * @param group id of theirs
 * @param name of whoever wrote it; empty where the account has none
 */
data class GroupComment(
    val group: String,
    val text: String,
    val name: String,
    val writtenAt: Instant,
)

/** Keeps one comment for each group of the same wrong answers; whoever comes to a group later has it too. */
class GroupComments(
    private val database: Database,
    private val clock: InstantSource,
    private val last: LastResults,
) {
    /** Reads those of an exercise, by their groups. */
    fun of(
        course: Course,
        exercise: Exercise,
    ): Map<String, GroupComment> =
        database.read { handle ->
            handle
                .createQuery("$SELECT WHERE c.course_id = :course AND c.exercise = :exercise")
                .at(course.id, exercise.id())
                .map { row, _ -> comment(row) }
                .list()
                .associateBy { it.group }
        }

    /**
     * Says something to a group, in place of what was said before.
     *
     * @throws Rejection.UnknownGroup where no two students have these answers, and nothing was said to them before
     */
    fun write(
        who: Identity.StaffIdentity,
        course: Course,
        exercise: Exercise,
        group: String,
        text: CommentText,
    ): GroupComment {
        val groups = ErrorMap(last.of(course.id, exercise.id()), exercise).groups
        return database.write { handle ->
            if (groups.none { it.id == group }) find(handle, course, exercise, group)
            val now = clock.instant()
            handle
                .createUpdate(
                    """INSERT INTO group_comments (course_id, exercise, wrong_group, text, account_id, written_at)
                       VALUES (:course, :exercise, :group, :text, :by, :now)
                       ON CONFLICT (course_id, exercise, wrong_group) DO UPDATE
                       SET text = :text, account_id = :by, written_at = :now""",
                ).at(course.id, exercise.id())
                .bind("group", group)
                .bind("text", text.text)
                .bind("by", who.id)
                .bind("now", now.text())
                .execute()
            AuditNote(who.id, course.id, "comment-group", exercise.id(), "$group: ${text.text}").write(handle, now)
            find(handle, course, exercise, group)
        }
    }

    /** Says it no longer. */
    fun drop(
        who: Identity.StaffIdentity,
        course: Course,
        exercise: Exercise,
        group: String,
    ): GroupComment =
        database.write { handle ->
            val found = find(handle, course, exercise, group)
            handle
                .createUpdate(
                    """DELETE FROM group_comments
                       WHERE course_id = :course AND exercise = :exercise AND wrong_group = :group""",
                ).at(course.id, exercise.id())
                .bind("group", group)
                .execute()
            AuditNote(who.id, course.id, "comment-group-drop", exercise.id(), "$group: ${found.text}")
                .write(handle, clock.instant())
            found
        }

    /** Reads what is said to the group that a submission is in; null where nothing is. */
    fun to(
        submission: Submission,
        exercise: Exercise,
    ): GroupComment? =
        database.read { handle ->
            val said =
                handle
                    .createQuery(
                        """$SELECT JOIN students ON students.course_id = c.course_id
                           WHERE students.id = :student AND c.exercise = :exercise""",
                    ).bind("student", submission.student)
                    .bind("exercise", submission.exercise)
                    .map { row, _ -> comment(row) }
                    .list()
            if (said.isEmpty()) return@read null
            val group = last.of(handle, submission)?.let { WrongAnswers(exercise).groupOf(it) }
            said.find { it.group == group }
        }

    private fun find(
        handle: Handle,
        course: Course,
        exercise: Exercise,
        group: String,
    ): GroupComment =
        handle
            .createQuery("$SELECT WHERE c.course_id = :course AND c.exercise = :exercise AND c.wrong_group = :group")
            .at(course.id, exercise.id())
            .bind("group", group)
            .map { row, _ -> comment(row) }
            .findOne()
            .getOrNull() ?: throw Rejection.UnknownGroup(group)

    private fun <S : SqlStatement<S>> S.at(
        course: String,
        exercise: String,
    ): S = bind("course", course).bind("exercise", exercise)

    private fun comment(row: ResultSet) =
        GroupComment(
            row.getString("wrong_group"),
            row.getString("text"),
            row.getString("author").orEmpty(),
            Instant.parse(row.getString("written_at")),
        )

    private companion object {
        const val SELECT =
            """SELECT c.*, instructors.name AS author FROM group_comments AS c
               LEFT JOIN instructors ON instructors.id = c.account_id"""
    }
}
