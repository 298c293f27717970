package rasterlab.app.study.chart;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import rasterlab.app.canvas.method.TopicColors;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.chart.MethodLook;
import rasterlab.app.language.Language;
import rasterlab.app.rooms.LabRooms;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Cost;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;

class StudyChartTest {
    private static final StudyWords ENGLISH = new StudyWords(Language.ENGLISH);

    @Test
    void exactResultsStandBelowEveryRealError() {
        List<Measurement> points =
                List.of(point("dda", 0), point("naive", 0), point("bresenham", 0.25));
        ErrorAxis axis = ErrorAxis.over(points);
        double dda = axis.position(points.get(0));
        double naive = axis.position(points.get(1));
        assertTrue(axis.bottom() < naive && naive < dda, "one lane each");
        assertTrue(dda < axis.border() && axis.border() <= 0.25, "below the border");
        assertEquals(0.25, axis.position(points.get(2)));
        assertTrue(axis.top() > 0.25);
    }

    @Test
    @DisplayName("rounding that counts as exact stretches the axis by many decades")
    void whatCountsAsExactStandsInTheBand() {
        var rounded =
                new Measurement(
                        "dda",
                        "w",
                        16,
                        new Cost(2, 1, 3, Map.of()),
                        new Deviation(1e-16, 0, 0, 10, ""),
                        Verdict.Kind.EXACT,
                        "");
        ErrorAxis axis = ErrorAxis.over(List.of(rounded, point("naive", 2)));
        assertTrue(axis.position(rounded) < axis.border(), "" + axis);
        assertEquals(List.of(1.0, 10.0), axis.ticks());
    }

    @Test
    @DisplayName("a dark chart is white, or has a legend in place of names at the lines' ends")
    void chartIsDrawnOnItsGroundWithNamesAtTheEnds() {
        var study = new Study("line", "pixel", "pixels", List.of(point("dda", 3)));
        var dark = new ChartLook(new Color(20, 25, 31), new Color(230, 233, 238));
        BufferedImage drawn =
                dark.image(graphics -> StudyChart.paint(study, ENGLISH, dark, graphics));
        assertEquals(dark.ground().getRGB(), drawn.getRGB(3, 3));
        assertEquals(dark.ground().getRGB(), drawn.getRGB(drawn.getWidth() - 3, 350));
        assertFalse(has(drawn, Color.WHITE.getRGB()), "white on dark");
        String svg = svg(study);
        assertEquals(2, svg.split(">dda<", -1).length, "named once");
        assertFalse(
                StudyChart.chart(study, ENGLISH, ChartLook.PAPER).getStyler().isLegendVisible());
    }

    @Test
    void infiniteErrorKeepsTheAxisFinite() {
        List<Measurement> points =
                List.of(point("dda", 20), point("naive", Double.POSITIVE_INFINITY));
        ErrorAxis axis = ErrorAxis.over(points);
        assertEquals(100, axis.top());
        assertEquals(100, axis.position(points.get(1)));
    }

    @Test
    @DisplayName("what is not right without a number stands among what is exact, or unexplained")
    void notRightWithoutANumberIsNotExact() {
        var again =
                new Measurement(
                        "bresenham-textbook",
                        "length-16",
                        16,
                        Cost.of(List.of(5.0, 5.1, 5.2), Map.of("items", 9L, "inputs", 1L)),
                        Deviation.NONE,
                        Verdict.Kind.WRONG,
                        "8 pixels are drawn again");
        List<Measurement> points = List.of(again, point("naive", 2), point("dda", 0));
        ErrorAxis axis = ErrorAxis.over(points);
        assertEquals(List.of("dda"), axis.lanes());
        assertEquals(axis.top(), axis.position(again));
        assertEquals("not right", axis.label(axis.top(), ENGLISH));
        var study = new Study("circle", "pixel", "pixels", points);
        assertTrue(LeftOutNote.of(study, ENGLISH).height() > 0, "no note");
        String note = ENGLISH.notRightNote(study);
        assertTrue(note.contains("bresenham-textbook (8 pixels are drawn again)"), note);
    }

    @Test
    void labelsAreWordsAndPlainNumbers() {
        ErrorAxis axis = ErrorAxis.over(List.of(point("dda", 0), point("naive", 2e7)));
        assertEquals("10⁷", axis.label(1e7, ENGLISH));
        assertEquals("", axis.label(2e7, ENGLISH), "a multiple has no room");
        ErrorAxis low = ErrorAxis.over(List.of(point("dda", 0), point("naive", 2000)));
        assertEquals("1000", low.label(1000, ENGLISH));
    }

