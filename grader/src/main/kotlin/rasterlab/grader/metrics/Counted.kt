package rasterlab.grader.metrics

import org.jdbi.v3.core.Handle
import java.time.Duration
import java.time.Instant

/** The numbers of a course that its database has. */
internal class Counted(
    val states: Map<String, Long>,
    val verdicts: Map<String, Long>,
    val oldestSeconds: Long,
) {
    companion object {
        fun of(
            handle: Handle,
            now: Instant,
        ): Counted =
            Counted(
                handle.numbers("SELECT state, count(*) FROM submissions GROUP BY state"),
                handle.numbers(
                    """SELECT verdict, count(*) FROM results
                       WHERE NOT EXISTS (SELECT 1 FROM trials WHERE result_id = results.id) GROUP BY verdict""",
                ),
                waited(handle, now),
            )

        /** How many seconds the oldest of what waits has waited. */
        private fun waited(
            handle: Handle,
            now: Instant,
        ): Long {
            val since =
                handle
                    .createQuery("SELECT min(received_at) FROM submissions WHERE state = 'queued'")
                    .mapTo(String::class.java)
                    .one()
            return if (since == null) 0 else Duration.between(Instant.parse(since), now).seconds
        }

        private fun Handle.numbers(sql: String): Map<String, Long> =
            createQuery(sql).map { row, _ -> row.getString(1) to row.getLong(2) }.list().toMap()
    }
}
