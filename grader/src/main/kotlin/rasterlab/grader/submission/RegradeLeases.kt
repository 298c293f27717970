package rasterlab.grader.submission

import org.jdbi.v3.core.Handle
import rasterlab.exercises.score.GradingVerdict
import rasterlab.exercises.score.Report
import rasterlab.grader.storage.Database
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
    steady: InstantSource,
    private val holder: String,
) : SideLeases(database, "regrade_items", steady, holder) {
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
                       AND NOT $NEW_WAITS
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

    override fun finish(
        lease: Lease,
        revision: String,
        report: Report,
    ): Boolean {
        report.drawAll()
        return database.write { handle ->
            val held = held(handle, lease) ?: return@write false
            val now = clock.instant()
            val submission = lease.submission.id
            val graded = Recorded(report, revision, now)
            val counts = held.case?.let { only(it, graded, reports.of(handle, submission)) } ?: graded
            val result = reports.insert(handle, submission, counts.revision, counts.report, now, current = false)
            handle
                .createUpdate(
                    """UPDATE regrade_items SET state = 'done', lease = NULL, lease_until = NULL, result_id = :result
                       WHERE regrade_id = :regrade AND submission_id = :submission""",
                ).bind("result", result)
                .bind("regrade", held.regrade)
                .bind("submission", submission)
                .execute()
            RegradedResults.settle(handle, now)
            true
        }
    }

    private fun held(
        handle: Handle,
        lease: Lease,
    ): Held? =
        handle
            .createQuery(
                """SELECT regrades.id, case_name, earns_stability
                   FROM regrade_items JOIN regrades ON regrades.id = regrade_id WHERE lease = :lease""",
            ).bind("lease", lease.token)
            .map { row, _ ->
                val case = row.getString("case_name")?.let { OneCase(it, row.getInt("earns_stability") == 1) }
                Held(row.getString("id"), case)
            }.findOne()
            .getOrNull()

    /**
     * The [former] report with [case] as [again] has it, and as it was where that says nothing of the case. It stays one of
     * the revision that judged all its other cases.
     */
    private fun only(
        case: OneCase,
        again: Recorded,
        former: Recorded?,
    ): Recorded? {
        if (again.report.verdict() == GradingVerdict.INTERNAL || former == null) return null
        val judged = again.report.cases().find { it.name() == case.name } ?: return former
        val isThere = former.report.cases().any { it.name() == case.name }
        return if (isThere) former.copy(report = former.report.withCase(judged, case.stability)) else former
    }

    /** Puts back what nobody grades any more, and ends what has nothing left to grade, as where a student was deleted. */
    override fun releaseExpired() {
        super.releaseExpired()
        database.write { RegradedResults.settle(it, clock.instant()) }
    }

    private class OneCase(
        val name: String,
        val stability: Boolean,
    )

    private class Held(
        val regrade: String,
        val case: OneCase?,
    )

    private class Next(
        val regrade: String,
        val submission: String,
        val revision: String,
        val tries: Int,
    )
}
