// Points that staff give or take beside those of grading, with a reason. Start with Adjustments.
package rasterlab.grader.adjustment

import org.jdbi.v3.core.Handle
import rasterlab.exercises.published.ManualPoints
import rasterlab.grader.course.AuditNote
import rasterlab.grader.problem.Rejection
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.Repeatable
import rasterlab.grader.storage.Secrets
import rasterlab.grader.storage.text
import rasterlab.grader.submission.Submissions
import java.sql.ResultSet
import java.time.Instant
import java.time.InstantSource
import kotlin.jvm.optionals.getOrNull

/**
 * Points that somebody gave, or took where they are negative.
 *
 * @param before the total of the submission before that
 * @param by id of the account, and of the one that took it back
 */
data class Adjustment(
    val id: String,
    val submission: String,
    val points: Int,
    val reason: String,
    val before: Int,
    val by: String,
    val givenAt: Instant,
    val revokedBy: String?,
    val revokedAt: Instant?,
)

/** Keeps what staff give and take; it counts until it is taken back, whatever is graded again. */
class Adjustments(
    private val database: Database,
    private val clock: InstantSource,
) {
    /** All of a submission, those that were taken back too, in the order of giving. */
    fun of(submission: String): List<Adjustment> =
        database.read { handle ->
            handle
                .createQuery("SELECT * FROM adjustments WHERE submission_id = :id ORDER BY given_at, id")
                .bind("id", submission)
                .map { row, _ -> adjustment(row) }
                .list()
        }

    /** Lists those that count, as the student reads them. */
    fun counting(submission: String): List<ManualPoints> =
        of(submission).filter { it.revokedAt == null }.map { ManualPoints(it.points, it.reason) }

    /**
     * Gives points, or takes them.
     *
     * @param told the number of points as somebody wrote it
     * @param by who does it, for the audit
     * @param key what the sender calls this request, so that repeating it gives nothing more
     */
    fun give(
        submission: String,
        told: String,
        reason: String,
        by: String,
        key: String?,
    ): Adjustment {
        val points =
            told
                .trim()
                .replace('−', '-')
                .toIntOrNull()
                ?.takeIf { it != 0 && it in -MOST..MOST }
                ?: throw Rejection.BadAdjustment("points", told, MOST)
        val why =
            reason.trim().takeIf { it.length in 1..MOST_REASON && it.none(Char::isISOControl) }
                ?: throw Rejection.BadAdjustment("reason", reason.trim().length, MOST_REASON)
        val request = Repeatable("points $by", key, "$submission $points $why")
        return database.write { handle ->
            val id =
                request.made(handle)
                    ?: insert(handle, submission, points, why, by)
                        .also { request.remember(handle, it, clock.instant()) }
            checkNotNull(find(handle, submission, id)) { "adjustment $id was just stored" }
        }
    }

    /** Takes back what was given; it stays noted. */
    fun revoke(
        submission: String,
        id: String,
        by: String,
    ): Adjustment =
        database.write { handle ->
            val found = find(handle, submission, id) ?: throw Rejection.UnknownAdjustment(id)
            if (found.revokedAt != null) throw Rejection.BadAdjustment("revoked")
            handle
                .createUpdate("UPDATE adjustments SET revoked_by = :by, revoked_at = :now WHERE id = :id")
                .bind("by", by)
                .bind("now", clock.instant().text())
                .bind("id", id)
                .execute()
            note(handle, submission, by, "points-revoke", "${found.points}")
            checkNotNull(find(handle, submission, id)) { "adjustment $id is there" }
        }

    private fun insert(
        handle: Handle,
        submission: String,
        points: Int,
        reason: String,
        by: String,
    ): String {
        val before =
            handle
                .createQuery(
                    """SELECT ${Submissions.NET} FROM submissions s
                       JOIN results r ON r.submission_id = s.id AND r.is_current = 1 WHERE s.id = :id""",
                ).bind("id", submission)
                .mapTo(Int::class.javaObjectType)
                .findOne()
                .getOrNull() ?: throw Rejection.BadAdjustment("ungraded")
        val id = Secrets.newId()
        handle
            .createUpdate(
                """INSERT INTO adjustments (id, submission_id, points, reason, total_before, account_id, given_at)
                   VALUES (:id, :submission, :points, :reason, :before, :by, :now)""",
            ).bind("id", id)
            .bind("submission", submission)
            .bind("points", points)
            .bind("reason", reason)
            .bind("before", before)
            .bind("by", by)
            .bind("now", clock.instant().text())
            .execute()
        note(handle, submission, by, "points", "$points, before $before")
        return id
    }

    private fun note(
        handle: Handle,
        submission: String,
        by: String,
        action: String,
        detail: String,
    ) {
        val course =
            handle
                .createQuery(
                    """SELECT course_id FROM students JOIN submissions ON student_id = students.id
                       WHERE submissions.id = :id""",
                ).bind("id", submission)
                .mapTo(String::class.java)
                .one()
        AuditNote(by, course, action, submission, detail).write(handle, clock.instant())
    }

    private fun find(
        handle: Handle,
        submission: String,
        id: String,
    ): Adjustment? =
        handle
            .createQuery("SELECT * FROM adjustments WHERE id = :id AND submission_id = :submission")
            .bind("id", id)
            .bind("submission", submission)
            .map { row, _ -> adjustment(row) }
            .findOne()
            .getOrNull()

    private fun adjustment(row: ResultSet) =
        Adjustment(
            row.getString("id"),
            row.getString("submission_id"),
            row.getInt("points"),
            row.getString("reason"),
            row.getInt("total_before"),
            row.getString("account_id"),
            Instant.parse(row.getString("given_at")),
            row.getString("revoked_by"),
            row.getString("revoked_at")?.let(Instant::parse),
        )

    companion object {
        /** The most points that are given or taken at once. */
        const val MOST = 1000

        /** The most characters of a reason. */
        const val MOST_REASON = 200
    }
}
