package rasterlab.app.study.chart;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.internal.chartpart.Annotation;
import rasterlab.app.canvas.SvgPicture;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.language.Language;
import rasterlab.engine.study.Cost;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.Verdict;

class SizeLabelsTest {
    @Test
    void labelsOfMethodsAtOnePlaceStandApart() {
        List<MatchResult> labels = labels(3, 3);
        int across = distance(labels, 1);
        int down = distance(labels, 2);
        assertTrue(across >= 35 || down >= 11, "labels are " + across + ", " + down + " apart");
    }

    @Test
    void labelsOfNeighboursAreNotReadAsOneNumber() {
        int width = width("77777");
        for (double cost = 3.1; cost < 3.3; cost += 0.003) {
            List<MatchResult> labels = labels(3, cost);
            int across = distance(labels, 1);
            assertTrue(
                    across >= width + 3 || distance(labels, 2) >= 11,
                    "a gap of " + (across - width) + " at cost " + cost);
        }
    }

    @Test
    @DisplayName("a label lies on a line, a point or another label")
    void labelsOfCrossingLinesLieOnNothing() {
        var random = new Random(3);
        List<Measurement> points = new ArrayList<>();
        for (int method = 0; method < 9; method++)
            for (int size = 1; size <= 1000; size *= 10)
                points.add(
                        measured(
                                "m" + method,
                                size * 77,
                                Math.pow(10, 2 * random.nextDouble()),
                                random.nextInt(3) == 0 ? 0 : Math.pow(10, random.nextDouble())));
        var study = new Study("line", "pixel", "pixels", points);
        XYChart chart = StudyChart.chart(study, new StudyWords(Language.ENGLISH), ChartLook.PAPER);
        var places = new PointPlaces(points);
        chart.addAnnotation(places);
        String svg = SvgPicture.of(1000, 700, g -> chart.paint(g, 1000, 700)).document();
        List<Rectangle> labels = boxes(svg, "77|77000");
        assertEquals(18, labels.size());
        for (Rectangle label : labels)
            assertEquals(List.of(), under(label, labels, places.all()), label.toString());
    }

    /** Remembers where a chart puts the edges of the band of exact results. */
    private static final class Edges extends Annotation {
        private final ErrorAxis errors;
        private final List<Integer> places = new ArrayList<>();

        Edges(ErrorAxis errors) {
            super(false);
            this.errors = errors;
        }

        @Override
        public void paint(Graphics2D graphics) {
            for (double edge : List.of(errors.border(), errors.bottom()))
                places.add(getYAxisScreenValue(edge));
        }
    }

    @ParameterizedTest(name = "a size lies on an edge of the band of {0} exact methods")
    @ValueSource(ints = {1, 2, 3, 5, 8})
    void labelsLieOnNoEdgeOfTheBand(int methods) {
        List<Measurement> points =
                IntStream.range(0, methods)
                        .mapToObj(i -> measured("m" + i, 77_777, 2 + 10 * i, 0))
                        .toList();
        XYChart chart =
                StudyChart.chart(
                        new Study("line", "pixel", "pixels", points),
                        new StudyWords(Language.ENGLISH),
                        ChartLook.PAPER);
        var edges = new Edges(ErrorAxis.over(points));
        chart.addAnnotation(edges);
        String svg = SvgPicture.of(1000, 700, g -> chart.paint(g, 1000, 700)).document();
        List<Rectangle> labels = boxes(svg, "77777");
        assertEquals(methods, labels.size());
        for (Rectangle label : labels)
            for (int edge : edges.places)
                assertFalse(label.intersectsLine(0, edge, 1000, edge), label + " on " + edge);
    }

