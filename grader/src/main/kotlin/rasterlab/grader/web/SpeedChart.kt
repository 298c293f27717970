package rasterlab.grader.web

import kotlinx.html.FlowContent
import kotlinx.html.ThScope
import kotlinx.html.details
import kotlinx.html.figcaption
import kotlinx.html.figure
import kotlinx.html.h2
import kotlinx.html.section
import kotlinx.html.summary
import kotlinx.html.table
import kotlinx.html.tbody
import kotlinx.html.td
import kotlinx.html.th
import kotlinx.html.thead
import kotlinx.html.tr
import kotlinx.html.unsafe
import rasterlab.exercises.published.PublishedSpeed
import java.util.Locale
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.floor
import kotlin.math.log10
import kotlin.math.roundToInt
import kotlin.math.sin

/**
 * A student's point on the topic's chart of speed and accuracy, the topic's methods beside it: as SVG within the page,
 * which takes its colours, and as a table for whoever does not see it.
 */
fun FlowContent.speedChart(
    texts: PageTexts,
    speed: PublishedSpeed,
) = section("speed") {
    val figures = speed.figures
    val own = ChartPoint(texts.say("chart.own"), figures.ratio(), figures.error(), own = true)
    val methods = figures.methods().map { ChartPoint(it.name(), it.ratio(), it.error(), own = false) }
    val scale = ChartScale(speed.item, speed.errorUnit, speed.fullUpTo)
    val drawn = SpeedDrawing(texts, scale, listOf(own) + methods) { it.inWords(own) }
    h2 { +texts.say("chart.title") }
    figure("chart") {
        unsafe { +drawn.svg() }
        figcaption { +texts.say("chart.caption", drawn.number(speed.fullUpTo)) }
    }
    details {
        summary { +texts.say("chart.table") }
        scrolling(texts.say("chart.table")) { figures(texts, drawn) }
    }
}

private fun FlowContent.figures(
    texts: PageTexts,
    drawn: SpeedDrawing,
) = table {
    thead {
        tr {
            th(scope = ThScope.col) { +texts.say("chart.method") }
            th(scope = ThScope.col, classes = "number") { +texts.say("chart.ratio") }
            th(scope = ThScope.col, classes = "number") { +drawn.errorAxis }
            th(scope = ThScope.col) { +texts.say("chart.beaten") }
        }
    }
    tbody {
        drawn.points.forEach { point ->
            tr {
                td { +point.name }
                td("number") { +drawn.ratio(point) }
                td("number") { +drawn.error(point) }
                td { +drawn.beatenBy(point) }
            }
        }
    }
}

/**
 * The units of a chart of speed.
 *
 * @param item what the times are per, in English
 * @param errorUnit in English
 * @param fullUpTo the largest ratio that earns all points
 */
class ChartScale(
    val item: String,
    val errorUnit: String,
    val fullUpTo: Double,
)

/**
 * The words and the drawing of a chart of speed, in one language.
 *
 * @param points at least one
 * @param told the chart in words, for whoever does not see it
 */
