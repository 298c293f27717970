package rasterlab.app.line.figure;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.cli.Lab;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.line.FigureReadings;
import rasterlab.app.line.trace.LineMode;
import rasterlab.app.line.trace.LineTrace;
import rasterlab.app.line.trace.RasterPoint;
import rasterlab.engine.raster.PixelSet;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

@Tag("slow")
@Timeout(300)
class FigureLabModelTest {
    private final ModelThread thread = new ModelThread();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final FigureLabModel model = new FigureLabModel(thread, failures::add);

    @AfterEach
    void close() {
        model.close();
        assertEquals(List.of(), failures);
    }

    private FigureDrawing drawing() {
        thread.settle(model::settle);
        return model.state().drawing();
    }

    private ArcFigure arc() {
        return (ArcFigure) model.state().scene().figure();
    }

    @ParameterizedTest(name = "lab and recorded verdict differ: {0}")
    @EnumSource(names = {"CIRCLE", "ELLIPSE"})
    void everyHazardEndsAsItIsRecorded(LineMode mode) {
        for (Hazard<?> hazard : model.hazards(mode)) {
            model.show(mode, hazard.name());
            for (String method : model.methods(mode)) {
                model.chooseMethod(method);
                assertEquals(
                        expected(hazard.recorded().get(method)),
                        drawingText(drawing()),
                        hazard.name() + ", " + method);
            }
        }
    }

    private static String expected(Verdict.Kind kind) {
        return switch (kind) {
            case EXACT -> "right";
            case DEGRADED, WRONG -> "wrong";
            case REFUSED, ENDLESS, CRASHED -> kind.name();
        };
    }

    private static String drawingText(FigureDrawing drawing) {
        if (drawing.ending() != LineTrace.TraceEnding.ENDED) return drawing.ending().name();
        return RightFigure.is(drawing) ? "right" : "wrong";
    }

    /**
     * Figures have at most a million pixels to be judged; a larger figure was compared with the
     * first million of it.
     */
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("tooLarge")
    void methodsAreNotJudgedOnAFigureThatIsTooLarge(
            LineMode mode, ArcFigure figure, LineTrace.TraceEnding ending) {
        model.chooseMode(mode);
        model.compareWith("midpoint");
        model.arc(old -> figure);
        FigureDrawing drawn = drawing();
        assertEquals(ending, drawn.ending());
        assertTrue(drawn.difference().isEmpty(), "it has wrong pixels");
        assertFalse(RightFigure.is(drawn), "it is called right");
        for (Language language : Language.values()) {
            var readings = new FigureReadings(model.state(), Texts.of("line", language));
            assertEquals(
                    List.of("–", "–", "–", "–"),
                    List.of(
                            readings.missing(),
                            readings.extra(),
                            readings.worst(),
                            readings.other()));
        }
        assertEquals(
                ending == LineTrace.TraceEnding.ENDED,
                model.state().drawings().apart().isPresent(),
                "two methods are compared where both ended");
    }

    static Stream<Arguments> tooLarge() {
        return Stream.of(
                argumentSet(
                        "a circle's last pixels are extra ones",
                        LineMode.CIRCLE,
                        new ArcFigure(true, 0, 0, 200_000, 200_000),
                        LineTrace.TraceEnding.ENDED),
                argumentSet(
                        "an ellipse's last pixels are extra ones",
                        LineMode.ELLIPSE,
                        new ArcFigure(false, 0, 0, 400_000, 9),
                        LineTrace.TraceEnding.ENDED),
                argumentSet(
                        "a circle that is cut has no end",
                        LineMode.CIRCLE,
                        new ArcFigure(true, 0, 0, 400_000, 400_000),
                        LineTrace.TraceEnding.CUT),
                argumentSet(
                        "the largest circle takes all memory",
                        LineMode.CIRCLE,
                        new ArcFigure(true, 0, 0, Integer.MAX_VALUE, Integer.MAX_VALUE),
                        LineTrace.TraceEnding.CUT));
    }

    @Test
    void aFigureOfAlmostAMillionPixelsIsJudged() {
        model.arc(old -> old.withRadiusX(176_000));
        assertTrue(RightFigure.is(drawing()), "995,606 pixels");
    }

