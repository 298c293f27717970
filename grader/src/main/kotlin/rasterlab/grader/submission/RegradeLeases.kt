package rasterlab.grader.submission

import org.jdbi.v3.core.Handle
import org.jdbi.v3.core.statement.Update
import rasterlab.exercises.score.Report
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.text
import java.time.Duration
import java.time.InstantSource
import kotlin.jvm.optionals.getOrNull

/**
 * Submissions that are graded again, when no new one waits. Each stays done meanwhile, and its earlier result counts
 * until the whole regrade is accepted.
 *
 * @param steady tells when a lease has run out
 * @param holder the name of this process, which grades them
 */
class RegradeLeases(
    private val database: Database,
    private val reports: Reports,
    private val clock: InstantSource,
    private val steady: InstantSource,
    private val holder: String,
) : LeaseKeeper {
    /** How many are still to be graded. */
    fun waiting(): Int =
        database.read {
            it
                .createQuery("SELECT count(*) FROM regrade_items WHERE state = 'queued'")
                .mapTo(Int::class.javaObjectType)
                .one()
        }

    /** Begins an attempt at the next one, against the revision of its regrade; null if none waits, or a new one does. */
    fun claimNext(): Lease? {
        val token = Lease.newToken(holder)
        return database.write { handle ->
            val next = next(handle) ?: return@write null
            handle
                .createUpdate(
                    """UPDATE regrade_items SET state = 'running', lease = :lease, lease_until = :until, tries = :tries
                       WHERE regrade_id = :regrade AND submission_id = :submission""",
                ).bind("lease", token)
                .bind("until", after(Leases.LENGTH))
                .bind("tries", next.tries)
                .bind("regrade", next.regrade)
                .bind("submission", next.submission)
                .execute()
            Submissions.find(handle, next.submission)?.let {
                Lease(it.copy(revision = next.revision, tries = next.tries), token)
            }
        }
    }

    private fun next(handle: Handle): Next? =
        handle
            .createQuery(
                """SELECT i.regrade_id, i.submission_id, i.tries, regrades.revision
                   FROM regrade_items i JOIN regrades ON regrades.id = i.regrade_id
                   WHERE i.state = 'queued' AND coalesce(i.lease_until, '') <= :now
                       AND NOT EXISTS (SELECT 1 FROM submissions WHERE state = 'queued' AND coalesce(lease_until, '') <= :now)
                   ORDER BY regrades.begun_at, regrades.id, i.position LIMIT 1""",
            ).bind("now", after(Duration.ZERO))
            .map { row, _ ->
                Next(
                    row.getString("regrade_id"),
                    row.getString("submission_id"),
                    row.getString("revision"),
                    row.getInt("tries") + 1,
                )
            }.findOne()
            .getOrNull()

    override fun renew(lease: Lease) {
        update(lease, "lease_until = :until") { it.bind("until", after(Leases.LENGTH)) }
    }

    override fun giveUp(
        lease: Lease,
        counts: Boolean,
    ) {
        update(lease, "state = 'queued', lease = NULL, lease_until = :until, tries = tries - :uncounted") {
            it
                .bind("until", after(if (counts) Leases.PAUSE else Duration.ZERO))
                .bind("uncounted", if (counts) 0 else 1)
        }
    }

    private fun update(
        lease: Lease,
        change: String,
        bind: (Update) -> Update,
    ) = database.write {
        bind(it.createUpdate("UPDATE regrade_items SET $change WHERE lease = :lease"))
            .bind("lease", lease.token)
            .execute()
    }

    override fun finish(
        lease: Lease,
        revision: String,
        report: Report,
    ): Boolean {
        report.drawAll()
        return database.write { handle ->
            val regrade =
                handle
                    .createQuery("SELECT regrade_id FROM regrade_items WHERE lease = :lease")
                    .bind("lease", lease.token)
                    .mapTo(String::class.java)
                    .findOne()
                    .getOrNull() ?: return@write false
            val now = clock.instant()
            val submission = lease.submission.id
            val result = reports.insert(handle, submission, revision, report, now, current = false)
            handle
                .createUpdate(
                    """UPDATE regrade_items SET state = 'done', lease = NULL, lease_until = NULL, result_id = :result
                       WHERE regrade_id = :regrade AND submission_id = :submission""",
                ).bind("result", result)
                .bind("regrade", regrade)
                .bind("submission", submission)
                .execute()
            RegradedResults.settle(handle, now)
            true
        }
    }

    /** Puts back what nobody grades any more, and ends what has nothing left to grade, as where a student was deleted. */
    fun releaseExpired() {
        database.write {
            Lease.releaseRunOut(it, "$RELEASE WHERE state <> 'done'", steady.instant())
            RegradedResults.settle(it, clock.instant())
        }
    }

    /** Puts everything back: for a server that starts and is alone on its database. */
    fun releaseAll() {
        database.write {
            it.execute("$RELEASE WHERE state <> 'done'")
        }
    }

    /** Puts back what an earlier process of this name held when it ended. */
    fun releaseHeld() = database.write { Lease.releaseHeld(it, "$RELEASE WHERE state = 'running'", holder) }

    private fun after(wait: Duration) = (steady.instant() + wait).text()

    private class Next(
        val regrade: String,
        val submission: String,
        val revision: String,
        val tries: Int,
    )

    private companion object {
        const val RELEASE =
            "UPDATE regrade_items SET state = 'queued', lease = NULL, lease_until = NULL"
    }
}
