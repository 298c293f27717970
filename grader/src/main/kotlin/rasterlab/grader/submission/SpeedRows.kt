package rasterlab.grader.submission

import org.jdbi.v3.core.Handle
import rasterlab.engine.study.measuring.MedianInterval
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
                """UPDATE results
                   SET reference_nanos = :reference, error = :error, ratio_low = :low, ratio_high = :high
                   WHERE id = :result""",
            ).bind("result", result)
            .bind("reference", figures?.reference())
            .bind("error", figures?.error()?.stored())
            .bind("low", figures?.ratio()?.low())
            .bind("high", figures?.ratio()?.high())
            .execute()
        figures?.methods()?.forEachIndexed { position, method -> insert(position, method) }
    }

    private fun insert(
        position: Int,
        method: SpeedFigures.MethodSpeed,
    ) {
        handle
            .createUpdate(
                """INSERT INTO speed_methods (result_id, position, method, ratio, ratio_low, ratio_high, error)
                   VALUES (:result, :position, :method, :ratio, :low, :high, :error)""",
            ).bind("result", result)
            .bind("position", position)
            .bind("method", method.name())
            .bind("ratio", method.ratio().median())
            .bind("low", method.ratio().low())
            .bind("high", method.ratio().high())
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
        return SpeedFigures(result.around(nanos / reference), reference, result.error(), methods())
    }

    private fun methods(): List<SpeedFigures.MethodSpeed> =
        handle
            .createQuery(
                "SELECT * FROM speed_methods WHERE result_id = :result ORDER BY position",
            ).bind("result", result)
            .map { row, _ -> method(row) }
            .list()

    private fun method(row: ResultSet) =
        SpeedFigures.MethodSpeed(row.getString("method"), row.around(row.getDouble("ratio")), row.error())

    private fun Double.stored(): Double? = takeIf { it.isFinite() }
}

/** The ratio with the interval of its row; what was measured before there were intervals has none. */
internal fun ResultSet.around(ratio: Double): MedianInterval {
    val low = getDouble("ratio_low")
    val high = getDouble("ratio_high")
    if (low == 0.0) return MedianInterval.exact(ratio)
    // nanoseconds over the reference's may be off by a last digit from what was measured
    return MedianInterval(minOf(low, ratio), ratio, maxOf(high, ratio))
}

/** The error of its row, which has none where it is infinite. */
internal fun ResultSet.error(): Double = getDouble("error").takeUnless { wasNull() } ?: Double.POSITIVE_INFINITY
