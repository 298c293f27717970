/*
 * Copies of submissions that staff change and run: the submission, its marks and its student know nothing of them.
 * Read StaffCopies, then TrialRoutes. The work itself is done in submission, by TrialLeases.
 */
package rasterlab.grader.trial

import org.jdbi.v3.core.Handle
import rasterlab.exercises.Exercise
import rasterlab.grader.course.Identity
import rasterlab.grader.problem.ListPart
import rasterlab.grader.problem.Paging
import rasterlab.grader.problem.Rejection
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.Repeatable
import rasterlab.grader.storage.Secrets
import rasterlab.grader.storage.text
import rasterlab.grader.submission.State
import rasterlab.grader.submission.Submission
import java.sql.ResultSet
import java.time.Instant
import java.time.InstantSource
import kotlin.jvm.optionals.getOrNull

/**
 * A copy of a submission that one of the staff ran.
 *
 * @param submission id of the original
 * @param by name of whoever ran it; empty for the first instructor
 * @param result id of its result, which never counts; null as long as there is none
 */
data class StaffCopy(
    val id: String,
    val submission: String,
    val by: String,
    val revision: String,
    val source: String,
    val begunAt: Instant,
    val state: State,
    val result: String?,
    val verdict: String?,
)

/** Runs copies, and reads what came of them; only for staff. */
class StaffCopies(
    private val database: Database,
    private val clock: InstantSource,
) {
    /**
     * Puts a copy into the queue, behind all that students hand in.
     *
     * @param exercise of the submission, as it is now
     * @param key what the sender calls this request, so that repeating it runs no other one
     * @throws Rejection.BadTrial where the sender has [MOST_WAITING] waiting
     */
    fun run(
        who: Identity.StaffIdentity,
        submission: Submission,
        exercise: Exercise,
        source: String,
        key: String?,
    ): StaffCopy {
        if (!database.hasRoom()) throw Rejection.NoRoom()
        val request = Repeatable("trials ${who.id}", key, "${submission.id}\n$source")
        return database.write { handle ->
            request.made(handle)?.let { return@write find(handle, it) }
            if (waiting(handle, who.id) >= MOST_WAITING) throw Rejection.BadTrial("many", MOST_WAITING)
            val id = Secrets.newId()
            val now = clock.instant()
            handle
                .createUpdate(
                    """INSERT INTO trials (id, submission_id, account_id, revision, source, begun_at)
                       VALUES (:id, :submission, :by, :revision, :source, :now)""",
                ).bind("id", id)
                .bind("submission", submission.id)
                .bind("by", who.id)
                .bind("revision", exercise.revision())
                .bind("source", source)
                .bind("now", now.text())
                .execute()
            request.remember(handle, id, now)
            find(handle, id)
        }
    }

    private fun waiting(
        handle: Handle,
        by: String,
    ): Int =
        handle
            .createQuery("SELECT count(*) FROM trials WHERE account_id = :by AND state <> 'done'")
            .bind("by", by)
            .mapTo(Int::class.javaObjectType)
            .one()

    /** @throws Rejection.UnknownTrial where there is none of that id */
    fun find(id: String): StaffCopy = database.read { find(it, id) }

    /**
     * Lists those of a submission, the latest first.
     *
     * @throws Rejection.Malformed where the submission has none of the id behind which the part begins
     */
    fun of(
        submission: String,
        paging: Paging = Paging(after = null),
    ): ListPart<StaffCopy> =
        database.read { handle ->
            val last =
                paging.after?.let {
                    seek(handle, it)?.takeIf { one -> one.submission == submission }
                        ?: throw paging.unknown()
                }
            val earlier = if (last == null) "" else "AND (t.begun_at, t.id) < (:seenAt, :seen)"
            val read =
                handle
                    .createQuery(
                        "$SELECT WHERE t.submission_id = :id $earlier ORDER BY t.begun_at DESC, t.id DESC LIMIT :most",
                    ).bind("id", submission)
                    .bind("most", paging.reach)
                    .apply { if (last != null) bind("seenAt", last.begunAt.text()).bind("seen", last.id) }
                    .map { row, _ -> trial(row) }
                    .list()
            paging.cut(read) { it.id }
        }

    private fun find(
        handle: Handle,
        id: String,
    ): StaffCopy = seek(handle, id) ?: throw Rejection.UnknownTrial(id)

    private fun seek(
        handle: Handle,
        id: String,
    ): StaffCopy? =
        handle
            .createQuery("$SELECT WHERE t.id = :id")
            .bind("id", id)
            .map { row, _ -> trial(row) }
            .findOne()
            .getOrNull()

    private fun trial(row: ResultSet) =
        StaffCopy(
            row.getString("id"),
            row.getString("submission_id"),
            row.getString("author").orEmpty(),
            row.getString("revision"),
            row.getString("source"),
            Instant.parse(row.getString("begun_at")),
            State.of(row.getString("state")),
            row.getString("result_id"),
            row.getString("verdict"),
        )

    companion object {
        /** The most copies of one of the staff that wait together. */
        const val MOST_WAITING = 5

        /** The most that one answer lists. */
        private const val SELECT =
            """SELECT t.*, instructors.name AS author, r.verdict FROM trials t
               LEFT JOIN instructors ON instructors.id = t.account_id LEFT JOIN results r ON r.id = t.result_id"""
    }
}