internal class SpeedDrawing(
    private val texts: PageTexts,
    private val scale: ChartScale,
    val points: List<ChartPoint>,
    private val told: (SpeedDrawing) -> String,
) {
    private val locale = Locale.forLanguageTag(texts.language)
    val errorAxis = texts.say("chart.error", texts.unit(scale.errorUnit))
    private val layout = ChartLayout(points)

    /** The ratio with its interval, where that is known. */
    fun ratio(point: ChartPoint): String {
        val median = number(point.ratio.median())
        val known = point.ratio.low() < point.ratio.high()
        return if (known) "$median (${number(point.ratio.low())}–${number(point.ratio.high())})" else median
    }

    /** The methods that are told to be faster and are as accurate. */
    fun beatenBy(point: ChartPoint) = layout.beatenBy(point).joinToString(", ") { it.name }

    /** The number with three digits that count. */
    fun number(value: Double): String {
        if (value == 0.0) return "0"
        val power = floor(log10(value)).toInt()
        if (power !in LEAST_POWER..MOST_POWER) {
            val factor = String.format(locale, "%.1f", value / powerOfTen(power)).removeSuffix(".0").removeSuffix(",0")
            return (if (factor == "1") "" else "$factor·") + "10${superscript(power)}"
        }
        val decimals = (2 - power).coerceIn(0, MOST_DECIMALS)
        val said = String.format(locale, "%.${decimals}f", value)
        return if (decimals == 0) said else said.trimEnd('0').trimEnd('.', ',')
    }

    fun error(point: ChartPoint) = if (point.error.isInfinite()) texts.say("chart.lost") else number(point.error)

    fun svg(): String =
        buildString {
            val size = "0 0 ${layout.width.roundToInt()} ${layout.height.roundToInt()}"
            append("""<svg viewBox="$size" role="img" aria-label="${escaped(told(this@SpeedDrawing))}">""")
            plot()
            axes()
            staircase()
            layout.placed.forEach { mark(it) }
            append("</svg>")
        }

    /** Tells the point of a student, and the others. */
    fun inWords(own: ChartPoint) =
        texts.say("chart.words", number(own.ratio.median()), error(own)) + " " +
            layout.placed
                .filterNot { it.point.own }
                .sortedBy { it.point.ratio.median() }
                .joinToString("; ") { "${it.point.name}: ${number(it.point.ratio.median())}, ${error(it.point)}" }

    private fun StringBuilder.plot() {
        val top = ChartLayout.TOP
        val high = layout.bottom - top
        rect("sheet", ChartLayout.LEFT, top, ChartLayout.RIGHT - ChartLayout.LEFT, high)
        layout.exactAt?.let {
            val from = layout.scaleBottom
            rect("exact", ChartLayout.LEFT, from, ChartLayout.RIGHT - ChartLayout.LEFT, layout.bottom - from)
        }
        val full = layout.x(scale.fullUpTo)
        rect("full", ChartLayout.LEFT, top, full - ChartLayout.LEFT, high)
        val reference = layout.x(1.0)
        line("reference", reference, top, reference, layout.bottom)
        for (edge in listOf(layout.scaleTop, layout.scaleBottom).filter { it > top && it < layout.bottom }) {
            line("edge", ChartLayout.LEFT, edge, ChartLayout.RIGHT, edge)
        }
    }

    private fun StringBuilder.axes() {
        text("start", 2.0, AXIS_TITLE, errorAxis)
        val besides = ChartLayout.LEFT - BESIDE
        layout.lostAt?.let { text("end", besides, it + BASELINE, texts.say("chart.lost")) }
        layout.exactAt?.let { text("end", besides, it + BASELINE, texts.say("chart.exact")) }
        for (tick in layout.errorTicks) text("end", besides, tick.at + BASELINE, number(tick.value))
        for (tick in layout.ratioTicks) {
            line("edge", tick.at, layout.bottom, tick.at, layout.bottom + BASELINE)
            text("middle", tick.at, layout.bottom + UNDER, number(tick.value))
        }
        val middle = (ChartLayout.LEFT + ChartLayout.RIGHT) / 2
        text("middle", middle, layout.height - BASELINE, texts.say("chart.cost", texts.item(scale.item)))
    }

    /** The steps from the quickest corner down to the most accurate one and to the right. */
    private fun StringBuilder.staircase() {
        var x = layout.corners.first().x
        var y = ChartLayout.TOP
        val path = StringBuilder("M${x.short()},${y.short()}")
        for (corner in layout.corners) {
            x = corner.x
            y = corner.y
            path.append("H${x.short()}V${y.short()}")
        }
        path.append("H${ChartLayout.RIGHT.short()}")
        append("<path class=\"front\" d=\"$path\"/>")
    }

    private fun StringBuilder.mark(placed: PlacedPoint) {
        val kind = if (placed.point.own) "own" else "other"
        val pale = if (layout.beatenBy(placed.point).isEmpty()) "" else " beaten"
        append("<g class=\"$kind$pale\">")
        if (placed.point.labelled) {
            line("leader", placed.x, placed.y, ChartLayout.NAMES - BESIDE / 2, placed.rowY)
            text("start", ChartLayout.NAMES, placed.rowY + BASELINE, placed.point.name)
        }
        val low = layout.x(placed.point.ratio.low())
        val high = layout.x(placed.point.ratio.high())
        line("bar", low, placed.y, high, placed.y)
        for (end in listOf(low, high)) line("bar", end, placed.y - BAR, end, placed.y + BAR)
        if (placed.point.own) {
            append("<path d=\"${star(placed.x, placed.y)}\"/>")
        } else {
            append("<circle cx=\"${placed.x.short()}\" cy=\"${placed.y.short()}\" r=\"4.5\"/>")
        }
        append("</g>")
    }

    private fun StringBuilder.rect(
        kind: String,
        x: Double,
        y: Double,
        width: Double,
        height: Double,
    ) = append(
        """<rect class="$kind" x="${x.short()}" y="${y.short()}" width="${width.short()}" height="${height.short()}"/>""",
    )

    private fun StringBuilder.line(
        kind: String,
        x1: Double,
        y1: Double,
        x2: Double,
        y2: Double,
    ) = append("""<line class="$kind" x1="${x1.short()}" y1="${y1.short()}" x2="${x2.short()}" y2="${y2.short()}"/>""")

    private fun StringBuilder.text(
        anchor: String,
        x: Double,
        y: Double,
        said: String,
    ) = append("""<text class="$anchor" x="${x.short()}" y="${y.short()}">${escaped(said)}</text>""")

    private companion object {
        const val BASELINE = 4.0
        const val BESIDE = 6.0
        const val BAR = 3.0
        const val UNDER = 15.0
        const val AXIS_TITLE = 14.0
        const val LEAST_POWER = -3
        const val MOST_POWER = 4
        const val MOST_DECIMALS = 5
    }
}

private const val STAR_OUT = 8.0
private const val STAR_IN = 3.4
private const val STAR_CORNERS = 10

/** A star with five rays, the first of them upwards. */
private fun star(
    x: Double,
    y: Double,
) = (0 until STAR_CORNERS).joinToString(" ", "M", "Z") { corner ->
    val radius = if (corner % 2 == 0) STAR_OUT else STAR_IN
    val angle = 2 * PI * corner / STAR_CORNERS
    "${(x + radius * sin(angle)).short()},${(y - radius * cos(angle)).short()}"
}

private fun Double.short() = String.format(Locale.ROOT, "%.1f", this).removeSuffix(".0")

private fun powerOfTen(power: Int) = Math.pow(10.0, power.toDouble())

private fun superscript(power: Int) = power.toString().map { SUPERSCRIPTS.getValue(it) }.joinToString("")

private val SUPERSCRIPTS = "-0123456789".zip("⁻⁰¹²³⁴⁵⁶⁷⁸⁹").toMap()

private fun escaped(text: String) =
    text
        .replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("\"", "&quot;")
