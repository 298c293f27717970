package rasterlab.grader.classroom

import rasterlab.engine.raster.PixelMark
import rasterlab.engine.raster.PixelWindow
import kotlin.math.sqrt

/**
 * Pictures of differences laid over each other: for how many students each pixel is missing, or there in excess.
 * x grows right, y grows down.
 */
class DifferenceSum(
    private val differences: List<DrawnDifference>,
) {
    private class Pixel {
        var right = 0
        var missing = 0
        var extra = 0
        val wrong get() = missing + extra
    }

    private val pixels = HashMap<Pair<Int, Int>, Pixel>()
    private val worst: Map.Entry<Pair<Int, Int>, Pixel>?

    init {
        differences.forEach { add(it) }
        worst =
            pixels.entries
                .filter { it.value.wrong > 0 }
                .minWithOrNull(compareBy({ -it.value.wrong }, { it.key.second }, { it.key.first }))
    }

    /** Whether there is a wrong pixel to show. */
    val isEmpty get() = worst == null

    private fun add(one: DrawnDifference) {
        val shown = one.part.shown
        one.rows.forEachIndexed { row, signs ->
            signs.forEachIndexed { column, sign ->
                if (sign != NOTHING) count(sign, pixels.getOrPut(shown.xmin + column to shown.ymin + row) { Pixel() })
            }
        }
    }

    private fun count(
        sign: Char,
        pixel: Pixel,
    ) {
        if (sign == '-') pixel.missing++
        if (sign == '+' || sign == AGAIN) pixel.extra++
        if (sign == '#' || sign == AGAIN) pixel.right++
    }

    /** The pixel that most have wrong, in words of [said]: x, y, missing for how many, in excess for how many. */
    fun inWords(said: (Int, Int, Int, Int) -> String): String =
        worst?.let { (at, pixel) -> said(at.first, at.second, pixel.missing, pixel.extra) }.orEmpty()

    /**
     * The picture as SVG for white paper: grey squares are right, a ring is missing and a cross in excess, in the color of
     * wrong pixels everywhere, the larger the more students have it. It has at most [MOST_COLUMNS] × [MOST_ROWS] pixels,
     * around the one that most have wrong.
     */
    fun svg(): String {
        val part = part()
        return buildString {
            val (width, height) = part.width() * CELL to part.height() * CELL
            append("""<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 $width $height" """)
            append("""width="$width" height="$height"><rect width="$width" height="$height" fill="#fff"/>""")
            for ((at, pixel) in pixels.entries.sortedWith(compareBy({ it.key.second }, { it.key.first }))) {
                if (part.contains(at.first, at.second)) draw(at.first - part.xmin, at.second - part.ymin, pixel)
            }
            append("</svg>")
        }
    }

    private fun part(): PixelWindow {
        val all = pixels.keys
        val whole =
            PixelWindow(
                all.minOf { it.first },
                all.minOf { it.second },
                all.maxOf { it.first },
                all.maxOf { it.second },
            )
        val (x, y) = checkNotNull(worst) { "nothing differs" }.key
        return whole.around(x, y, MOST_COLUMNS, MOST_ROWS)
    }

    private fun StringBuilder.draw(
        column: Int,
        row: Int,
        pixel: Pixel,
    ) {
        val x = column * CELL + CELL / 2
        val y = row * CELL + CELL / 2
        if (pixel.right + pixel.missing > 0) {
            val side = CELL - 2
            append("""<rect x="${x - side / 2}" y="${y - side / 2}" width="$side" height="$side" fill="#d9dde3"/>""")
        }
        if (pixel.missing > 0) {
            append(
                """<circle cx="$x" cy="$y" r="${radius(
                    pixel.missing,
                )}" fill="none" stroke="$WRONG" stroke-width="2"/>""",
            )
        }
        if (pixel.extra > 0) {
            val r = radius(pixel.extra)
            append("""<path d="M${x - r} ${y - r}L${x + r} ${y + r}M${x - r} ${y + r}L${x + r} ${y - r}" """)
            append("""stroke="$WRONG" stroke-width="2"/>""")
        }
    }

    /** Half the size of a mark, whose area grows with the share of students. */
    private fun radius(count: Int) =
        SMALL + ((CELL / 2 - 2 - SMALL) * sqrt(count.toDouble() / differences.size)).toInt()

    private companion object {
        const val NOTHING = '.'

        /** The color of marks, which nothing else has. */
        val WRONG = "#%06x".format(PixelMark.ARGB and 0xFFFFFF)

        /** A right pixel that is drawn again. */
        const val AGAIN = '*'

        /** Units of the picture for one pixel. */
        const val CELL = 16
        const val SMALL = 2
        const val MOST_COLUMNS = 80
        const val MOST_ROWS = 60
    }
}