    @Test
    void radiusIsDraggedAndTheCenterTakesItAlong() {
        model.move(ArcFigure.RADIUS_X, 7.4, 3);
        assertEquals(new ArcFigure(true, 0, 0, 7, 7), arc());
        model.move(ArcFigure.CENTER, 5, -2);
        assertEquals(new ArcFigure(true, 5, -2, 7, 7), arc());
        model.move(ArcFigure.RADIUS_X, 2, 0);
        assertEquals(3, arc().radiusX());
        model.chooseMode(LineMode.ELLIPSE);
        model.move(ArcFigure.RADIUS_Y, 0, 4);
        assertEquals(new ArcFigure(false, 0, 0, 16, 4), arc());
    }

    @Test
    void everyPixelOfAWalkedMethodHasItsDecision() {
        for (LineMode mode : List.of(LineMode.CIRCLE, LineMode.ELLIPSE)) {
            model.chooseMode(mode);
            for (String method : List.of("bresenham", "midpoint")) {
                model.chooseMethod(method);
                FigureDrawing drawn = drawing();
                ArcFigure figure = arc();
                for (int i = 0; i < drawn.steps(); i++) {
                    double u = Math.abs((double) drawn.pixels().x(i) - figure.centerX());
                    double v = Math.abs((double) drawn.pixels().y(i) - figure.centerY());
                    assertTrue(
                            drawn.decisions().containsKey(new RasterPoint(u, v))
                                    || drawn.decisions().containsKey(new RasterPoint(v, u)),
                            method + ", pixel " + i + " of " + mode);
                }
            }
        }
    }

    @ParameterizedTest(name = "pixels of two methods that differ are miscounted: {0}")
    @EnumSource(names = {"CIRCLE", "ELLIPSE"})
    void pixelsThatOneMethodHasAloneAreTold(LineMode mode) {
        model.chooseMode(mode);
        model.chooseMethod("midpoint");
        model.compareWith("bresenham-textbook");
        model.show(mode, mode == LineMode.CIRCLE ? "squares-beyond-int" : "products-beyond-int");
        FigureDrawing chosen = drawing();
        FigureDrawing second = model.state().other().orElseThrow();
        long[] first = lit(chosen);
        long[] other = lit(second);
        var apart = model.state().drawings().apart().orElseThrow();
        assertArrayEquals(without(first, other), sortedPixels(apart.extra()));
        assertArrayEquals(without(other, first), sortedPixels(apart.missing()));
        assertFalse(apart.isEmpty(), "the textbook's method errs");
        model.compareWith("midpoint");
        drawing();
        assertTrue(model.state().drawings().apart().orElseThrow().isEmpty());
    }

    private static long[] lit(FigureDrawing drawing) {
        return sortedPixels(PixelSet.of(drawing.pixels()));
    }

    /** Both numbers of each pixel in one, in order: there are almost a million. */
    private static long[] sortedPixels(PixelSet pixels) {
        return IntStream.range(0, pixels.size())
                .mapToLong(i -> (long) pixels.x(i) << 32 | pixels.y(i) & 0xFFFFFFFFL)
                .sorted()
                .distinct()
                .toArray();
    }

    private static long[] without(long[] all, long[] others) {
        return LongStream.of(all).filter(one -> Arrays.binarySearch(others, one) < 0).toArray();
    }

    @Test
    void aRefusedPictureDiffersFromNone() {
        model.show(LineMode.CIRCLE, "negative-radius");
        model.compareWith("bresenham-textbook");
        drawing();
        assertTrue(model.state().drawings().apart().isEmpty());
    }

    @Test
    void differentPixelsAreCountedAtTheEndOnly() {
        model.chooseMethod("midpoint");
        model.compareWith("bresenham-textbook");
        model.show(LineMode.CIRCLE, "squares-beyond-int");
        drawing();
        Texts texts = Texts.of("line", Language.ENGLISH);
        var apart = model.state().drawings().apart().orElseThrow();
        int more = apart.extra().size();
        int fewer = apart.missing().size();
        assertEquals(
                String.format(Locale.ENGLISH, "%,d: %,d + %,d", more + fewer, more, fewer),
                new FigureReadings(model.state(), texts).apart());
        model.goTo(2);
        assertEquals("known at the end", new FigureReadings(model.state(), texts).apart());
    }

    @Test
    void onAStepExtraPixelsAreThoseLitSoFar() {
        model.chooseMethod("bresenham-textbook");
        model.compareWith("parametric");
        model.show(LineMode.CIRCLE, "squares-beyond-int");
        long all = drawing().deviation().extra();
        Texts texts = Texts.of("line", Language.ENGLISH);
        assertEquals(
                String.format(Locale.ENGLISH, "%,d pixels", all),
                new FigureReadings(model.state(), texts).extra());
        model.goTo(1);
        var readings = new FigureReadings(model.state(), texts);
        assertEquals("none", readings.extra());
        for (String said : List.of(readings.missing(), readings.worst()))
            assertEquals("known at the end", said);
        assertEquals("0 extra so far", readings.other());
    }

