package rasterlab.app.line;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.StageNote;
import rasterlab.app.canvas.ZoomButtons;
import rasterlab.app.canvas.ZoomedGrid;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.line.trace.LineColors;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelSet;
import rasterlab.engine.raster.PixelWindow;
import rasterlab.engine.raster.Plotted;

@Timeout(300)
class LineStageTest {
    private static final int BLUE = LineColors.OWN.of("bresenham").getRGB();

    private static final Rectangle NO_BUTTONS = new Rectangle();

    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final LineLabModel model =
            new LineLabModel(new LineTopic(), Runnable::run, failures::add);

    @AfterEach
    void close() {
        model.close();
        assertEquals(List.of(), failures);
    }

    private static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 13);

    private static LineFrame frame(LineDrawings drawings, double scale) {
        return new LineFrame(
                drawings,
                drawings.drawing().pixels(),
                new ZoomedGrid(100, 60, 20),
                500,
                300,
                scale,
                StageColors.LIGHT,
                FONT,
                "",
                NO_BUTTONS,
                Locale.ENGLISH);
    }

    @Test
    void litPixelIsPaintedInDeviceDotsAtAnyScale() {
        LineDrawings drawn = model.state().drawings();
        for (double scale : new double[] {1, 1.5, 2}) {
            BufferedImage image = frame(drawn, scale).painted(() -> false);
            assertEquals(Math.round(500 * scale), image.getWidth());
            // Pixel (9, 6) is lit; its square's upper left quarter holds no line.
            int x = (int) ((100 + 20 * 9 - 6) * scale);
            int y = (int) ((60 + 20 * 6 + 6) * scale);
            assertEquals(BLUE, image.getRGB(x, y), "scale " + scale);
        }
    }

    @Test
    @DisplayName("where pixels are larger than the ring, an end's label covers its pixel")
    void labelLeavesALargePixelFree() {
        LineDrawings drawn = model.state().drawings();
        var grid = new ZoomedGrid(100, 60, 86);
        BufferedImage image =
                new LineFrame(
                                drawn,
                                drawn.drawing().pixels(),
                                grid,
                                1700,
                                1000,
                                1,
                                StageColors.LIGHT,
                                new Font(Font.SANS_SERIF, Font.PLAIN, 13),
                                "",
                                NO_BUTTONS,
                                Locale.ENGLISH)
                        .painted(() -> false);
        int y = (int) grid.viewY(3) - 43 + 4;
        for (int x = (int) grid.viewX(2) - 38; x < grid.viewX(2) + 38; x++)
            assertEquals(BLUE, image.getRGB(x, y), "at " + x);
    }

    @Test
    void labelsOfEndsSeparateNumbersAsTheLanguageDoes() {
        var segment = new Segment(2, -3, 17, 9);
        assertEquals("A (2, −3)", LineFrame.label(End.A, segment, Language.ENGLISH.locale()));
        assertEquals("B (17; 9)", LineFrame.label(End.B, segment, Language.RUSSIAN.locale()));
    }

    @ParameterizedTest(name = "coverage is painted as whole blocks: {0}")
    @MethodSource("grounds")
    void coverageIsOpacity(StageColors colors) throws InterruptedException {
        model.chooseMethod("wu");
        model.show(new Segment(0, 0, 11, 4));
        model.settle();
        LineDrawings drawn = model.state().drawings();
        BufferedImage image =
                new LineFrame(
                                drawn,
                                drawn.drawing().pixels(),
                                new ZoomedGrid(100, 60, 20),
                                500,
                                300,
                                1,
                                colors,
                                new Font(Font.SANS_SERIF, Font.PLAIN, 13),
                                "",
                                NO_BUTTONS,
                                Locale.ENGLISH)
                        .painted(() -> false);
        Color ground = new Color(image.getRGB(100 + 20 * 9 + 6, 60 + 20 * 8 + 6));
        Color most = new Color(image.getRGB(100 + 20 * 3 - 7, 60 + 20 + 7));
        Color less = new Color(image.getRGB(100 + 20 * 4 + 7, 60 + 20 - 7));
        Color least = new Color(image.getRGB(100 + 20 * 3 - 7, 60 + 20 * 2 + 7));
        double[] contrasts = {
            MethodColors.contrast(most, ground),
            MethodColors.contrast(less, ground),
            MethodColors.contrast(least, ground)
        };
        String said = Arrays.toString(contrasts);
        assertTrue(contrasts[0] >= 2.2, said);
        assertTrue(contrasts[0] > contrasts[1] && contrasts[1] > contrasts[2], said);
        assertTrue(contrasts[2] > 1.02, said);
    }

    static Stream<StageColors> grounds() {
        return Stream.of(StageColors.LIGHT, StageColors.DARK);
    }

    /** Dots in the middle of each side of a lozenge in a square of 20, from its own middle. */
    private static final int[][] LOZENGE = {{4, 5}, {-5, 5}, {5, -5}, {-5, -6}};

    @Test
    void lozengeIsSeenOnEachPixelThatOneMethodHasAlone() throws InterruptedException {
        model.show(new Segment(0, 0, 4, 9));
        model.compareWith("naive-textbook");
        model.settle();
        LineDrawings drawn = model.state().drawings();
        PixelDifference apart = drawn.apart().orElseThrow();
        assertTrue(apart.extra().size() > 2, "nothing to see");
        BufferedImage image = frame(drawn, 1).painted(() -> false);
        for (PixelSet alone : List.of(apart.extra(), apart.missing()))
            for (int i = 0; i < alone.size(); i++) {
                int x = 100 + 20 * alone.x(i);
                int y = 60 + 20 * alone.y(i);
                // Names stand beside the ends.
                if (alone.y(i) < 2 || alone.y(i) > 7) continue;
                int sides = 0;
                for (int[] side : LOZENGE)
                    if (isInk(image.getRGB(x + side[0], y + side[1]))) sides++;
                // The exact line passes over one or two of them.
                assertTrue(sides >= 2, "pixel (%d, %d)".formatted(alone.x(i), alone.y(i)));
            }
    }

    private static boolean isInk(int rgb) {
        var color = new Color(rgb);
        Color ink = StageColors.LIGHT.ink();
        return Math.abs(color.getRed() - ink.getRed()) < 60
                && Math.abs(color.getGreen() - ink.getGreen()) < 60
                && Math.abs(color.getBlue() - ink.getBlue()) < 60;
    }

    @Test
    void windowHasAFrame() throws InterruptedException {
        var whole = new Segment(2, 2, 6, 6);
        assertNotEquals(
                aboveTheWindow(whole), aboveTheWindow(whole.in(new PixelWindow(3, 1, 9, 7))));
    }

    /** A dot on the upper edge of the window's pixel (8, 1), between two lines of the grid. */
    private int aboveTheWindow(Segment segment) throws InterruptedException {
        model.show(segment);
        model.settle();
        return frame(model.state().drawings(), 1)
                .painted(() -> false)
                .getRGB(100 + 20 * 8, 60 + 20 - 10);
    }

    private ZoomedGrid framed(Rectangle view) {
        return ZoomedGrid.fitting(LineFraming.of(model.state()), view);
    }

    @Test
    void windowFarFromTheSegmentIsInSight() {
        model.show(new Segment(0, 0, 5, 2).in(new PixelWindow(30, 40, 50, 60)));
        ZoomedGrid grid = framed(new Rectangle(0, 0, 500, 300));
        assertTrue(grid.viewX(50) < 500 && grid.viewY(60) < 300, grid.toString());
        assertTrue(grid.viewX(0) > 0 && grid.viewY(0) > 0, grid.toString());
    }

    @Test
    void whatAProgramPlottedBesideItsSegmentIsInSight() throws InterruptedException {
        var plotted = new PixelRecording(3);
        plotted.plot(0, 0);
        plotted.plot(15, 18);
        plotted.plot(1_000_000, -1_000_000);
        model.showTried(
                new Segment(0, 0, 9, 3), "bresenham", Optional.of(new Plotted(plotted, false)));
        model.settle();
        ZoomedGrid grid = framed(new Rectangle(0, 0, 500, 300));
        assertTrue(grid.viewX(15) < 500 && grid.viewY(18) < 300, grid.toString());
        assertTrue(grid.cell() >= 8, "the pixel far away leaves nothing of the others: " + grid);
        model.show(new Segment(0, 0, 9, 4));
        ZoomedGrid other = framed(new Rectangle(0, 0, 500, 300));
        assertTrue(other.viewY(18) > 300, "another segment's pixels are in sight: " + other);
    }

    @ParameterizedTest(name = "the note covers a handle: {argumentSetName}")
    @MethodSource("noted")
    void noteCoversNoHandle(Segment segment, Language language) throws InterruptedException {
        var first = new PixelRecording(4000);
        for (int x = 0; x < 4000; x++) first.plot(x, 0);
        model.showTried(segment, "bresenham", Optional.of(new Plotted(first, true)));
        model.settle();
        String said =
                LineNotes.about(model.state().drawings(), Texts.of("line", language)).orElseThrow();
        // In the smallest window, in type of 150 %.
        var inside = new Rectangle(66, 33, 314, 237);
        var note = new StageNote(said, inside, new Font(Font.SANS_SERIF, Font.PLAIN, 20));
        var image = new BufferedImage(380, 270, BufferedImage.TYPE_INT_ARGB);
        note.paint(image.createGraphics(), StageColors.LIGHT);
        ZoomedGrid grid = framed(note.below());
        for (End end : End.values()) {
            Rectangle handle = LineFrame.around(end, segment, grid, note.below(), NO_BUTTONS);
            for (int x = handle.x; x < handle.x + handle.width; x++)
                for (int y = handle.y; y < handle.y + handle.height; y++)
                    assertEquals(0, image.getRGB(x, y), end + " " + handle);
        }
    }

    static Stream<Arguments> noted() {
        return Stream.of(Language.values())
                .flatMap(
                        language ->
                                Stream.of(
                                        argumentSet(
                                                "of end A, " + language,
                                                new Segment(0, 0, 9_999, 0),
                                                language),
                                        argumentSet(
                                                "of end B beyond the upper edge, " + language,
                                                new Segment(0, 0, 3_000, -9_000),
                                                language)));
    }

    @Test
    @DisplayName("the ring of an end near the border is pushed off its pixel")
    void ringNearTheBorderKeepsItsPixelInTheMiddle() {
        var sight = new Rectangle(44, 22, 456, 278);
        var grid = new ZoomedGrid(50, 30, 4);
        Rectangle ring = LineFrame.around(End.A, new Segment(0, 0, 9, 9), grid, sight, NO_BUTTONS);
        assertEquals(50, ring.getCenterX(), 1);
        assertEquals(30, ring.getCenterY(), 1);
    }

    @Test
    @DisplayName("a label hides a lit pixel though there is room beside it")
    void labelsLieOnNoLitPixel() throws InterruptedException {
        var any = new BufferedImage(1, 1, BufferedImage.TYPE_INT_ARGB).createGraphics();
        FontMetrics metrics = any.getFontMetrics(FONT.deriveFont(Font.BOLD));
        any.dispose();
        Rectangle sight = LineFrame.note("", new Dimension(500, 300), FONT).below();
        for (var segment : List.of(new Segment(9, 6, 2, 2), new Segment(2, 2, 60, 40))) {
            model.show(segment);
            model.settle();
            LineFrame frame = frame(model.state().drawings(), 1);
            for (Rectangle label : frame.labels(metrics, sight))
                for (int i = 1; i <= model.state().drawing().pixels(); i++) {
                    int x = 100 + 20 * model.state().drawing().x(i);
                    int y = 60 + 20 * model.state().drawing().y(i);
                    var pixel = new Rectangle(x - 10, y - 10, 20, 20);
                    assertFalse(pixel.intersects(label), segment + ": " + pixel + " " + label);
                }
        }
    }

    @ParameterizedTest(name = "a pinned handle lies on the zoom buttons: of an end at {0}, {1}")
    @CsvSource({"1200000000, 1200000000", "20, 1200000000", "1200000000, 12", "20, 12"})
    void handleOfAnEndOutOfSightKeepsClearOfTheButtons(int x, int y) {
        var sight = new Rectangle(44, 22, 456, 278);
        var buttons = new Rectangle(400, 265, 92, 27);
        var segment = new Segment(0, 0, x, y);
        Rectangle handle =
                LineFrame.around(End.B, segment, new ZoomedGrid(50, 30, 20), sight, buttons);
        assertFalse(handle.intersects(buttons), handle.toString());
        assertTrue(sight.contains(handle), handle.toString());
    }

    @Test
    void buttonsLieOverTheHandles() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    try (var stage =
                            new LineStage(
                                    model, Texts.of("line", Language.ENGLISH), failures::add)) {
                        assertInstanceOf(ZoomButtons.class, stage.getComponent(0));
                    }
                });
    }

    @Test
    void paintingStopsWhenANewerFrameIsAskedFor() throws InterruptedException {
        model.show(new Segment(0, 0, 4000, 3000));
        model.settle();
        LineFrame frame = frame(model.state().drawings(), 1);
        var asked = new AtomicInteger();
        assertThrows(
                CancellationException.class,
                () -> frame.painted(() -> asked.incrementAndGet() > 10));
        assertTrue(asked.get() < 20, "went on for " + asked.get() + " pixels");
    }
}
