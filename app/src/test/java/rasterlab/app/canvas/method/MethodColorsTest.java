package rasterlab.app.canvas.method;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.chart.MethodLook;
import rasterlab.app.rooms.LabRooms;
import rasterlab.engine.Topics;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.raster.PixelMark;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.engine.visibility.depth.DepthPrecision;

class MethodColorsTest {
    /** The colours that colour-blind people can tell apart. */
    private static final int MOST_COLORS = 11;

    /** Levels between two colours: one can tell them apart, and without looking twice. */
    private static final double LEAST = 12;

    private static final double ENOUGH = 40;

    /** Methods of one picture, with their colours. */
    record Together(List<String> methods, TopicColors colors) {
        static Together of(Topic<?, ?, ?> topic) {
            return new Together(
                    topic.methods().stream().map(Method::name).toList(),
                    LabRooms.card(topic.name()).colors());
        }

        /** All for hidden surfaces, those too that no topic has. */
        static Together visibilities() {
            return new Together(Renderer.visibilities(), LabRooms.card("hidden-surfaces").colors());
        }

        /** Makes as many methods without colours of their own as the palette has colours. */
        static Together palette() {
            return new Together(
                    IntStream.range(0, MethodColors.PALETTE.size())
                            .mapToObj(i -> "method " + i)
                            .toList(),
                    new TopicColors(Map.of()));
        }

        Map<String, MethodLook> looks() {
            return MethodLook.of(methods, colors);
        }

        @Override
        public String toString() {
            return methods.toString();
        }
    }

    /** Topics whose methods all have colours of their own. */
    static Stream<Together> colored() {
        return Stream.concat(
                Stream.of(Together.visibilities()),
                Topics.all().stream()
                        .map(Together::of)
                        .filter(all -> all.colors.own().keySet().containsAll(all.methods)));
    }

    static Stream<Color> ownColors() {
        return LabRooms.cards().stream()
                .flatMap(card -> card.colors().own().values().stream())
                .distinct();
    }

    @Test
    void givesNoTwoMethodsOfATopicTheSameColor() {
        for (Together all : colored().filter(all -> all.methods.size() <= MOST_COLORS).toList())
            assertEquals(
                    all.methods.size(),
                    new HashSet<>(all.methods.stream().map(all.colors::of).toList()).size(),
                    all.toString());
    }

    @Test
    void methodsDifferInGrayByMarkOrLine() {
        for (Together all : colored().toList())
            assertEquals(
                    all.methods.size(),
                    all.looks().values().stream()
                            .map(look -> List.of(look.marker(), look.stroke()))
                            .distinct()
                            .count(),
                    all.toString());
    }

    @Test
    void methodsForHiddenSurfacesAllHaveColorsOfTheirOwn() {
        List<String> names = Renderer.visibilities();
        TopicColors own = Together.visibilities().colors;
        assertEquals(names.size(), new HashSet<>(own.among(names).values()).size());
        for (String name : names) assertEquals(own.of(name), own.among(names).get(name), name);
    }

    @Test
    @DisplayName("two methods of a topic have one colour on a chart, if only on a dark ground")
    void linesOfOneTopicDifferOnEveryGround() {
        for (Topic<?, ?, ?> topic : Topics.all()) {
            Together all = Together.of(topic);
            for (String one : all.methods)
                for (String two : all.methods.subList(0, all.methods.indexOf(one))) {
                    double light = apart(all, one, two, StageColors.LIGHT);
                    double dark = apart(all, one, two, StageColors.DARK);
                    String pair = topic.name() + ": " + one + ", " + two;
                    assertTrue(light >= LEAST, pair + " are " + light + " apart on white");
                    assertTrue(dark >= Math.min(ENOUGH, light), pair + " are " + dark + " apart");
                }
        }
    }

    @Test
    @DisplayName("a colour for a dark ground is too dark, or is taken for another of the palette")
    void colorsOfThePaletteDifferOnTheDarkStage() {
        Together all = Together.palette();
        List<String> names = all.methods;
        Color ground = StageColors.DARK.ground();
        for (String one : names) {
            Color line = all.looks().get(one).on(ChartLook.on(StageColors.DARK)).color();
            assertTrue(MethodColors.contrast(line, ground) >= 3, line.toString());
            for (String two : names.subList(0, names.indexOf(one))) {
                double light = apart(all, one, two, StageColors.LIGHT);
                double dark = apart(all, one, two, StageColors.DARK);
                assertTrue(
                        dark >= Math.min(ENOUGH, light),
                        () ->
                                all.looks().get(one).color()
                                        + ", "
                                        + all.looks().get(two).color()
                                        + " are "
                                        + dark
                                        + " apart");
            }
        }
    }

