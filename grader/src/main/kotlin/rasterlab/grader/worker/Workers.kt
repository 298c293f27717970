// The processes that grade, on one machine or several: who they are, and whether they still are.
package rasterlab.grader.worker

import rasterlab.exercises.runner.Isolation
import rasterlab.exercises.score.Message
import rasterlab.grader.course.AuditNote
import rasterlab.grader.problem.Rejection
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.text
import java.time.Duration
import java.time.Instant
import java.time.InstantSource

/**
 * A process that grades.
 *
 * @param name which no other has
 * @param serves whether it serves pages, too
 * @param slots how many submissions it grades at the same time
 */
data class Worker(
    val name: String,
    val host: String,
    val serves: Boolean,
    val isolation: Message,
    val slots: Int,
) {
    init {
        require(slots >= 1) { "slots is $slots, expected at least 1" }
    }

    companion object {
        /** This process. */
        fun here(
            name: String,
            serves: Boolean,
            isolation: Isolation,
            slots: Int,
        ) = Worker(name, HostName.own(), serves, isolation.message(), slots)
    }
}

/** Whether a process takes work; a lost one is silent for so long that others grade what it had. */
enum class WorkerState {
    TAKING,
    DRAINING,
    LOST,
    ;

    val code = name.lowercase()
}

/**
 * A process as it was last seen.
 *
 * @param grading how many submissions it grades now
 */
data class WorkerSeen(
    val worker: Worker,
    val startedAt: Instant,
    val seenAt: Instant,
    val state: WorkerState,
    val grading: Int,
)

/**
 * Keeps who grades. One that ends as it should takes itself off the list; one that does not stays on it for a day.
 *
 * @param clock which all of them follow
 * @param patience how long one may be silent before its leases run out
 */
class Workers(
    private val database: Database,
    private val clock: InstantSource,
    private val patience: Duration,
) {
    /** Puts one that starts on the list, in the place of an earlier one of its name. */
    fun begin(worker: Worker) {
        val now = clock.instant()
        database.write {
            it
                .createUpdate("DELETE FROM workers WHERE name = :name OR seen_at < :old")
                .bind("name", worker.name)
                .bind("old", (now - KEPT).text())
                .execute()
            it
                .createUpdate(
                    """INSERT INTO workers (name, host, serves, isolation, isolation_data, slots, is_draining, started_at, seen_at)
                       VALUES (:name, :host, :serves, :isolation, :data, :slots, 0, :now, :now)""",
                ).bind("name", worker.name)
                .bind("host", worker.host)
                .bind("serves", if (worker.serves) 1 else 0)
                .bind("isolation", worker.isolation.`in`("en"))
                .bind("data", worker.isolation.data())
                .bind("slots", worker.slots)
                .bind("now", now.text())
                .execute()
        }
    }

    /** Notes that one is still here, and what shuts its sources in now; false where it is not on the list. */
    fun seen(worker: Worker): Boolean =
        database.write {
            it
                .createUpdate(
                    """UPDATE workers SET seen_at = :now, isolation = :isolation, isolation_data = :data
                       WHERE name = :name""",
                ).bind("now", clock.instant().text())
                .bind("name", worker.name)
                .bind("isolation", worker.isolation.`in`("en"))
                .bind("data", worker.isolation.data())
                .execute() == 1
        }

    /** Whether one was asked to take nothing more. */
    fun isDraining(name: String): Boolean =
        database.read {
            it
                .createQuery("SELECT count(*) FROM workers WHERE name = :name AND is_draining = 1")
                .bind("name", name)
                .mapTo(Int::class.javaObjectType)
                .one() > 0
        }

    /**
     * Asks one to take nothing more, or to take work again; where it does so already, nothing is noted.
     *
     * @param by id of the account
     * @throws Rejection.UnknownWorker where none of that name is on the list
     */
    fun drain(
        name: String,
        drains: Boolean,
        by: String,
    ): WorkerSeen {
        database.write { handle ->
            val changed =
                handle
                    .createUpdate(
                        "UPDATE workers SET is_draining = :drains WHERE name = :name AND is_draining <> :drains",
                    ).bind("drains", if (drains) 1 else 0)
                    .bind("name", name)
                    .execute()
            if (changed > 0) {
                val action = if (drains) "worker-drain" else "worker-resume"
                AuditNote(by, course = null, action, name, detail = "").write(handle, clock.instant())
            }
        }
        return all().find { it.worker.name == name } ?: throw Rejection.UnknownWorker(name)
    }

    /** Takes one that ends off the list. */
    fun end(name: String) {
        database.write { it.execute("DELETE FROM workers WHERE name = ?", name) }
    }

    /** All on the list, by name. */
    fun all(): List<WorkerSeen> {
        val lost = (clock.instant() - patience).text()
        return database.read { handle ->
            handle
                .createQuery("SELECT workers.*, $GRADING AS grading FROM workers ORDER BY name")
                .map { row, _ ->
                    WorkerSeen(
                        Worker(
                            row.getString("name"),
                            row.getString("host"),
                            row.getInt("serves") == 1,
                            Message.ofData(row.getString("isolation_data"), row.getString("isolation")),
                            row.getInt("slots"),
                        ),
                        Instant.parse(row.getString("started_at")),
                        Instant.parse(row.getString("seen_at")),
                        when {
                            row.getString("seen_at") < lost -> WorkerState.LOST
                            row.getInt("is_draining") == 1 -> WorkerState.DRAINING
                            else -> WorkerState.TAKING
                        },
                        row.getInt("grading"),
                    )
                }.list()
        }
    }

    private companion object {
        val KEPT: Duration = Duration.ofDays(1)

        /** A lease begins with the name of the one who has it. */
        const val GRADING =
            """((SELECT count(*) FROM submissions WHERE substr(lease, 1, length(workers.name) + 1) = workers.name || ' ')
                + (SELECT count(*) FROM regrade_items WHERE substr(lease, 1, length(workers.name) + 1) = workers.name || ' '))"""
    }
}
