package rasterlab.grader.lti

import rasterlab.grader.course.AuditNote
import rasterlab.grader.problem.Paging
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.text
import java.sql.ResultSet
import java.time.Instant
import java.time.InstantSource

/**
 * How a student's points at a link of a platform stand.
 *
 * @param link id of the place on the platform
 * @param points as they are to stand there; null for none
 * @param sentPoints that the platform took last; null where it took none
 * @param sentAt null where nothing was sent yet
 * @param dueAt when they are sent, next or again; null where nothing is to be sent
 * @param fault of the last try, a word or the status of the platform's answer; null where there was none
 */
data class ScoreState(
    val student: String,
    val link: String,
    val studentName: String,
    val platform: String,
    val exercise: String,
    val points: Int?,
    val of: Int,
    val sentPoints: Int?,
    val sentAt: Instant?,
    val dueAt: Instant?,
    val tries: Int,
    val fault: String?,
) {
    /** Tells it from all others of its course. */
    val id get() = "$student:$link"

    /** One word: sent, waiting, or failing as long as the platform has not taken them. */
    val code get() =
        when {
            dueAt == null -> "sent"
            fault == null -> "waiting"
            else -> "failing"
        }
}

/** Tells staff what was sent to platforms, and what was not. */
class ScoreStates(
    private val database: Database,
    private val wall: InstantSource,
    private val steady: InstantSource,
) {
    /** Reads those of a course, what is still to be sent first. */
    fun of(
        course: String,
        most: Int = MOST,
    ): List<ScoreState> = read(course, "CASE WHEN s.due_at IS NULL THEN 1 ELSE 0 END, $BY_STUDENT", most)

    /** Reads those of a course in an order that stays while they are sent, so that parts of it fit together. */
    fun byStudent(course: String): List<ScoreState> = read(course, BY_STUDENT, Paging.WHOLE)

    private fun read(
        course: String,
        order: String,
        most: Int,
    ): List<ScoreState> =
        database.read { handle ->
            handle
                .createQuery(
                    """SELECT s.*, students.shown_name, students.number, lti_platforms.name AS platform_name
                       FROM lti_scores s
                       JOIN students ON students.id = s.student_id
                       JOIN lti_links ON lti_links.id = s.link_id
                       JOIN lti_platforms ON lti_platforms.id = lti_links.platform_id
                       WHERE students.course_id = :course
                       ORDER BY $order
                       LIMIT :most""",
                ).bind("course", course)
                .bind("most", most)
                .map { row, _ -> state(row) }
                .list()
        }

    /**
     * Lets what waits after a failure be sent now.
     *
     * @param by who does it, for the audit
     * @return how many scores that are
     */
    fun sendNow(
        course: String,
        by: String,
    ): Int =
        database.write { handle ->
            val woken =
                handle
                    .createUpdate(
                        """UPDATE lti_scores SET due_at = :now, tries = 0
                           WHERE due_at > :now AND student_id IN (SELECT id FROM students WHERE course_id = :course)""",
                    ).bind("now", steady.instant().text())
                    .bind("course", course)
                    .execute()
            if (woken > 0) AuditNote(by, course, "lti-send", course, "$woken").write(handle, wall.instant())
            woken
        }

    private fun state(row: ResultSet) =
        ScoreState(
            row.getString("student_id"),
            row.getString("link_id"),
            row.getString("shown_name"),
            row.getString("platform_name"),
            row.getString("exercise"),
            row.getInt("points").takeUnless { row.wasNull() },
            row.getInt("points_of"),
            row.getInt("sent_points").takeUnless { row.wasNull() },
            row.getString("sent_at")?.let(Instant::parse),
            row.getString("due_at")?.let(Instant::parse),
            row.getInt("tries"),
            row.getString("fault"),
        )

    companion object {
        /** The most that are read where nobody asks for more. */
        const val MOST = 2000

        private const val BY_STUDENT = "students.number, s.exercise, s.link_id"
    }
}
