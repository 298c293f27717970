package rasterlab.grader.submission

import org.jdbi.v3.core.statement.Update
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.text
import java.time.Duration
import java.time.InstantSource

/**
 * Leases of work beside what students hand in, each held by a row of [table].
 *
 * @param steady tells when a lease has run out
 * @param holder the name of this process, which does the work
 */
abstract class SideLeases(
    private val database: Database,
    private val table: String,
    private val steady: InstantSource,
    private val holder: String,
) : LeaseKeeper {
    private val release = "UPDATE $table SET state = 'queued', lease = NULL, lease_until = NULL"

    /** How many are still to be graded. */
    fun waiting(): Int =
        database.read {
            it
                .createQuery("SELECT count(*) FROM $table WHERE state = 'queued'")
                .mapTo(Int::class.javaObjectType)
                .one()
        }

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
        bind(it.createUpdate("UPDATE $table SET $change WHERE lease = :lease"))
            .bind("lease", lease.token)
            .execute()
    }

    /** Puts back what nobody grades any more. */
    open fun releaseExpired() {
        database.write { Lease.releaseRunOut(it, "$release WHERE state <> 'done'", steady.instant()) }
    }

    /** Puts everything back: for a server that starts and is alone on its database. */
    fun releaseAll() {
        database.write { it.execute("$release WHERE state <> 'done'") }
    }

    /** Puts back what an earlier process of this name held when it ended. */
    fun releaseHeld() = database.write { Lease.releaseHeld(it, "$release WHERE state = 'running'", holder) }

    /** The moment after a while, as leases are stored. */
    protected fun after(wait: Duration) = (steady.instant() + wait).text()

    protected companion object {
        /** Whether something waits now that a student handed in, which goes before. */
        const val NEW_WAITS =
            "EXISTS (SELECT 1 FROM submissions WHERE state = 'queued' AND coalesce(lease_until, '') <= :now)"
    }
}
