package rasterlab.grader.submission

import org.jdbi.v3.core.Handle
import rasterlab.exercises.score.Report
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.Secrets
import rasterlab.grader.storage.text
import rasterlab.grader.submission.Reports
import java.time.Duration
import java.time.Instant
import java.time.InstantSource
import kotlin.jvm.optionals.getOrNull

/**
 * The right to grade a submission, until it runs out or the result is in.
 *
 * @param token begins with the name of the process that has it
 */
data class Lease(
    val submission: Submission,
    val token: String,
) {
    internal companion object {
        /** A lease is over by time, or ends so late that the clock was set back since. */
        const val RUN_OUT = "(lease_until <= :now OR lease_until > :latest)"

        private const val HELD = "substr(lease, 1, :length) = :holder"

        fun newToken(holder: String): String = "$holder ${Secrets.newId()}"

        /** Makes [release], whose condition this adds to, of those that a process of that name held. */
        fun releaseHeld(
            handle: Handle,
            release: String,
            holder: String,
        ) {
            handle
                .createUpdate("$release AND $HELD")
                .bind("holder", "$holder ")
                .bind("length", holder.length + 1)
                .execute()
        }

        /** Makes [release], whose condition this adds to, of those that have run out. */
        fun releaseRunOut(
            handle: Handle,
            release: String,
            now: Instant,
        ) {
            handle
                .createUpdate("$release AND $RUN_OUT")
                .bind("now", now.text())
                .bind("latest", (now + Leases.LENGTH + Leases.PAUSE).text())
                .execute()
        }
    }
}

/** Keeps the leases of one kind of work. */
interface LeaseKeeper {
    fun renew(lease: Lease)

    /**
     * Gives an attempt up, so that it is made again: after a pause where it counts, and else at once.
     *
     * @param counts whether it counts among the tries: not if only the server stops, or the database was away
     */
    fun giveUp(
        lease: Lease,
        counts: Boolean,
    )

    /** Writes the result and ends the lease, together or not at all; false if the lease is lost. */
    fun finish(
        lease: Lease,
        revision: String,
        report: Report,
    ): Boolean
}

/**
 * Who grades what. A submission has at most one lease; a worker whose lease ran out and was given to
 * another can write nothing any more.
 *
 * @param steady tells when a lease has run out: the other clock may be set while it runs
 * @param holder the name of this process, which no other has that uses the database now
 */
class Leases(
    private val database: Database,
    private val reports: Reports,
    private val clock: InstantSource,
    private val steady: InstantSource,
    private val holder: String = ONE_SERVER,
) : LeaseKeeper {
    /** A submission that is measured again when nothing waits; that, too, is done under a lease. */
    val measurements = Measurements(database, reports, steady, holder)

    /** Submissions that are graded again when no new one waits. */
    val regrades = RegradeLeases(database, reports, clock, steady, holder)

    /** Copies that staff run when no new submission waits. */
    val trials = TrialLeases(database, reports, clock, steady, holder)

    private val beside = listOf(regrades, trials)

    /** Begins an attempt at the submission whose turn it is, or null if none waits. */
    fun claimNext(): Lease? {
        val token = Lease.newToken(holder)
        return database.write { handle ->
            val id = next(handle) ?: return@write null
            handle
                .createUpdate(
                    """UPDATE submissions SET state = 'running', lease = :lease, lease_until = :until, tries = tries + 1
                       WHERE id = :id""",
                ).bind("id", id)
                .bind("lease", token)
                .bind("until", after(LENGTH))
                .execute()
            Submissions.find(handle, id)?.let { Lease(it, token) }
        }
    }

    private fun next(handle: Handle): String? =
        handle
            .createQuery(
                """SELECT id FROM submissions WHERE state = 'queued' AND coalesce(lease_until, '') <= :now
                   ORDER BY round, sequence LIMIT 1""",
            ).bind("now", after(Duration.ZERO))
            .mapTo(String::class.java)
            .findOne()
            .getOrNull()

    override fun renew(lease: Lease) {
        database.write {
            it
                .createUpdate("UPDATE submissions SET lease_until = :until WHERE id = :id AND lease = :lease")
                .bind("until", after(LENGTH))
                .bind("id", lease.submission.id)
                .bind("lease", lease.token)
                .execute()
        }
    }

    override fun giveUp(
        lease: Lease,
        counts: Boolean,
    ) {
        database.write {
            it
                .createUpdate(
                    """UPDATE submissions SET state = 'queued', lease = NULL, lease_until = :until, tries = tries - :uncounted
                       WHERE id = :id AND lease = :lease""",
                ).bind("until", after(if (counts) PAUSE else Duration.ZERO))
                .bind("uncounted", if (counts) 0 else 1)
                .bind("id", lease.submission.id)
                .bind("lease", lease.token)
                .execute()
        }
    }

    override fun finish(
        lease: Lease,
        revision: String,
        report: Report,
    ): Boolean {
        report.drawAll()
        return database.write { handle ->
            val ended =
                handle
                    .createUpdate(
                        """UPDATE submissions SET state = 'done', lease = NULL, lease_until = NULL
                           WHERE id = :id AND lease = :lease""",
                    ).bind("id", lease.submission.id)
                    .bind("lease", lease.token)
                    .execute()
            if (ended == 1) {
                reports.insert(handle, lease.submission.id, revision, report, clock.instant())
                measurements.note(handle, lease.submission.id, report)
            }
            ended == 1
        }
    }

    /** Puts back into the queue what nobody grades any more. */
    fun releaseExpired() {
        beside.forEach { it.releaseExpired() }
        database.write {
            Lease.releaseRunOut(it, "$RELEASE WHERE state <> 'done'", steady.instant())
            Lease.releaseRunOut(it, "$MEASURED WHERE state = 'done'", steady.instant())
        }
    }

    /**
     * Puts back what an earlier process of this name held when it ended, for one that starts and shares its database.
     * Speeds that nobody measures are due now: the clock may have been set since.
     */
    fun releaseHeld() {
        beside.forEach { it.releaseHeld() }
        database.write {
            Lease.releaseHeld(it, "$RELEASE WHERE state = 'running'", holder)
            Lease.releaseHeld(it, "$MEASURED WHERE state = 'done'", holder)
            it.execute("UPDATE submissions SET speed_due = NULL WHERE speeds_left > 0 AND lease IS NULL")
        }
    }

    /** Puts everything back: for a server that starts and is alone on its database. */
    fun releaseAll() {
        beside.forEach { it.releaseAll() }
        database.write {
            it.execute("$RELEASE WHERE state <> 'done'")
            it.execute("$MEASURED, speed_due = NULL WHERE speeds_left > 0")
        }
    }

    private fun after(wait: Duration) = (steady.instant() + wait).text()

    companion object {
        /** The name of the server where there is only one. */
        const val ONE_SERVER = "server"

        /** The length of a lease, longer than a few missed renewals. */
        val LENGTH: Duration = Duration.ofSeconds(60)

        /** The pause before our fault is tried again: what was short may be there again. */
        val PAUSE: Duration = Duration.ofSeconds(1)

        /** The result is there, only the lease to measure its speed again is not any more. */
        private const val MEASURED = "UPDATE submissions SET lease = NULL, lease_until = NULL"

        private const val RELEASE = "UPDATE submissions SET state = 'queued', lease = NULL, lease_until = NULL"
    }
}

/** Draws its pictures before others wait for the database. */
internal fun Report.drawAll() = cases().flatMap { it.pictures() }.forEach { it.russian() }
