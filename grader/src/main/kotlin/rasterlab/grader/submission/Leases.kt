package rasterlab.grader.submission

import rasterlab.exercises.score.Report
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.Secrets
import rasterlab.grader.storage.text
import rasterlab.grader.submission.Reports
import java.time.Duration
import java.time.InstantSource

/** The right to grade a submission, until it runs out or the result is in. */
data class Lease(
    val submission: Submission,
    val token: String,
)

/**
 * Who grades what. A submission has at most one lease; a worker whose lease ran out and was given to
 * another can write nothing any more.
 */
class Leases(
    private val database: Database,
    private val reports: Reports,
    private val clock: InstantSource,
) {
    /** Begins an attempt, or null if the submission is graded, being graded or unknown. */
    fun claim(id: String): Lease? {
        val token = Secrets.newId()
        return database.write { handle ->
            val claimed =
                handle
                    .createUpdate(
                        """UPDATE submissions SET state = 'running', lease = :lease, lease_until = :until, tries = tries + 1
                           WHERE id = :id AND state = 'queued'""",
                    ).bind("id", id)
                    .bind("lease", token)
                    .bind("until", end())
                    .execute()
            if (claimed == 0) null else Submissions.find(handle, id)?.let { Lease(it, token) }
        }
    }

    fun renew(lease: Lease) {
        database.write {
            it
                .createUpdate("UPDATE submissions SET lease_until = :until WHERE id = :id AND lease = :lease")
                .bind("until", end())
                .bind("id", lease.submission.id)
                .bind("lease", lease.token)
                .execute()
        }
    }

    /**
     * Gives an attempt up, so that it is made again.
     *
     * @param counts whether it counts among the tries: not if only the server stops
     */
    fun giveUp(
        lease: Lease,
        counts: Boolean,
    ) {
        database.write {
            it
                .createUpdate(
                    """UPDATE submissions SET state = 'queued', lease = NULL, lease_until = NULL, tries = tries - :uncounted
                       WHERE id = :id AND lease = :lease""",
                ).bind("uncounted", if (counts) 0 else 1)
                .bind("id", lease.submission.id)
                .bind("lease", lease.token)
                .execute()
        }
    }

    /** Writes the result and ends the lease, together or not at all; false if the lease is lost. */
    fun finish(
        lease: Lease,
        revision: String,
        report: Report,
    ): Boolean =
        database.write { handle ->
            val ended =
                handle
                    .createUpdate(
                        """UPDATE submissions SET state = 'done', lease = NULL, lease_until = NULL
                           WHERE id = :id AND lease = :lease""",
                    ).bind("id", lease.submission.id)
                    .bind("lease", lease.token)
                    .execute()
            if (ended == 1) reports.insert(handle, lease.submission.id, revision, report, clock.instant())
            ended == 1
        }

    /** Puts back into the queue what nobody grades any more. */
    fun releaseExpired() {
        database.write {
            it.createUpdate("$RELEASE AND lease_until <= :now").bind("now", clock.instant().text()).execute()
        }
    }

    /** Puts everything back: for a server that starts and is alone on its database. */
    fun releaseAll() {
        database.write { it.execute(RELEASE) }
    }

    private fun end() = (clock.instant() + LENGTH).text()

    companion object {
        /** Longer than a few missed renewals. */
        val LENGTH: Duration = Duration.ofSeconds(60)

        private const val RELEASE =
            "UPDATE submissions SET state = 'queued', lease = NULL, lease_until = NULL WHERE state = 'running'"
    }
}