    /** Colours of one chart, in OKLab: nearer ones are taken for each other at a glance. */
    private static final double LEAST_OKLAB = 0.12;

    static Stream<Together> charts() {
        var formats = new Together(DepthPrecision.FORMATS, LabRooms.card("depth-buffer").colors());
        return Stream.concat(
                Stream.of(Together.palette(), Together.visibilities(), formats),
                Topics.all().stream().map(Together::of));
    }

    @ParameterizedTest(name = "two colours of one chart are near-alike: {0}")
    @MethodSource("charts")
    void colorsOfOneChartAreFarApartInEveryTheme(Together all) {
        List<String> names = all.methods;
        Map<String, MethodLook> looks = all.looks();
        for (StageColors stage :
                List.of(StageColors.LIGHT, StageColors.DARK, StageColors.PROJECTOR))
            for (String one : names)
                for (String two : names.subList(0, names.indexOf(one))) {
                    ChartLook paper = ChartLook.on(stage);
                    double far =
                            perceived(
                                    looks.get(one).on(paper).color(),
                                    looks.get(two).on(paper).color());
                    assertTrue(
                            far >= LEAST_OKLAB,
                            () -> one + ", " + two + " are " + far + " apart on " + stage.ground());
                }
    }

    @Test
    void blackAndWhiteAreOneApartInOklab() {
        assertEquals(1, perceived(Color.BLACK, Color.WHITE), 1e-4);
        assertEquals(0, perceived(Color.RED, Color.RED), 0);
    }

    /** Source: B. Ottosson, A perceptual color space for image processing, 2020. */
    private static double perceived(Color one, Color two) {
        double[] a = oklab(one);
        double[] b = oklab(two);
        return Math.hypot(Math.hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
    }

    private static double[] oklab(Color color) {
        double r = linear(color.getRed());
        double g = linear(color.getGreen());
        double b = linear(color.getBlue());
        double l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
        double m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
        double s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
        return new double[] {
            0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s
        };
    }

    private static double linear(int level) {
        double s = level / 255.0;
        return s <= 0.04045 ? s / 12.92 : Math.pow((s + 0.055) / 1.055, 2.4);
    }

    private static double apart(Together all, String one, String two, StageColors stage) {
        Map<String, MethodLook> looks = all.looks();
        ChartLook paper = ChartLook.on(stage);
        return apart(looks.get(one).on(paper).color(), looks.get(two).on(paper).color());
    }

    /**
     * Distance of two colours in levels, red and green taken together as by an eye that does not
     * tell them apart.
     */
    private static double apart(Color one, Color two) {
        return Math.hypot(yellow(one) - yellow(two), one.getBlue() - two.getBlue());
    }

    /** Weights of red and green in luminance. */
    private static double yellow(Color color) {
        return 0.23 * color.getRed() + 0.77 * color.getGreen();
    }

    @ParameterizedTest(name = "pixels of {0} drown in the stage")
    @MethodSource("ownColors")
    void edgesStandOutFromBothStages(Color color) {
        for (StageColors stage : List.of(StageColors.LIGHT, StageColors.DARK)) {
            Color edge = MethodColors.edgeOn(stage.ground(), color);
            assertTrue(MethodColors.contrast(edge, stage.ground()) >= 3, edge.toString());
        }
    }

    @ParameterizedTest(name = "{0} looks like a wrong pixel")
    @MethodSource("ownColors")
    void keepsTheColorOfWrongPixelsFree(Color color) {
        assertNotEquals(PixelMark.COLOR, color);
    }

    @Test
    void measuresContrastFromOneToTwentyOne() {
        assertEquals(21, MethodColors.contrast(Color.BLACK, Color.WHITE), 1e-9);
        assertEquals(1, MethodColors.contrast(Color.RED, Color.RED), 1e-9);
    }

    @Test
    void readsInkOnEveryStage() {
        for (StageColors stage : List.of(StageColors.LIGHT, StageColors.DARK)) {
            assertTrue(MethodColors.contrast(stage.ink(), stage.ground()) >= 7);
            assertTrue(MethodColors.contrast(stage.ink(), stage.margin()) >= 7);
        }
    }

    @Test
    @DisplayName("words in a method's colour are too dark on a dark ground, or too pale")
    void wordsInAMethodsColorAreRead() {
        for (StageColors stage :
                List.of(StageColors.LIGHT, StageColors.DARK, StageColors.PROJECTOR))
            for (Color color : ownColors().toList()) {
                Color words = MethodColors.textOn(stage.ground(), color);
                double contrast = MethodColors.contrast(words, stage.ground());
                assertTrue(contrast >= 4.5, color + " on " + stage.ground() + ": " + contrast);
            }
    }
}