    /** The things that the label lies on. */
    private static List<?> under(
            Rectangle label, List<Rectangle> labels, List<PointPlaces.Place> places) {
        List<Object> under = new ArrayList<>();
        labels.stream()
                .filter(other -> other != label && other.intersects(label))
                .forEach(under::add);
        places.stream().filter(place -> label.contains(place.x(), place.y())).forEach(under::add);
        for (int i = 1; i < places.size(); i++) {
            PointPlaces.Place from = places.get(i - 1);
            PointPlaces.Place to = places.get(i);
            if (from.point().method().equals(to.point().method())
                    && label.intersectsLine(from.x(), from.y(), to.x(), to.y()))
                under.add(List.of(from, to));
        }
        return under;
    }

    /** Where digits are; their baselines are below them. */
    private static List<Rectangle> boxes(String svg, String text) {
        return Pattern.compile("<text[^>]*? x=\"(\\d+)\"[^>]*? y=\"(\\d+)\"[^>]*>(" + text + ")<")
                .matcher(svg)
                .results()
                .map(
                        found ->
                                new Rectangle(
                                        Integer.parseInt(found.group(1)),
                                        Integer.parseInt(found.group(2)) - 9,
                                        width(found.group(3)),
                                        9))
                .toList();
    }

    private static int width(String text) {
        var image = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB);
        return image.createGraphics()
                .getFontMetrics(new Font(Font.SANS_SERIF, Font.PLAIN, 12))
                .stringWidth(text);
    }

    /** Two methods' labels, of sizes found nowhere else in the picture. */
    private static List<MatchResult> labels(double... costs) {
        List<Measurement> points =
                IntStream.range(0, costs.length)
                        .mapToObj(i -> measured("m" + i, 77_777, costs[i], 2))
                        .toList();
        var study = new Study("line", "pixel", "pixels", points);
        String svg = svg(study);
        List<MatchResult> labels =
                Pattern.compile("<text[^>]*? x=\"(\\d+)\"[^>]*? y=\"(\\d+)\"[^>]*>77777<")
                        .matcher(svg)
                        .results()
                        .toList();
        assertEquals(2, labels.size(), "both labels are drawn");
        return labels;
    }

    private static Measurement measured(String method, int size, double cost, double error) {
        return new Measurement(
                method,
                "w",
                size,
                new Cost(cost, cost, cost, Map.of()),
                new Deviation(error, 0, 0, 1, ""),
                Verdict.Kind.WRONG,
                "");
    }

    private static int distance(List<MatchResult> labels, int group) {
        return Math.abs(
                Integer.parseInt(labels.get(0).group(group))
                        - Integer.parseInt(labels.get(1).group(group)));
    }

    @ParameterizedTest(name = "sizes are said to stand only where there is room: {0}")
    @EnumSource(Language.class)
    void axisSaysWhatIsBesideThePoints(Language language) {
        String axis =
                new StudyWords(language).costAxis(new Study("line", "pixel", "pixels", List.of()));
        assertTrue(axis.matches(".*(greatest size|наибольший размер).*"), axis);
        assertFalse(axis.matches(".*(room|мест[оа]).*"), axis);
    }

    @Test
    void longPowersOfTenAreShort() {
        assertEquals("10⁷", LogTicks.size(10_000_000));
        assertEquals("1000", LogTicks.size(1000));
        assertEquals("65536", LogTicks.size(65536));
    }

    @Test
    @DisplayName("the digits of a large number on an axis run together")
    void largeNumbersOfAnAxisAreGrouped() {
        assertEquals("200,000", LogTicks.label(200_000, Locale.ENGLISH));
        assertEquals("10\u00a0000", LogTicks.label(10_000, Language.RUSSIAN.locale()));
        assertEquals("5000", LogTicks.label(5_000, Locale.ENGLISH));
        assertEquals("0.001", LogTicks.label(0.001, Locale.ENGLISH));
    }

    private static String svg(Study study) {
        var words = new StudyWords(Language.ENGLISH);
        byte[] svg =
                ChartLook.PAPER.svg(
                        graphics -> StudyChart.paint(study, words, ChartLook.PAPER, graphics));
        return new String(svg, StandardCharsets.UTF_8);
    }
}
