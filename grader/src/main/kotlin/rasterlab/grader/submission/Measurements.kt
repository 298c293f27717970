package rasterlab.grader.submission

import org.jdbi.v3.core.Handle
import rasterlab.exercises.score.Report
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.text
import java.time.Duration
import java.time.InstantSource
import kotlin.jvm.optionals.getOrNull

/**
 * Speeds that a busy machine did not let be measured, to be measured again when nothing waits and nothing runs.
 * The submission stays done meanwhile: only its points for speed may change.
 *
 * @param steady tells when the next try is due
 * @param holder the name of this process, which measures them
 */
class Measurements(
    private val database: Database,
    private val reports: Reports,
    private val steady: InstantSource,
    private val holder: String,
) {
    /** Takes note, in the transaction that writes the result, that its speed is to be measured again. */
    fun note(
        handle: Handle,
        submission: String,
        report: Report,
    ) {
        if (!report.speedIsUnsettled()) return
        handle
            .createUpdate("UPDATE submissions SET speeds_left = :tries, speed_due = :due WHERE id = :id")
            .bind("tries", TRIES)
            .bind("due", after(PAUSE))
            .bind("id", submission)
            .execute()
    }

    /** Whether one is due and the machine has nothing else to do. */
    fun isDue(): Boolean = database.read { next(it) } != null

    /** Begins another try, or null if none is due. */
    fun claimNext(): Lease? {
        val token = Lease.newToken(holder)
        return database.write { handle ->
            val id = next(handle) ?: return@write null
            handle
                .createUpdate(
                    """UPDATE submissions SET lease = :lease, lease_until = :until, speeds_left = speeds_left - 1,
                           speed_due = :due
                       WHERE id = :id""",
                ).bind("id", id)
                .bind("lease", token)
                .bind("until", after(Leases.LENGTH))
                .bind("due", after(PAUSE))
                .execute()
            Submissions.find(handle, id)?.let { Lease(it.copy(revision = current(handle, id)), token) }
        }
    }

    /** The revision of the exercise that the result was graded against, which a regrade may have changed. */
    private fun current(
        handle: Handle,
        submission: String,
    ): String =
        handle
            .createQuery("SELECT revision FROM results WHERE submission_id = :id AND is_current = 1")
            .bind("id", submission)
            .mapTo(String::class.java)
            .one()

    private fun next(handle: Handle): String? =
        handle
            .createQuery(
                """SELECT id FROM submissions
                   WHERE speeds_left > 0 AND state = 'done' AND coalesce(speed_due, '') <= :now
                       AND NOT EXISTS (SELECT 1 FROM submissions WHERE state IN ('queued', 'running') OR lease IS NOT NULL)
                       AND NOT EXISTS (SELECT 1 FROM regrade_items WHERE state <> 'done')
                   ORDER BY speed_due, sequence LIMIT 1""",
            ).bind("now", after(Duration.ZERO))
            .mapTo(String::class.java)
            .findOne()
            .getOrNull()

    /**
     * Ends a try. A speed that settled takes the place of the one in the result; false if it did not, or if the
     * lease is lost.
     *
     * @param report what the same source was given now, or null where the try came to nothing
     * @param counts whether it counts among the tries: not if only the server stops
     */
    fun finish(
        lease: Lease,
        report: Report?,
        counts: Boolean = true,
    ): Boolean =
        database.write { handle ->
            val settled = report?.speed()?.isPresent == true && !report.speedIsUnsettled()
            val ended =
                handle
                    .createUpdate(
                        """UPDATE submissions SET lease = NULL, lease_until = NULL,
                               speeds_left = CASE WHEN :settled THEN 0 ELSE speeds_left + :uncounted END
                           WHERE id = :id AND lease = :lease""",
                    ).bind("settled", settled)
                    .bind("uncounted", if (counts) 0 else 1)
                    .bind("id", lease.submission.id)
                    .bind("lease", lease.token)
                    .execute()
            val written = ended == 1 && settled
            if (written) reports.replaceSpeed(handle, lease.submission.id, checkNotNull(report))
            written
        }

    private fun after(wait: Duration) = (steady.instant() + wait).text()

    companion object {
        /**
         * The number of times that one speed is measured again; then what it cost is nothing, and
         * stays so.
         */
        const val TRIES = 3

        /** A machine that is busy now may be so for a while. */
        val PAUSE: Duration = Duration.ofSeconds(30)
    }
}
