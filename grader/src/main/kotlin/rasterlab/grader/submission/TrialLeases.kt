package rasterlab.grader.submission

import org.jdbi.v3.core.Handle
import rasterlab.exercises.score.Report
import rasterlab.grader.storage.Database
import java.time.Duration
import java.time.InstantSource
import kotlin.jvm.optionals.getOrNull

/** Copies of submissions that staff run, when nothing waits that a student handed in. Their results never count. */
class TrialLeases(
    private val database: Database,
    private val reports: Reports,
    private val clock: InstantSource,
    steady: InstantSource,
    private val holder: String,
) : SideLeases(database, "trials", steady, holder) {
    /** Begins an attempt at the next one; null if none waits, or something of a student does. */
    fun claimNext(): Lease? {
        val token = Lease.newToken(holder)
        return database.write { handle ->
            val (trial, copied) = next(handle) ?: return@write null
            val original = Submissions.find(handle, copied) ?: return@write null
            handle
                .createUpdate(
                    """UPDATE trials SET state = 'running', lease = :lease, lease_until = :until, tries = tries + 1
                       WHERE id = :id""",
                ).bind("lease", token)
                .bind("until", after(Leases.LENGTH))
                .bind("id", trial)
                .execute()
            handle
                .createQuery("SELECT source, revision, tries FROM trials WHERE id = :id")
                .bind("id", trial)
                .map { row, _ ->
                    original.copy(
                        id = trial,
                        source = row.getString("source"),
                        revision = row.getString("revision"),
                        tries = row.getInt("tries"),
                    )
                }.one()
                .let { Lease(it, token) }
        }
    }

    /** The copy whose turn it is, and what it is a copy of. */
    private fun next(handle: Handle): Pair<String, String>? =
        handle
            .createQuery(
                """SELECT id, submission_id FROM trials
                   WHERE state = 'queued' AND coalesce(lease_until, '') <= :now AND NOT $NEW_WAITS
                   ORDER BY begun_at, id LIMIT 1""",
            ).bind("now", after(Duration.ZERO))
            .map { row, _ -> row.getString("id") to row.getString("submission_id") }
            .findOne()
            .getOrNull()

    override fun finish(
        lease: Lease,
        revision: String,
        report: Report,
    ): Boolean {
        report.drawAll()
        return database.write { handle ->
            val original =
                handle
                    .createQuery("SELECT submission_id FROM trials WHERE lease = :lease")
                    .bind("lease", lease.token)
                    .mapTo(String::class.java)
                    .findOne()
                    .getOrNull() ?: return@write false
            val result = reports.insert(handle, original, revision, report, clock.instant(), current = false)
            handle
                .createUpdate(
                    """UPDATE trials SET state = 'done', lease = NULL, lease_until = NULL, result_id = :result
                       WHERE lease = :lease""",
                ).bind("result", result)
                .bind("lease", lease.token)
                .execute() == 1
        }
    }
}
