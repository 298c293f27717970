package rasterlab.grader.web

import rasterlab.engine.study.measuring.MedianInterval
import rasterlab.engine.study.measuring.PaceComparison
import kotlin.math.ceil
import kotlin.math.floor
import kotlin.math.hypot
import kotlin.math.ln
import kotlin.math.log10
import kotlin.math.pow

/**
 * A method on a chart of speed and accuracy.
 *
 * @param ratio of its time to the reference's, with the interval in which it lies
 * @param error may be infinite
 * @param labelled whether its name stands beside the plot
 */
class ChartPoint(
    val name: String,
    val ratio: MedianInterval,
    val error: Double,
    val own: Boolean,
    val labelled: Boolean = true,
) {
    /** Whether this one is told to be faster and is as accurate: only where the intervals part. */
    fun beats(other: ChartPoint) =
        error <= other.error &&
            ratio.high() < other.ratio.low() &&
            ratio.median() * PaceComparison.LEAST_GAP < other.ratio.median()
}

/** A point's mark, and the row of its name, to which a line leads from the mark. */
class PlacedPoint(
    val point: ChartPoint,
    val x: Double,
    val y: Double,
    val rowY: Double,
)

/** A number of an axis and where it stands. */
class Tick(
    val value: Double,
    val at: Double,
)

/**
 * The places on a chart of speed and accuracy: ratios to the right and errors upwards, both in powers of ten. Points
 * without an error stand in one row of a band at the bottom; those whose error has no end, in one at the top. Names
 * stand in a column beside the plot. Lengths are those of the picture's own units.
 */
class ChartLayout(
    private val points: List<ChartPoint>,
) {
    private val errors = points.map { it.error }.filter { it.isFinite() && it > 0 }
    private val left = points.minOf { it.ratio.low() }.coerceAtMost(LEAST) / MARGIN
    private val most = points.maxOf { it.ratio.high() }.coerceAtLeast(MOST) * MARGIN
    private val low = floor(log10(errors.minOrNull() ?: 1.0) - CLEAR)
    private val high = ceil(log10(errors.maxOrNull() ?: 1.0) + CLEAR).coerceAtLeast(low + 1)

    /** The top of the scale, below the band of points without an end, where there are some. */
    val scaleTop = TOP + if (points.any { it.error.isInfinite() }) BAND else 0.0
    val scaleBottom = scaleTop + if (errors.isEmpty()) 0.0 else SCALE

    /** The lower end of the plot, which has a row for each name. */
    val bottom =
        maxOf(
            scaleBottom + if (points.any { it.error == 0.0 }) BAND else 0.0,
            TOP + points.count { it.labelled } * PlacedRows.ROW,
        )
    val height = bottom + BELOW
    val width = NAMES + (points.filter { it.labelled }.maxOfOrNull { it.nameWidth() } ?: 0.0)

    /** The middle of the band at the top, and of the one at the bottom; null where there is none. */
    val lostAt = ((TOP + scaleTop) / 2).takeIf { scaleTop > TOP }
    val exactAt = ((scaleBottom + bottom) / 2).takeIf { points.any { it.error == 0.0 } }

    val placed: List<PlacedPoint> =
        points
            .map { Triple(it, x(it.ratio.median()), y(it.error)) }
            .partition { it.first.labelled }
            .let { (labelled, others) ->
                others.map { (point, x, y) -> PlacedPoint(point, x, y, y) } + PlacedRows(labelled, bottom).all()
            }

    /** The names of the methods that beat each one, the quickest first. */
    fun beatenBy(point: ChartPoint): List<ChartPoint> = points.filter { it.beats(point) }.sortedBy { it.ratio.median() }

    /** The corners of the front: what nothing beats and has a smaller error than every quicker one of these. */
    val corners: List<PlacedPoint>
        get() {
            val corners = mutableListOf<PlacedPoint>()
            for (one in placed.filter { beatenBy(it.point).isEmpty() }.sortedBy { it.x }) {
                if (corners.isEmpty() || one.point.error < corners.last().point.error) corners += one
            }
            return corners
        }

    fun x(ratio: Double) = LEFT + (RIGHT - LEFT) * ln(ratio / left) / ln(most / left)

    private fun y(error: Double) =
        when {
            error == 0.0 -> (scaleBottom + bottom) / 2
            error.isInfinite() -> (TOP + scaleTop) / 2
            else -> scaleBottom - (scaleBottom - scaleTop) * (log10(error) - low) / (high - low)
        }

    /** The numbers of the axis of ratios: 1, 2 and 5 of each power of ten, or its powers where these are many. */
    val ratioTicks: List<Tick>
        get() {
            val factors = if (log10(most / left) > 2) listOf(1) else listOf(1, 2, 5)
            return (floor(log10(left)).toInt()..ceil(log10(most)).toInt())
                .flatMap { power -> factors.map { it * 10.0.pow(power) } }
                .filter { it in left..most }
                .map { Tick(it, x(it)) }
        }

    /** The powers of ten of the axis of errors, at most a handful. */
    val errorTicks: List<Tick>
        get() {
            if (errors.isEmpty()) return emptyList()
            val step = ceil((high - low) / MOST_ERRORS).toInt()
            return (low.toInt()..high.toInt() step step).map { Tick(10.0.pow(it), y(10.0.pow(it))) }
        }

    companion object {
        const val LEFT = 64.0

        /** The right end of the plot. */
        const val RIGHT = 280.0
        const val TOP = 24.0

        /** Where the column of names begins. */
        const val NAMES = RIGHT + 24.0
        private const val BAND = 36.0
        private const val SCALE = 120.0
        private const val BELOW = 38.0

        /** Decades between the outermost errors and the ends of their axis, at least. */
        private const val CLEAR = 0.25

        /** Ratios that always have a place, so that the reference and the full points are seen. */
        private const val LEAST = 0.8
        private const val MOST = 2.0
        private const val MARGIN = 1.15
        private const val MOST_ERRORS = 4
    }
}

