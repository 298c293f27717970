package rasterlab.grader.web

import kotlinx.html.div
import kotlinx.html.stream.createHTML
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource
import rasterlab.engine.study.measuring.MedianInterval
import rasterlab.exercises.published.PublishedSpeed
import rasterlab.exercises.score.SpeedFigures
import java.awt.geom.Line2D

/** A student's star among the methods of a topic, for eyes and for ears. */
class SpeedChartTest {
    private fun page(
        figures: SpeedFigures,
        language: String,
        topic: String = "line",
    ) = createHTML(prettyPrint = false).div { speedChart(PageTexts.of(language), PublishedSpeed.of(topic, figures)) }

    @Test
    @DisplayName("the star or a method is missing, or stands where another one does")
    fun fasterStandsFurtherLeftAndLessExactFurtherUp() {
        val html = page(SpeedFigures(3.0, 2.0, 0.0, methods(0.5 to 0.25, 4.0 to INFINITE)), "en")
        val circles = Regex("""<circle cx="([\d.]+)" cy="([\d.]+)"""").findAll(html).map { numbers(it) }.toList()
        val star = numbers(checkNotNull(Regex("""<path d="M([\d.]+),([\d.]+)""").find(html)))
        val (lost, erring) = circles
        assertEquals(2, circles.size)
        assertTrue(erring.first() < star.first() && star.first() < lost.first(), "$circles $star")
        assertTrue(lost.last() < erring.last() && erring.last() < star.last(), "$circles $star")
        for (name in listOf("your method", "method-0", "method-1")) {
            assertTrue(""">$name</text>""" in html, "no $name in $html")
        }
    }

    private fun numbers(found: MatchResult) = found.groupValues.drop(1).map { it.toDouble() }

    @Test
    @DisplayName("a reader who does not see the chart is not told the numbers, or told them in the wrong form")
    fun chartIsToldInWords() {
        val figures = SpeedFigures(2.25, 2.0, 0.5, methods(12.5 to 0.0, 4.0 to INFINITE))
        val english = page(figures, "en")
        val said =
            "Chart of time and error. Your method takes 1.13 times the time of the reference; " +
                "its largest error: 0.5. Others, by time and error: method-1: 4, missing; method-0: 12.5, 0"
        assertTrue("""role="img" aria-label="$said"""" in english, english)
        assertTrue(
            """<tr><td>method-0</td><td class="number">12.5</td><td class="number">0</td><td></td></tr>""" in english,
            english,
        )
        val russian = page(figures, "ru")
        assertTrue("Время вашего метода относительно эталона: 1,13; его наибольшая ошибка: 0,5." in russian, russian)
        assertTrue("время на пиксель, эталон = 1" in russian, russian)
        assertTrue("до 1,5 от эталонного" in russian, russian)
    }

    @ParameterizedTest(name = "names of methods touch each other, or their lines cross, at an error of {0}")
    @ValueSource(doubles = [0.0, 1e-16, 0.5, INFINITE])
    fun namesAreApart(error: Double) {
        val points =
            listOf(0.02, 0.98, 1.0, 1.3, 1.7, 40.0).mapIndexed { number, ratio ->
                ChartPoint("long-method-$number", MedianInterval.exact(ratio), error, own = number == 0)
            }
        val layout = ChartLayout(points)
        val placed = layout.placed
        assertEquals(points.size, placed.size)
        assertTrue(placed.all { it.rowY in ChartLayout.TOP..layout.bottom })
        assertEquals(1, placed.map { it.y }.distinct().size, "one row for all without an order")
        for ((number, one) in placed.withIndex()) {
            for (other in placed.drop(number + 1)) {
                assertTrue(Math.abs(one.rowY - other.rowY) > 11, "${one.point.name} on ${other.point.name}")
                val crossed =
                    Line2D.linesIntersect(
                        one.x,
                        one.y,
                        ChartLayout.NAMES,
                        one.rowY,
                        other.x,
                        other.y,
                        ChartLayout.NAMES,
                        other.rowY,
                    )
                assertFalse(crossed && one.x != other.x, "${one.point.name} crosses ${other.point.name}")
            }
        }
    }

    @Test
    @DisplayName("what is beaten stands on the front, or what is not told apart is beaten")
    fun onlyPartedIntervalsBeat() {
        val exact = ChartPoint("exact", MedianInterval(0.9, 1.0, 1.1), 0.0, own = false)
        val quick = ChartPoint("quick", MedianInterval(0.4, 0.5, 0.6), 2.0, own = false)
        val unclear = ChartPoint("unclear", MedianInterval(1.0, 1.5, 2.0), 0.0, own = true)
        val slow = ChartPoint("slow", MedianInterval(2.9, 3.0, 3.1), 1.0, own = false)
        val layout = ChartLayout(listOf(unclear, exact, quick, slow))
        assertEquals(emptyList<String>(), layout.beatenBy(unclear).map { it.name })
        assertEquals(listOf("exact", "unclear"), layout.beatenBy(slow).map { it.name })
        assertEquals(listOf("quick", "exact"), layout.corners.map { it.point.name })
    }

    @ParameterizedTest(name = "the axis of times has no numbers, or too many, up to {0}")
    @ValueSource(doubles = [1.0, 3.0, 50.0, 20_000.0])
    fun axisOfTimesHasAHandfulOfNumbers(ratio: Double) {
        val ticks = ChartLayout(listOf(ChartPoint("own", MedianInterval.exact(ratio), 0.0, own = true))).ratioTicks
        assertTrue(ticks.size in 2..7, ticks.map { it.value }.toString())
        assertTrue(ticks.any { it.value == 1.0 }, "the reference has no number")
    }

    private fun methods(vararg places: Pair<Double, Double>) =
        places.mapIndexed { number, (ratio, error) -> SpeedFigures.MethodSpeed("method-$number", ratio, error) }

    private companion object {
        const val INFINITE = Double.POSITIVE_INFINITY
    }
}
