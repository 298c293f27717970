package rasterlab.grader.submission

import org.jdbi.v3.core.Handle
import rasterlab.exercises.score.SpeedFigures
import java.sql.ResultSet

/** The figures of one report's speed. */
internal class SpeedRows(
    private val handle: Handle,
    private val result: String,
) {
    /** Puts them in the place of those of before. */
    fun replace(figures: SpeedFigures?) {
        handle
            .createUpdate("DELETE FROM speed_methods WHERE result_id = :result")
            .bind("result", result)
            .execute()
        handle
            .createUpdate(
                """UPDATE results SET reference_nanos = :reference, error = :error WHERE id = :result""",
            ).bind("result", result)
            .bind("reference", figures?.reference())
            .bind("error", figures?.error()?.stored())
            .execute()
        figures?.methods()?.forEachIndexed { position, method -> insert(position, method) }
    }

    private fun insert(
        position: Int,
        method: SpeedFigures.Method,
    ) {
        handle
            .createUpdate(
                """INSERT INTO speed_methods (result_id, position, method, ratio, error)
                   VALUES (:result, :position, :method, :ratio, :error)""",
            ).bind("result", result)
            .bind("position", position)
            .bind("method", method.name())
            .bind("ratio", method.ratio().median())
            .bind("error", method.error().stored())
            .execute()
    }

    /**
     * The figures of a report, or null where it has none.
     *
     * @param result its row in `results`
     */
    fun of(result: ResultSet): SpeedFigures? {
        val nanos = result.getDouble("nanos_per_item")
        val reference = result.getDouble("reference_nanos")
        if (reference == 0.0 || nanos == 0.0) return null
        return SpeedFigures(nanos, reference, result.error(), methods())
    }

    private fun methods(): List<SpeedFigures.Method> =
        handle
            .createQuery(
                "SELECT * FROM speed_methods WHERE result_id = :result ORDER BY position",
            ).bind("result", result)
            .map { row, _ -> SpeedFigures.Method(row.getString("method"), row.getDouble("ratio"), row.error()) }
            .list()

    private fun Double.stored(): Double? = takeIf { it.isFinite() }

    private fun ResultSet.error(): Double = getDouble("error").takeUnless { wasNull() } ?: Double.POSITIVE_INFINITY
}
