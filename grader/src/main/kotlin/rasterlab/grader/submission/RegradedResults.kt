package rasterlab.grader.submission

import org.jdbi.v3.core.Handle
import rasterlab.grader.storage.text
import java.time.Instant

/** Lets the results of a regrade count in the place of earlier ones, or the earlier ones again. */
internal object RegradedResults {
    /** Submissions whose result took the place of another; a fault of ours takes the place of none. */
    private const val REPLACED =
        """SELECT %s FROM regrade_items WHERE regrade_id = :regrade AND former_id IS NOT NULL"""

    /** The speed of a submission's current result was not to be measured. */
    private const val UNSETTLED =
        """EXISTS (SELECT 1 FROM results r JOIN case_results c ON c.result_id = r.id
               WHERE r.submission_id = submissions.id AND r.is_current = 1 AND c.verdict = 'NOT_MEASURED')"""

    /**
     * Ends the regrades that have nothing left to grade: a dry one waits for a decision then, another is accepted.
     */
    fun settle(
        handle: Handle,
        now: Instant,
    ) {
        val ended =
            handle
                .createQuery(
                    """SELECT id, is_dry FROM regrades WHERE state = 'grading' AND NOT EXISTS
                           (SELECT 1 FROM regrade_items WHERE regrade_id = regrades.id AND state <> 'done')""",
                ).map { row, _ -> row.getString("id") to (row.getInt("is_dry") == 1) }
                .list()
        for ((regrade, dry) in ended) {
            if (dry) mark(handle, regrade, "graded", null) else accept(handle, regrade, now)
        }
    }

    fun accept(
        handle: Handle,
        regrade: String,
        now: Instant,
    ) {
        handle
            .createUpdate(
                """UPDATE regrade_items SET former_id =
                       (SELECT id FROM results r WHERE r.submission_id = regrade_items.submission_id AND r.is_current = 1)
                   WHERE regrade_id = :regrade
                       AND result_id IN (SELECT id FROM results WHERE verdict <> 'internal')""",
            ).bind("regrade", regrade)
            .execute()
        exchange(handle, regrade, "former_id", "result_id")
        mark(handle, regrade, "accepted", now)
    }

    fun undo(
        handle: Handle,
        regrade: String,
        now: Instant,
    ) {
        exchange(handle, regrade, "result_id", "former_id")
        mark(handle, regrade, "undone", now)
    }

    /** How many of its results count no more, since a later regrade replaced them. */
    fun replaced(
        handle: Handle,
        regrade: String,
    ): Int =
        handle
            .createQuery(
                "SELECT count(*) FROM results WHERE is_current = 0 AND id IN (${REPLACED.format("result_id")})",
            ).bind("regrade", regrade)
            .mapTo(Int::class.javaObjectType)
            .one()

    fun mark(
        handle: Handle,
        regrade: String,
        state: String,
        settled: Instant?,
    ) {
        handle
            .createUpdate("UPDATE regrades SET state = :state, settled_at = :settled WHERE id = :regrade")
            .bind("state", state)
            .bind("settled", settled?.text())
            .bind("regrade", regrade)
            .execute()
    }

    /** A measurement that goes on for the former result loses its lease; the speed of the new one may be open in turn. */
    private fun exchange(
        handle: Handle,
        regrade: String,
        from: String,
        to: String,
    ) {
        for ((column, current) in listOf(from to 0, to to 1)) {
            handle
                .createUpdate("UPDATE results SET is_current = :current WHERE id IN (${REPLACED.format(column)})")
                .bind("current", current)
                .bind("regrade", regrade)
                .execute()
        }
        handle
            .createUpdate(
                """UPDATE submissions SET lease = NULL, lease_until = NULL, speed_due = NULL,
                       speeds_left = CASE WHEN $UNSETTLED THEN :tries ELSE 0 END
                   WHERE state = 'done' AND id IN (${REPLACED.format("submission_id")})""",
            ).bind("tries", Measurements.TRIES)
            .bind("regrade", regrade)
            .execute()
    }
}
