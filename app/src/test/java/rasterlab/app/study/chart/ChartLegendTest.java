package rasterlab.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Dimension;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Map;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.canvas.SvgPicture;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.language.Language;
import rasterlab.engine.study.Cost;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.Verdict;

class ChartLegendTest {
    private static final Dimension NARROW = new Dimension(560, 480);

    /** A study whose points go from one end of the axis of costs to the other. */
    private static final Study STUDY =
            new Study(
                    "line",
                    "pixel",
                    "pixels",
                    IntStream.range(0, 12)
                            .boxed()
                            .flatMap(
                                    i ->
                                            Stream.of(1, 100)
                                                    .map(
                                                            cost ->
                                                                    measured(
                                                                            "a-long-name-" + i,
                                                                            cost)))
                            .toList());

    private static Measurement measured(String method, int cost) {
        return new Measurement(
                method,
                "w",
                cost,
                new Cost(cost, cost, cost, Map.of()),
                new Deviation(1, 0, 0, 1, ""),
                Verdict.Kind.WRONG,
                "");
    }

    private final PointPlaces places = new PointPlaces(StudyChart.points(STUDY));
    private final String svg =
            SvgPicture.of(
                            NARROW.width,
                            NARROW.height,
                            graphics ->
                                    StudyChart.paint(
                                            STUDY,
                                            new StudyWords(Language.RUSSIAN),
                                            ChartLook.PAPER,
                                            NARROW,
                                            places,
                                            graphics))
                    .document();

    @Test
    @DisplayName("names of methods leave a narrow plot less than half of the width")
    void plotTakesMostOfANarrowStage() {
        List<Integer> across = places.all().stream().map(PointPlaces.Place::x).sorted().toList();
        int wide = across.get(across.size() - 1) - across.get(0);
        assertTrue(wide >= NARROW.width / 2, wide + " of " + NARROW.width);
    }

    @Test
    @DisplayName("a method has no name in a narrow stage, or one in the plot or outside the stage")
    void namesStandBelowThePlot() {
        List<MatchResult> names =
                Pattern.compile(
                                "<text[^>]*? x=\"(\\d+)\"[^>]*? y=\"(\\d+)\"[^>]*>a-long-name-\\d+<")
                        .matcher(svg)
                        .results()
                        .toList();
        assertEquals(12, names.size());
        int foot = places.all().stream().mapToInt(PointPlaces.Place::y).max().orElseThrow();
        for (MatchResult name : names) {
            assertTrue(Integer.parseInt(name.group(2)) > foot, name.group());
            assertTrue(Integer.parseInt(name.group(2)) < NARROW.height, name.group());
            assertTrue(Integer.parseInt(name.group(1)) < NARROW.width - 80, name.group());
        }
    }

    @Test
    @DisplayName("a long title ends outside a narrow stage")
    void titleFitsANarrowStage() {
        var image = new BufferedImage(NARROW.width, NARROW.height, BufferedImage.TYPE_INT_RGB);
        var study = new Study("clip-volume", "edge", "pixels", STUDY.measurements());
        StudyChart.paint(
                study,
                new StudyWords(Language.RUSSIAN),
                ChartLook.PAPER,
                NARROW,
                new PointPlaces(StudyChart.points(study)),
                image.createGraphics());
        int[] inked =
                IntStream.range(0, NARROW.width)
                        .filter(x -> IntStream.range(8, 30).anyMatch(y -> dark(image, x, y)))
                        .toArray();
        assertTrue(inked.length > NARROW.width / 4, "no title");
        assertTrue(inked[inked.length - 1] < NARROW.width - 4, "cut off");
    }

    private static boolean dark(BufferedImage image, int x, int y) {
        return (image.getRGB(x, y) & 0xFF) < 128;
    }
}