    @Test
    void fullPixelsAreBrightAlongRowsAndDarkAt45Degrees() {
        model.chooseMode(LineMode.BRIGHTNESS);
        List<Double> light = drawing().brightness();
        assertEquals(1, light.get(0), 1e-3);
        assertEquals(1, light.get(90), 1e-3);
        assertEquals(Math.sqrt(0.5), light.get(45), 1e-3);
    }

    @Test
    void everyMethodsBrightnessIsMeasuredToItsEnd() {
        model.chooseMode(LineMode.BRIGHTNESS);
        for (String method : model.methods(LineMode.BRIGHTNESS)) {
            model.chooseMethod(method);
            assertEquals(91, drawing().brightness().size(), method);
        }
        model.chooseMethod("naive-textbook");
        assertFalse(drawing().brightness().get(80) > 0.5, "gaps of a steep line take its light");
    }

    @Test
    void widerPenLightsMorePixelsAndDashesFewer() {
        PenFigure first = PenFigure.first();
        assertTrue(first.withWidth(9).lit() > first.lit());
        assertTrue(first.withDashes(Dashes.DASHED).lit() < first.lit());
        assertTrue(first.withRound(false).lit() < first.lit());
    }

    @Test
    void pointsOfAPensLineAreAddedAndRemovedDownToTwo() {
        model.chooseMode(LineMode.PEN);
        model.add(20, 40);
        assertEquals(5, model.state().scene().figure().grips().size());
        for (int i = 0; i < 9; i++) model.remove("point.0");
        assertEquals(2, model.state().scene().figure().grips().size());
        drawing();
    }

    @Test
    @DisplayName("undo of a drag moves the view, or undo of a hazard leaves it there")
    void undoBringsBackTheViewOfItsFigure() {
        int before = model.state().arrangement();
        model.move(ArcFigure.RADIUS_X, 5, 0);
        model.history().undo();
        assertEquals(before, model.state().arrangement());
        assertEquals(0, model.state().sought());
        model.show(LineMode.CIRCLE, "radius-0");
        assertFalse(before == model.state().arrangement());
        model.history().undo();
        assertEquals(before, model.state().arrangement());
        drawing();
    }

    @Test
    void eachModeKeepsItsFigureAndUndoGoesBack() {
        model.move(ArcFigure.RADIUS_X, 5, 0);
        FigureScene circle = model.state().scene();
        model.chooseMode(LineMode.PEN);
        model.chooseMode(LineMode.CIRCLE);
        assertEquals(circle, model.state().scene());
        model.beginDrag();
        for (int x = 6; x < 12; x++) model.move(ArcFigure.RADIUS_X, x, 0);
        model.endDrag();
        model.history().undo();
        assertEquals(circle, model.state().scene());
        model.reset();
        assertEquals(FigureScene.first(LineMode.CIRCLE), model.state().scene());
        drawing();
    }

    @Test
    void copiedCommandDrawsTheSamePixels() throws Exception {
        for (LineMode mode : List.of(LineMode.CIRCLE, LineMode.ELLIPSE)) {
            model.chooseMode(mode);
            model.chooseMethod("parametric");
            model.move(ArcFigure.CENTER, 3, -4);
            String command = FigureCommand.of(model.state().scene()).orElseThrow();
            String json = command.substring(6, command.lastIndexOf('\''));
            var out = new ByteArrayOutputStream();
            int exit =
                    Lab.run(
                            command.substring(command.indexOf("./lab") + 6).split(" "),
                            new ByteArrayInputStream(json.getBytes(StandardCharsets.UTF_8)),
                            new PrintStream(out),
                            System.err);
            assertEquals(0, exit);
            var pixels = new ObjectMapper().readTree(out.toByteArray()).path("pixels");
            FigureDrawing drawn = drawing();
            assertEquals(drawn.steps(), pixels.size());
            assertEquals(drawn.pixels().x(7), pixels.path(7).path(0).asInt());
            assertEquals(drawn.pixels().y(7), pixels.path(7).path(1).asInt());
        }
    }

    @Test
    void unknownNamesAreRefused() {
        assertThrows(IllegalArgumentException.class, () -> model.chooseMethod("guess"));
        assertThrows(IllegalArgumentException.class, () -> model.chooseMode(LineMode.SEGMENT));
        assertThrows(IllegalArgumentException.class, () -> model.show(LineMode.CIRCLE, "no-such"));
    }
}
