package rasterlab.grader.web

import kotlin.math.abs
import kotlin.math.ceil
import kotlin.math.floor
import kotlin.math.ln
import kotlin.math.log10
import kotlin.math.pow

/**
 * A method on a chart of speed and accuracy.
 *
 * @param error may be infinite
 */
class ChartPoint(
    val name: String,
    val ratio: Double,
    val error: Double,
    val own: Boolean,
)

/** A point's mark and the place of its name, whose baseline is at [textY]. */
class PlacedPoint(
    val point: ChartPoint,
    val x: Double,
    val y: Double,
    val textX: Double,
    val textY: Double,
    val before: Boolean,
) {
    /** From the left to the right of the name, as wide as it can be. */
    val text: ClosedFloatingPointRange<Double> =
        if (before) textX - width(point.name)..textX else textX..textX + width(point.name)
}

/** A number of an axis and where it stands. */
class Tick(
    val value: Double,
    val at: Double,
)

/**
 * The places on a chart of speed and accuracy: ratios to the right and errors upwards, both in powers of ten. Points
 * without an error stand in lanes of their own at the bottom, since they would hide each other on one line; those whose
 * error has no end, in lanes at the top. Lengths are those of the picture's own units.
 */
class ChartLayout(
    points: List<ChartPoint>,
) {
    private val lost = points.filter { it.error.isInfinite() }
    private val erring = points.filter { it.error.isFinite() && it.error > 0 }.sortedByDescending { it.error }
    private val exact = points.filter { it.error == 0.0 }.sortedBy { it.ratio }
    private val left = points.minOf { it.ratio }.coerceAtMost(LEAST) / MARGIN
    private val right = points.maxOf { it.ratio }.coerceAtLeast(MOST) * MARGIN
    private val low = floor(log10(erring.lastOrNull()?.error ?: 1.0))
    private val high = ceil(log10(erring.firstOrNull()?.error ?: 1.0)).coerceAtLeast(low + 1)

    /** Below the lanes of points without an end, where there are some. */
    val scaleTop = TOP + lost.size * LANE
    val scaleBottom = scaleTop + if (erring.isEmpty()) 0.0 else SCALE

    /** The lower end of the plot. */
    val bottom = scaleBottom + (exact.size * LANE).coerceAtLeast(LANE)
    val height = bottom + BELOW

    /** In the middle of the lanes at the top; null where there is none. */
    val lostAt = (TOP + lost.size * LANE / 2).takeIf { lost.isNotEmpty() }
    val exactAt = (scaleBottom + bottom) / 2

    val placed: List<PlacedPoint> =
        lanes(lost, TOP) + lanes(exact, scaleBottom) + spread(erring)

    fun x(ratio: Double) = LEFT + (WIDTH - LEFT - RIGHT) * ln(ratio / left) / ln(right / left)

    private fun y(error: Double) = scaleBottom - SCALE * (log10(error) - low) / (high - low)

    /** The numbers of the axis of ratios: 1, 2 and 5 of each power of ten, or its powers where these are many. */
    val ratios: List<Tick>
        get() {
            val factors = if (log10(right / left) > 2) listOf(1) else listOf(1, 2, 5)
            return (floor(log10(left)).toInt()..ceil(log10(right)).toInt())
                .flatMap { power -> factors.map { it * 10.0.pow(power) } }
                .filter { it in left..right }
                .map { Tick(it, x(it)) }
        }

    /** The powers of ten of the axis of errors, at most a handful. */
    val errors: List<Tick>
        get() {
            if (erring.isEmpty()) return emptyList()
            val step = ceil((high - low) / MOST_ERRORS).toInt()
            return (low.toInt()..high.toInt() step step).map { Tick(10.0.pow(it), y(10.0.pow(it))) }
        }

    private fun lanes(
        points: List<ChartPoint>,
        top: Double,
    ) = points.mapIndexed { lane, point -> named(point, top + (lane + HALF) * LANE, rise = 0.0) }

    private fun named(
        point: ChartPoint,
        y: Double,
        rise: Double,
    ): PlacedPoint {
        val x = x(point.ratio)
        val before = x + AWAY + width(point.name) > WIDTH
        return PlacedPoint(point, x, y, if (before) x - AWAY else x + AWAY, y + BASELINE + rise, before)
    }

    /** Names of points with nearly the same error stand above each other. */
    private fun spread(points: List<ChartPoint>): List<PlacedPoint> {
        val placed = mutableListOf<PlacedPoint>()
        for (point in points) {
            val y = y(point.error)
            placed +=
                RISES.map { named(point, y, it) }.firstOrNull { one -> placed.none { meets(one, it) } }
                    ?: named(point, y, RISES.last())
        }
        return placed
    }

    private fun meets(
        one: PlacedPoint,
        other: PlacedPoint,
    ): Boolean {
        val apart = one.text.start > other.text.endInclusive || other.text.start > one.text.endInclusive
        return !apart && abs(one.textY - other.textY) < LINE
    }

    companion object {
        const val WIDTH = 360.0
        const val LEFT = 64.0
        const val RIGHT = 12.0
        const val TOP = 24.0
        private const val LANE = 20.0
        private const val SCALE = 120.0
        private const val BELOW = 38.0
        private const val HALF = 0.5

        /** From a mark to its name. */
        private const val AWAY = 10.0

        /** From the middle of letters to the line that they stand on. */
        private const val BASELINE = 4.0

        /** From the line of one name to that of the next. */
        private const val LINE = 14.0
        private val RISES = listOf(0.0, -14.0, 14.0, -28.0, 28.0, -42.0, 42.0, -56.0, 56.0)

        /** Ratios that always have a place, so that the reference and the full points are seen. */
        private const val LEAST = 0.8
        private const val MOST = 2.0
        private const val MARGIN = 1.15
        private const val MOST_ERRORS = 4
    }
}

/** More than any letter of a name takes. */
private const val LETTER = 6.8

private fun width(text: String) = text.length * LETTER