    @Test
    void exactStandsOnceInTheBandAndTheBandHasNoNumbers() {
        ErrorAxis axis = ErrorAxis.over(List.of(point("dda", 0), point("naive", 2e7)));
        List<String> labels =
                multiples(axis.bottom(), axis.border()).map(v -> axis.label(v, ENGLISH)).toList();
        assertEquals(List.of(ENGLISH.exact()), labels.stream().filter(l -> !l.isEmpty()).toList());
    }

    private static Stream<Double> multiples(double from, double to) {
        return IntStream.rangeClosed(-20, 20)
                .boxed()
                .flatMap(power -> IntStream.range(1, 10).mapToObj(i -> i * Math.pow(10, power)))
                .filter(value -> from <= value && value <= to);
    }

    @Test
    void numbersOfManyDecadesKeepTheirDistance() {
        ErrorAxis errors = ErrorAxis.over(List.of(point("dda", 1e-60), point("naive", 1)));
        assertTrue(errors.ticks().size() <= 22, errors.ticks().toString());
        CostAxis costs = CostAxis.over(List.of(costing(2e-5), costing(40)));
        assertEquals(
                List.of("10⁻⁵", "10⁻⁴", "0.001", "0.01", "0.1", "1", "10"),
                costs.ticks().stream().map(tick -> costs.label(tick, Locale.ENGLISH)).toList());
        assertEquals("", costs.label(20, Locale.ENGLISH));
        assertEquals("0,001", costs.label(0.001, new StudyWords(Language.RUSSIAN).locale()));
    }

    @Test
    @DisplayName("numbers at the axes of a Russian chart have a point")
    void numbersAtAxesHaveTheMarkOfTheLanguage() {
        for (Language language : Language.values()) {
            XYChart chart = new XYChartBuilder().build();
            ChartLook.PAPER.style(chart.getStyler(), language.locale());
            assertEquals(language.locale(), chart.getStyler().getLocale());
        }
    }

    @Test
    void fewDecadesHaveNumbersBetweenThePowersOfTen() {
        CostAxis costs = CostAxis.over(List.of(costing(24), costing(25)));
        assertEquals(
                List.of("20", "50"),
                costs.ticks().stream().map(tick -> costs.label(tick, Locale.ENGLISH)).toList(),
                "both ends");
    }

    @Test
    void noTwoMethodsOfATopicLookTheSame() {
        Topics.all().forEach(topic -> assertDistinct(names(topic), colors(topic)));
        assertDistinct(
                IntStream.range(0, 77).mapToObj(i -> "m" + i).toList(), new TopicColors(Map.of()));
    }

    private static List<String> names(Topic<?, ?, ?> topic) {
        return topic.methods().stream().map(Method::name).toList();
    }

    private static TopicColors colors(Topic<?, ?, ?> topic) {
        return LabRooms.card(topic.name()).colors();
    }

    private static void assertDistinct(List<String> methods, TopicColors colors) {
        Map<String, MethodLook> looks = MethodLook.of(methods, colors);
        assertEquals(methods.size(), Set.copyOf(looks.values()).size(), methods.toString());
    }

    @Test
    void topicsOfUpToElevenMethodsHaveAColorForEach() {
        for (Topic<?, ?, ?> topic : Topics.all())
            assertEquals(
                    Math.min(11, names(topic).size()),
                    Math.min(11, Set.copyOf(colors(topic).among(names(topic)).values()).size()),
                    topic.name());
    }

    @Test
    void linesJoinOnlyWorkloadsThatDifferInSize() {
        var study =
                new Study(
                        "curve",
                        "point",
                        "pixels",
                        List.of(
                                measured("flat-4-px", 10),
                                measured("steps-16", 16),
                                measured("flat-64th-px", 20)));
        XYChart chart = StudyChart.chart(study, new StudyWords(Language.ENGLISH), ChartLook.PAPER);
        assertEquals(
                List.of(2, 1),
                chart.getSeriesCollection().stream().map(line -> line.getXData().length).toList());
        assertEquals(
                1, chart.getSeriesCollection().stream().filter(s -> s.isShowInLegend()).count());
    }

