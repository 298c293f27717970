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
import rasterlab.exercises.published.PublishedSpeed
import rasterlab.exercises.score.SpeedFigures

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
            """<tr><td>method-0</td><td class="number">12.5</td><td class="number">0</td></tr>""" in english,
            english,
        )
        val russian = page(figures, "ru")
        assertTrue("Время вашего метода относительно эталона: 1,13; его наибольшая ошибка: 0,5." in russian, russian)
        assertTrue("время на пиксель, эталон = 1" in russian, russian)
        assertTrue("до 1,5 от эталонного" in russian, russian)
    }

    @ParameterizedTest(name = "names of methods touch each other or leave the chart at an error of {0}")
    @ValueSource(doubles = [0.0, 1e-16, 0.5, INFINITE])
    fun namesAreApart(error: Double) {
        val points =
            listOf(0.02, 0.98, 1.0, 1.3, 1.7, 40.0).mapIndexed { number, ratio ->
                ChartPoint("long-method-$number", ratio, error, own = number == 0)
            }
        val placed = ChartLayout(points).placed
        assertEquals(points.size, placed.size)
        for ((number, one) in placed.withIndex()) {
            assertTrue(
                one.text.start >= 0 && one.text.endInclusive <= ChartLayout.WIDTH,
                "${one.point.name}: ${one.text}",
            )
            for (other in placed.drop(number + 1)) {
                val apart = one.text.start > other.text.endInclusive || other.text.start > one.text.endInclusive
                assertTrue(apart || Math.abs(one.textY - other.textY) > 11, "${one.point.name} on ${other.point.name}")
            }
            for (other in placed.filter { it !== one }) {
                assertFalse(one.hides(other.x, other.y), "${one.point.name} on the mark of ${other.point.name}")
            }
        }
    }

    @ParameterizedTest(name = "the axis of times has no numbers, or too many, up to {0}")
    @ValueSource(doubles = [1.0, 3.0, 50.0, 20_000.0])
    fun axisOfTimesHasAHandfulOfNumbers(ratio: Double) {
        val ticks = ChartLayout(listOf(ChartPoint("own", ratio, 0.0, own = true))).ratios
        assertTrue(ticks.size in 2..7, ticks.map { it.value }.toString())
        assertTrue(ticks.any { it.value == 1.0 }, "the reference has no number")
    }

    private fun methods(vararg places: Pair<Double, Double>) =
        places.mapIndexed { number, (ratio, error) -> SpeedFigures.Method("method-$number", ratio, error) }

    private companion object {
        const val INFINITE = Double.POSITIVE_INFINITY
    }
}
