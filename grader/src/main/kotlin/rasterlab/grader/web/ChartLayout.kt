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
    /** The range from the left to the right of the name, as wide as it can be. */
    val text: ClosedFloatingPointRange<Double> =
        if (before) textX - width(point.name)..textX else textX..textX + width(point.name)

    /** Whether the name stands above or below its mark, so that a line has to lead to it. */
    val led = abs(textY - BASELINE - y) > 1

    /** Whether the names of both would touch. */
    fun meets(other: PlacedPoint) =
        text.start <= other.text.endInclusive &&
            other.text.start <= text.endInclusive &&
            abs(textY - other.textY) < LINE

    /** Whether the name would touch a mark at that place. */
    fun hides(
        markX: Double,
        markY: Double,
    ) = markX in text.start - MARK..text.endInclusive + MARK && abs(textY - BASELINE - markY) < LINE / 2 + MARK - 1

    companion object {
        /** The distance from the middle of letters to the line that they stand on. */
        const val BASELINE = 4.0

        /** The distance from the line of one name to that of the next. */
        const val LINE = 14.0

        /** Half the width of a mark. */
        private const val MARK = 5.0
    }
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
    private val low = floor(log10(erring.lastOrNull()?.error ?: 1.0) - CLEAR)
    private val high = ceil(log10(erring.firstOrNull()?.error ?: 1.0) + CLEAR).coerceAtLeast(low + 1)

    /** The top of the scale, below the lanes of points without an end, where there are some. */
    val scaleTop = TOP + lost.size * LANE
    val scaleBottom = scaleTop + if (erring.isEmpty()) 0.0 else SCALE

    /** The lower end of the plot. */
    val bottom = scaleBottom + exact.size * LANE
    val height = bottom + BELOW

    /** The middle of the lanes at the top, and of those at the bottom; null where there is none. */
    val lostAt = (TOP + lost.size * LANE / 2).takeIf { lost.isNotEmpty() }
    val exactAt = ((scaleBottom + bottom) / 2).takeIf { exact.isNotEmpty() }

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
    ) = points.mapIndexed { lane, point ->
        val before = x(point.ratio) + AWAY + width(point.name) > WIDTH
        named(point, top + (lane + HALF) * LANE, rise = 0.0, before)
    }

    private fun named(
        point: ChartPoint,
        y: Double,
        rise: Double,
        before: Boolean,
    ): PlacedPoint {
        val x = x(point.ratio)
        val textX = if (before) x - AWAY else x + AWAY
        return PlacedPoint(point, x, y, textX, y + PlacedPoint.BASELINE + rise, before)
    }

    /** Names beside their marks, or above or below them where they would touch another name or mark. */
    private fun spread(points: List<ChartPoint>): List<PlacedPoint> {
        val placed = mutableListOf<PlacedPoint>()
        for (point in points) {
            val y = y(point.error)
            val spots =
                RISES
                    .flatMap { rise -> listOf(false, true).map { named(point, y, rise, it) } }
                    .filter { it.text.start >= LEFT && it.text.endInclusive <= WIDTH }
            placed +=
                spots.firstOrNull { spot -> isFree(spot, placed, points) }
                    ?: spots.firstOrNull { spot -> placed.none(spot::meets) }
                    ?: named(point, y, rise = 0.0, x(point.ratio) > WIDTH / 2)
        }
        return placed
    }

    private fun isFree(
        spot: PlacedPoint,
        placed: List<PlacedPoint>,
        points: List<ChartPoint>,
    ): Boolean {
        val edge = HALF * PlacedPoint.LINE
        return spot.textY - PlacedPoint.BASELINE in scaleTop + edge..scaleBottom - edge &&
            placed.none(spot::meets) &&
            points.none { it !== spot.point && spot.hides(x(it.ratio), y(it.error)) }
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

        /** The distance from a mark to its name. */
        private const val AWAY = 10.0

        /** Decades between the outermost errors and the ends of their axis, at least. */
        private const val CLEAR = 0.25
        private val RISES = listOf(0.0, -14.0, 14.0, -28.0, 28.0, -42.0, 42.0, -56.0, 56.0)

        /** Ratios that always have a place, so that the reference and the full points are seen. */
        private const val LEAST = 0.8
        private const val MOST = 2.0
        private const val MARGIN = 1.15
        private const val MOST_ERRORS = 4
    }
}

/** A width above that of any letter of a name. */
private const val LETTER = 6.8

private fun width(text: String) = text.length * LETTER
