package rasterlab.app.study.front;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.language.Language;
import rasterlab.app.study.chart.StudyWords;
import rasterlab.engine.study.Cost;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.Verdict;

class FrontChartTest {
    private static Measurement timed(String method, int size, double nanos, double error) {
        var rounds = new ArrayList<Double>();
        for (int i = 0; i < 12; i++) rounds.add(nanos * (1 + 0.001 * i));
        return new Measurement(
                method,
                "length-" + size,
                size,
                Cost.of(rounds, Map.of("items", (long) size, "inputs", 1L)),
                new Deviation(error, 0, 0, 9, ""),
                error < 1e-9 ? Verdict.Kind.EXACT : Verdict.Kind.DEGRADED,
                "",
                List.of(error / 2, error));
    }

    private static Study study() {
        var points = new ArrayList<Measurement>();
        for (int size : new int[] {16, 64, 256}) {
            points.add(timed("naive", size, 30, 4));
            points.add(timed("dda", size, 10, 2));
            points.add(timed("bresenham", size, 20, 0));
            points.add(timed("midpoint", size, 25, 0));
        }
        return new Study("line", "pixel", "pixels", points);
    }

    private static String svg(StudyPlot plot, Language language) {
        return svg(study(), plot, language);
    }

    private static String svg(Study study, StudyPlot plot, Language language) {
        byte[] svg = plot.of(study, new StudyWords(language), ChartLook.PAPER).svg(ChartLook.PAPER);
        return new String(svg, StandardCharsets.UTF_8);
    }

    @Test
    void whatIsBeatenSaysByWhat() {
        String svg = svg(StudyPlot.FRONT, Language.ENGLISH);
        assertTrue(svg.contains(">naive ← dda<"), "by the quickest of three");
        assertTrue(svg.contains(">midpoint ← bresenham<"), "as exact, but slower");
        assertTrue(svg.contains(">dda<") && svg.contains(">bresenham<"), "the front");
    }

    @Test
    void exactResultsStandInOneRowBelowEveryError() {
        var chart = new FrontChart(study(), new StudyWords(Language.ENGLISH), ChartLook.PAPER);
        chart.image(ChartLook.PAPER);
        List<Double> rows =
                chart.spots().stream()
                        .filter(spot -> spot.point().error().worst() == 0)
                        .map(FrontChart.Spot::y)
                        .distinct()
                        .toList();
        assertEquals(1, rows.size());
        for (FrontChart.Spot spot : chart.spots()) assertTrue(spot.y() <= rows.get(0));
    }

    @Test
    void growthIsToldWithItsPowerAndInterval() {
        String svg = svg(StudyPlot.COST_GROWTH, Language.ENGLISH);
        assertTrue(svg.contains("bresenham  n^(1.00 ± 0.00)"), svg);
        String errors = svg(StudyPlot.ERROR_GROWTH, Language.ENGLISH);
        assertFalse(errors.contains(">bresenham"), "no place for what is exact");
    }

    @Test
    @DisplayName("the chart of errors does not say which method is best where")
    void regimesAreNamedOnTheChartAndBelow() {
        String svg = svg(StudyPlot.ERROR_BY_INPUT, Language.ENGLISH);
        assertTrue(svg.contains("Best: bresenham at all sizes."), svg);
        assertEquals(2, svg.split(">bresenham<", -1).length - 1, "on the strip and at its line");
        assertTrue(svg.contains(">midpoint<"), "exact, and not best");
    }

    @Test
    @DisplayName("the chart of errors names a best method where times are not told apart")
    void openRegimesAreSaidToBeOpen() {
        var points = new ArrayList<Measurement>();
        for (int size : new int[] {16, 64, 256})
            for (String method : List.of("dda", "bresenham", "midpoint", "naive"))
                if (size < 256 || !method.startsWith("d"))
                    points.add(
                            timed(method, size, size == 256 && method.equals("naive") ? 5 : 20, 0));
        var study = new Study("line", "pixel", "pixels", points);
        String english = svg(study, StudyPlot.ERROR_BY_INPUT, Language.ENGLISH);
        String said = "Best: one of 4 methods (not told apart) up to 64, naive beyond.";
        assertTrue(english.contains(said), english);
        assertTrue(english.contains(">one of 4 methods (not told apart)<"), english);
        String russian = svg(study, StudyPlot.ERROR_BY_INPUT, Language.RUSSIAN);
        assertTrue(russian.contains("один из 4 методов (не различить) до 64"), russian);
    }

    @Test
    void everyChartHasRussianWordsAndNothingBreaksWithoutAPoint() {
        for (StudyPlot plot : StudyPlot.values()) {
            String svg = svg(plot, Language.RUSSIAN);
            if (plot != StudyPlot.SIZES) assertTrue(svg.contains("отрезок"), plot.code());
            var empty =
                    new Study(
                            "line",
                            "pixel",
                            "pixels",
                            List.of(
                                    new Measurement(
                                            "dda",
                                            "length-16",
                                            16,
                                            Cost.NONE,
                                            Deviation.NONE,
                                            Verdict.Kind.REFUSED,
                                            "")));
            plot.of(empty, new StudyWords(Language.ENGLISH), ChartLook.PAPER)
                    .image(ChartLook.PAPER);
        }
    }
}
