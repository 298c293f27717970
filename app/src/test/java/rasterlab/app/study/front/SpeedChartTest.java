package rasterlab.app.study.front;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Dimension;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.language.Language;
import rasterlab.engine.study.measuring.MedianInterval;
import rasterlab.exercises.published.PublishedSpeed;
import rasterlab.exercises.score.SpeedFigures;

/** A program's place among the methods of its topic, in the window as on the server's page. */
class SpeedChartTest {
    private static SpeedFigures.MethodSpeed method(String name, double ratio, double error) {
        return new SpeedFigures.MethodSpeed(
                name, new MedianInterval(0.97 * ratio, ratio, 1.03 * ratio), error);
    }

    private static SpeedChart chart(MedianInterval mine, Language language) {
        var figures =
                new SpeedFigures(
                        mine,
                        2,
                        0,
                        List.of(
                                method("dda-float", 0.5, 1),
                                method("dda", 1, 0),
                                method("naive", 6, 2),
                                method("wu", 9, Double.POSITIVE_INFINITY)));
        return new SpeedChart("line", PublishedSpeed.of("line", figures), language);
    }

    private static String svg(SpeedChart chart) {
        byte[] svg =
                ChartLook.PAPER.svg(
                        graphics ->
                                chart.paint(ChartLook.PAPER, new Dimension(600, 400), graphics));
        return new String(svg, StandardCharsets.UTF_8);
    }

    @Test
    @DisplayName("a program that another beats is not told so, or one that is not told apart is")
    void beatenNamesWhatBeatsIt() {
        String slower = svg(chart(new MedianInterval(2.8, 3, 3.2), Language.ENGLISH));
        assertTrue(slower.contains(">my program ← dda<"), slower);
        assertTrue(slower.contains(">naive ← dda-float<"), slower);
        String open = svg(chart(new MedianInterval(0.9, 1.3, 3.2), Language.ENGLISH));
        assertTrue(open.contains(">my program<"), open);
    }

    @Test
    @DisplayName("the bars end elsewhere than the intervals that the exercise measured")
    void barsEndWhereTheIntervalsDo() {
        SpeedChart chart = chart(new MedianInterval(1.5, 3, 3.2), Language.ENGLISH);
        FrontChart front = chart.front(ChartLook.PAPER);
        front.image(ChartLook.PAPER);
        Map<String, FrontChart.PaintedPoint> spots =
                front.spots().stream()
                        .collect(Collectors.toMap(spot -> spot.point().method(), spot -> spot));
        FrontChart.PaintedPoint mine =
                spots.values().stream()
                        .filter(spot -> spot.point().cost().medianNanos() == 3)
                        .findFirst()
                        .orElseThrow();
        assertEquals(new MedianInterval(1.5, 3, 3.2), mine.point().cost().interval(1));
        assertEquals(spots.get("dda").y(), mine.y(), "both exact");
        assertTrue(spots.get("wu").y() < spots.get("naive").y(), "no end above every error");
        assertTrue(spots.get("dda-float").x() < spots.get("dda").x());
    }

    @Test
    @DisplayName("the axis has nanoseconds, or the title ends in a comma for want of a workload")
    void axisHasMultiplesOfTheReference() {
        String english = svg(chart(MedianInterval.exact(2), Language.ENGLISH));
        assertTrue(english.contains("time per pixel, reference = 1"), english);
        assertTrue(svg(chart(MedianInterval.exact(2), Language.RUSSIAN)).contains("эталон = 1"));
        assertTrue(english.contains("segment<"), english);
        assertFalse(english.contains("99 %"), "an exercise tells no confidence");
    }
}