    @Test
    void noteBelowTheChartIsNotCutOff() {
        List<Measurement> many =
                IntStream.range(0, 9)
                        .mapToObj(
                                i ->
                                        new Measurement(
                                                "cohen-sutherland-nested-textbook-" + i,
                                                "w",
                                                16,
                                                Cost.NONE,
                                                Deviation.NONE,
                                                Verdict.Kind.ENDLESS,
                                                ""))
                        .toList();
        var study = new Study("clip-segment", "segment", "window sizes", many);
        var note = LeftOutNote.of(study, new StudyWords(Language.ENGLISH));
        assertTrue(note.lines().stream().allMatch(l -> l.length() <= 130), note.toString());
        assertTrue(note.lines().size() > 2, note.toString());
        StudyChart.image(study, Language.ENGLISH);
    }

    @Test
    @DisplayName("a method whose turn has not come is said to have failed")
    void whatIsNotTimedYetIsNotLeftOut() {
        for (Verdict.Kind kind : Verdict.Kind.values()) {
            var study = new Study("line", "pixel", "pixels", List.of(untimed(16, kind)));
            boolean failed = kind.compareTo(Verdict.Kind.REFUSED) >= 0;
            var note = LeftOutNote.of(study, ENGLISH);
            assertEquals(failed, !note.lines().isEmpty(), kind.code());
        }
    }

    @Test
    void chartUsesTheMethodsColorAndSurvivesMethodsWithoutTime() {
        var endless =
                new Measurement(
                        "naive-textbook",
                        "w",
                        16,
                        Cost.NONE,
                        Deviation.NONE,
                        Verdict.Kind.ENDLESS,
                        "");
        BufferedImage chart =
                StudyChart.image(
                        new Study("line", "pixel", "pixels", List.of(point("dda", 3), endless)),
                        Language.ENGLISH);
        assertTrue(has(chart, LabRooms.card("line").colors().of("dda").getRGB()), "colour of dda");
        StudyChart.image(new Study("line", "pixel", "pixels", List.of(endless)), Language.ENGLISH);
    }

    @Test
    void russianChartHasNoEnglishWords() {
        var study =
                new Study(
                        "line",
                        "pixel",
                        "pixels",
                        List.of(
                                untimed(16, Verdict.Kind.REFUSED),
                                untimed(64, Verdict.Kind.REFUSED),
                                untimed(256, Verdict.Kind.CRASHED)));
        var words = new StudyWords(Language.RUSSIAN);
        assertEquals(
                List.of("Не измерено: dda (отказ: 16, 64; сбой: 256)"),
                LeftOutNote.of(study, words).lines());
        String svg = svg(study);
        var texts = Pattern.compile(">([^<]*[a-zA-Z]{3}[^<]*)<").matcher(svg);
        List<String> english = texts.results().map(found -> found.group(1).strip()).toList();
        assertEquals(List.of("Не измерено: dda (отказ: 16, 64; сбой: 256)"), english, "but a name");
        XYChart chart = StudyChart.chart(study, words, ChartLook.PAPER);
        assertEquals("Скорость и точность: отрезок", chart.getTitle());
        assertTrue(chart.getXAxisTitle().startsWith("время: наносекунд на пиксель"));
        assertEquals("наибольшая ошибка [пиксели]", chart.getYAxisTitle());
    }

    private static Measurement untimed(int size, Verdict.Kind kind) {
        return new Measurement("dda", "w", size, Cost.NONE, Deviation.NONE, kind, "");
    }

    private static boolean has(BufferedImage image, int rgb) {
        for (int y = 0; y < image.getHeight(); y++)
            for (int x = 0; x < image.getWidth(); x++) if (image.getRGB(x, y) == rgb) return true;
        return false;
    }

    private static Measurement costing(double nanos) {
        var cost = new Cost(nanos, nanos, nanos, Map.of());
        return new Measurement("dda", "w", 16, cost, Deviation.NONE, Verdict.Kind.EXACT, "");
    }

    private static Measurement measured(String workload, int size) {
        var cost = new Cost(2, 1, 3, Map.of());
        return new Measurement("dda", workload, size, cost, Deviation.NONE, Verdict.Kind.EXACT, "");
    }

    private static Measurement point(String method, double error) {
        var deviation = new Deviation(error, 0, 0, 10, "");
        Verdict.Kind kind = error == 0 ? Verdict.Kind.EXACT : Verdict.Kind.DEGRADED;
        return new Measurement(method, "w", 16, new Cost(2, 1, 3, Map.of()), deviation, kind, "");
    }

    private static String svg(Study study) {
        var words = new StudyWords(Language.RUSSIAN);
        byte[] svg =
                ChartLook.PAPER.svg(
                        graphics -> StudyChart.paint(study, words, ChartLook.PAPER, graphics));
        return new String(svg, StandardCharsets.UTF_8);
    }
}