/**
 * Rows of names beside a plot, of whose lines no two cross: two that crossed would be longer than if they changed their
 * ends, so ends are changed while that makes both together shorter. Source: M. A. Bekos and others, Boundary Labeling,
 * Computational Geometry 36(3), 2007, section 3.
 */
private class PlacedRows(
    marks: List<Triple<ChartPoint, Double, Double>>,
    private val bottom: Double,
) {
    private val marks = marks.sortedBy { it.third }

    fun all(): List<PlacedPoint> {
        val rows = spread().toMutableList()
        var better = true
        while (better) {
            better = false
            for (i in rows.indices) for (j in 0 until i) better = changed(rows, i, j) || better
        }
        return marks.mapIndexed { number, (point, x, y) -> PlacedPoint(point, x, y, rows[number]) }
    }

    private fun changed(
        rows: MutableList<Double>,
        i: Int,
        j: Int,
    ): Boolean {
        val now = length(i, rows[i]) + length(j, rows[j])
        if (length(i, rows[j]) + length(j, rows[i]) >= now - SHORT) return false
        rows[i] = rows[j].also { rows[j] = rows[i] }
        return true
    }

    private fun length(
        mark: Int,
        row: Double,
    ) = hypot(ChartLayout.NAMES - marks[mark].second, row - marks[mark].third)

    /** Heights as near to the marks' own as rows allow that do not overlap. */
    private fun spread(): List<Double> {
        val rows = marks.map { it.third }.toMutableList()
        var least = ChartLayout.TOP + ROW / 2
        for (i in rows.indices) {
            rows[i] = maxOf(rows[i], least)
            least = rows[i] + ROW
        }
        var most = bottom - ROW / 2
        for (i in rows.indices.reversed()) {
            rows[i] = minOf(rows[i], most)
            most = rows[i] - ROW
        }
        return rows
    }

    companion object {
        /** The height of a row. */
        const val ROW = 15.0
        private const val SHORT = 1e-9
    }
}

/** A width above that of any letter of a name. */
private const val LETTER = 6.8

/** The widening of the own name, which is bold, and in Russian wider than names of methods. */
private const val BOLD = 1.25

private fun ChartPoint.nameWidth() = name.length * if (own) LETTER * BOLD else LETTER
