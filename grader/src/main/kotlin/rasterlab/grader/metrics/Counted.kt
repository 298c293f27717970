package rasterlab.grader.metrics

import org.jdbi.v3.core.Handle

/** The numbers of a course that its database has. */
internal class Counted(
    val states: Map<String, Long>,
    val verdicts: Map<String, Long>,
    val oldestSeconds: Long,
) {
    companion object {
        fun of(handle: Handle): Counted {
            val oldest =
                """SELECT 'age', coalesce(max(unixepoch() - unixepoch(received_at)), 0)
                   FROM submissions WHERE state = 'queued'"""
            return Counted(
                handle.numbers("SELECT state, count(*) FROM submissions GROUP BY state"),
                handle.numbers("SELECT verdict, count(*) FROM results GROUP BY verdict"),
                handle.numbers(oldest).values.single(),
            )
        }

        private fun Handle.numbers(sql: String): Map<String, Long> =
            createQuery(sql).map { row, _ -> row.getString(1) to row.getLong(2) }.list().toMap()
    }
}
