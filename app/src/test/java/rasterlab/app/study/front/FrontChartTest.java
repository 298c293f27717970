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
                        .map(FrontChart.PaintedPoint::y)
                        .distinct()
                        .toList();
        assertEquals(1, rows.size());
        for (FrontChart.PaintedPoint spot : chart.spots()) assertTrue(spot.y() <= rows.get(0));
    }

    @Test
    void growthIsToldWithItsPowerAndInterval() {
        String svg = svg(StudyPlot.COST_GROWTH, Language.ENGLISH);
        assertTrue(svg.contains("bresenham  p = 1.00 ± 0.00"), svg);
        String errors = svg(StudyPlot.ERROR_GROWTH, Language.ENGLISH);
        assertFalse(errors.contains(">bresenham"), "no place for what is exact");
    }

    private static Study of(String topic, List<Measurement> points) {
        return new Study(topic, "item", "units", points);
    }

    private static String svg(StudyPlot plot, Study study) {
        byte[] svg =
                plot.of(study, new StudyWords(Language.ENGLISH), ChartLook.PAPER)
                        .svg(ChartLook.PAPER);
        return new String(svg, StandardCharsets.UTF_8);
    }

    @Test
    @DisplayName("the size of no error at all looks like the largest of all, or like none")
    void whatIsNotRightWithoutANumberHasARowOfItsOwn() {
        Measurement again =
                new Measurement(
                        "bresenham-textbook",
                        "length-16",
                        16,
                        Cost.of(List.of(5.0, 5.1, 5.2, 5.3), Map.of("items", 90L, "inputs", 1L)),
                        Deviation.NONE,
                        Verdict.Kind.WRONG,
                        "8 pixels are drawn again");
        Study circle =
                of(
                        "circle",
                        List.of(again, timed("midpoint", 16, 10, 0), timed("naive", 16, 9, 2)));
        var chart = new FrontChart(circle, new StudyWords(Language.ENGLISH), ChartLook.PAPER);
        chart.image(ChartLook.PAPER);
        double row = spot(chart, "bresenham-textbook").y();
        assertTrue(row + 20 < spot(chart, "naive").y(), "above the largest error");
        assertTrue(row > 40, "below the title");
        String said = "tells by how much: bresenham-textbook (8 pixels are drawn again).";
        assertTrue(text(svg(StudyPlot.FRONT, circle)).contains(said), "its row is explained");
        assertTrue(svg(StudyPlot.FRONT, circle).contains(">not right<"), "its row has a name");
        String russian = svg(circle, StudyPlot.FRONT, Language.RUSSIAN);
        assertTrue(russian.contains(">неверно<"), "its row has a name in Russian");
        assertTrue(
                text(svg(StudyPlot.ERROR_GROWTH, circle))
                        .contains(
                                "not on this axis: bresenham-textbook (8 pixels are drawn again)"),
                "it is not among the exact ones");
    }

    private static FrontChart.PaintedPoint spot(FrontChart chart, String method) {
        return chart.spots().stream()
                .filter(spot -> spot.point().method().equals(method))
                .findFirst()
                .orElseThrow();
    }

    /** The words of a drawing, lines joined. */
    private static String text(String svg) {
        return svg.replaceAll("<[^>]*>\\s*", " ").replaceAll("\\s+", " ");
    }

    @Test
    @DisplayName("an empty frame says nothing")
    void whereAllIsExactTheChartOfErrorsSaysSo() {
        Study exact =
                of("point-in-triangle", List.of(timed("sign", 16, 9, 0), timed("sign", 64, 9, 0)));
        assertTrue(text(svg(StudyPlot.ERROR_GROWTH, exact)).contains("every result is exact"));
    }

    @Test
    @DisplayName("a power is fitted to a size that is none")
    void noPowerWhereSizesSayNothingOfTheWork() {
        var points = new ArrayList<Measurement>();
        for (int size : new int[] {5, 25, 50}) points.add(timed("liang-barsky", size, 30, 0));
        String svg = svg(StudyPlot.COST_GROWTH, of("clip-segment", points));
        assertFalse(svg.contains("p = "), svg);
        assertTrue(svg.contains(">visible segments of 100<"), svg);
    }

    @Test
    @DisplayName("an exponent is a zero below zero")
    void powersHaveRealSigns() {
        var words = new StudyWords(Language.ENGLISH);
        assertEquals("p = 0.00 ± 0.05", words.power(-0.001, 0.05));
        assertEquals("p = −0.50 ± 0.05", words.power(-0.5, 0.05));
        assertEquals("1.5·10⁻¹²", words.shortNumber(1.5e-12));
        assertEquals("10⁻¹²", words.shortNumber(1e-12));
        assertEquals("150", words.shortNumber(150));
    }

    @Test
    @DisplayName("an axis whose errors are all alike has no number")
    void everyAxisHasTwoNumbers() {
        for (double error : new double[] {3.3e-14, 1, 7, 1.3, 99.7}) {
            LogScale scale = LogScale.over(List.of(error), 0, 100);
            assertTrue(scale.ticks().size() >= 2, error + ": " + scale.ticks());
            assertTrue(scale.ticks().stream().allMatch(t -> scale.low() <= t && t <= scale.high()));
        }
    }

    @Test
    @DisplayName("the last size, or the first, has no number at its axis")
    void axisOfSizesNamesTheSizesThatWereMeasured() {
        var points = new ArrayList<Measurement>();
        for (int size : new int[] {16, 17, 250, 256}) points.add(timed("dda", size, 10, 2));
        Study study = of("line", points);
        for (StudyPlot plot :
                List.of(StudyPlot.COST_GROWTH, StudyPlot.ERROR_GROWTH, StudyPlot.ERROR_BY_INPUT)) {
            String svg = svg(plot, study);
            assertTrue(svg.contains(">16<") && svg.contains(">256<"), plot.code());
            assertFalse(svg.contains(">17<") || svg.contains(">250<"), "on its neighbour");
            assertFalse(svg.contains(">100<"), "not measured: " + plot.code());
        }
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
