package rasterlab.engine.pipeline;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.study.Method;
import rasterlab.engine.visibility.FaceOutlines;
import rasterlab.engine.visibility.VisibilityStep;
import rasterlab.engine.visibility.VisibilityWalk;
import rasterlab.engine.visibility.buffer.PixelTouch;
import rasterlab.engine.visibility.buffer.PixelTouch.TouchOutcome;
import rasterlab.engine.visibility.painter.PiecesWalk;

class FaceDrawingTest {
    private static final int WIDTH = 120;
    private static final int HEIGHT = 90;

    private static RenderRequest request(String scene, String method) {
        var found = Scenes.named(scene);
        return new RenderRequest(
                found, method, "flat", "perspective", found.defaultCamera(), WIDTH, HEIGHT);
    }

    private static FaceDrawing drawing(String scene, String method) {
        return FaceDrawing.of(request(scene, method)).orElseThrow();
    }

    private static Raster whole(String scene, String method) {
        try (var renderer = new Renderer()) {
            return renderer.render(request(scene, method), () -> false);
        }
    }

    static Stream<String> methods() {
        return Renderer.visibilityMethods().stream()
                .map(Method::name)
                .filter(name -> !name.equals("convex") && !name.equals("pipeline"));
    }

    @ParameterizedTest(name = "steps leave another picture than the method: {0}")
    @MethodSource("methods")
    void allStepsTogetherAreThePicture(String method) {
        FaceDrawing drawing = drawing("cyclic-overlap", method);
        if (!drawing.hasSteps()) return;
        Raster out = drawing.blank();
        VisibilityWalk walk = drawing.walk(out);
        while (walk.advance()) assertFalse(Double.isNaN(walk.step().value()));
        assertArrayEquals(whole("cyclic-overlap", method).argb(), out.argb());
    }

    @ParameterizedTest(name = "the history ends in another colour than the picture: {0}")
    @MethodSource("methods")
    void lastColorIsThePicturesOwn(String method) {
        FaceDrawing drawing = drawing("interpenetrating", method);
        Raster picture = whole("interpenetrating", method);
        for (int x = 5; x < WIDTH; x += 23)
            for (int y = 7; y < HEIGHT; y += 17) {
                List<PixelTouch> touches = drawing.history(x, y, () -> false);
                int last =
                        touches.isEmpty()
                                ? drawing.backgroundArgb()
                                : touches.get(touches.size() - 1).after();
                assertEquals(picture.argb(x, y), last, "pixel (" + x + ", " + y + ")");
            }
    }

    @ParameterizedTest(name = "a colour is lost between two touches: {0}")
    @ValueSource(strings = {"painter", "zfloat", "none", "bsp"})
    void eachTouchBeginsWhereTheLastEnded(String method) {
        int color = drawing("interpenetrating", method).backgroundArgb();
        for (PixelTouch touch : drawing("interpenetrating", method).history(60, 45, () -> false)) {
            assertEquals(color, touch.before());
            color = touch.after();
        }
    }

    @Test
    void depthTestLetsOnlyNearerFacesThrough() {
        List<PixelTouch> touches =
                drawing("interpenetrating", "zfloat").history(60, 45, () -> false);
        assertTrue(touches.stream().anyMatch(touch -> touch.verdict() == TouchOutcome.FAILED));
        for (PixelTouch touch : touches) {
            var test = touch.test().orElseThrow();
            boolean nearer = test.held().isEmpty() || test.offered() > test.held().getAsDouble();
            assertEquals(nearer, touch.verdict() == TouchOutcome.DRAWN, touch.toString());
        }
    }

    @ParameterizedTest(name = "the buffer holds no depth of a face there: {0}")
    @ValueSource(strings = {"z16", "z24", "z32", "zfloat", "reversed-z"})
    void bufferHoldsWhatTheLastDrawnFaceOffered(String method) {
        FaceDrawing drawing = drawing("interpenetrating", method);
        PixelTouch seen =
                drawing.history(60, 45, () -> false).stream()
                        .filter(touch -> touch.verdict() == TouchOutcome.DRAWN)
                        .reduce((a, b) -> b)
                        .orElseThrow();
        double held = drawing.depths(Integer.MAX_VALUE, () -> false).at(60, 45).orElseThrow();
        assertEquals(seen.test().orElseThrow().offered(), held);
    }

    @Test
    void storedDepthsAreThoseOfTheirFormat() {
        double share = held("reversed-z");
        assertTrue(share > 0 && share < 1, "share " + share);
        double code = held("z16");
        assertTrue(code > 0 && code < 65535 && code == Math.rint(code), "code " + code);
        // Window depth runs the other way; both formats stand for one depth.
        assertEquals(share, 1 - code / 65534, 1e-3);
        assertEquals(held("z16") / 65534, held("z32") / 4294967294.0, 1e-4);
    }

    private static double held(String method) {
        return drawing("interpenetrating", method)
                .depths(Integer.MAX_VALUE, () -> false)
                .at(60, 45)
                .orElseThrow();
    }

    @Test
    @DisplayName("steps of a method without depths are taken for those of another's buffer")
    void depthsOfAnotherMethodAreAllThere() {
        int[] all =
                drawing("interpenetrating", "zfloat").depths(10_000, () -> false).picture(0).argb();
        FaceDrawing painted = drawing("interpenetrating", "painter");
        assertArrayEquals(all, painted.depths(1, () -> false).picture(0).argb());
    }

    @Test
    void nearestPixelsOfABufferAreTheLightest() {
        var out = drawing("interpenetrating", "z24").depths(Integer.MAX_VALUE, () -> false);
        int[] argb = out.picture(0xFF0000FF).argb();
        double nearest = Double.POSITIVE_INFINITY;
        int lightest = 0;
        int at = 0;
        for (int i = 0; i < argb.length; i++) {
            if (argb[i] == 0xFF0000FF) continue;
            double depth = out.at(i % WIDTH, i / WIDTH).orElseThrow();
            if (depth < nearest) {
                nearest = depth;
                at = i;
            }
            lightest = Math.max(lightest, argb[i] & 255);
        }
        assertEquals(lightest, argb[at] & 255);
        assertEquals(250, lightest);
    }

    @Test
    void culledFaceIsNamedAsLeftOut() {
        List<PixelTouch> touches = drawing("cube", "back-face").history(60, 45, () -> false);
        assertEquals(TouchOutcome.DRAWN, touches.get(0).verdict());
        assertEquals(TouchOutcome.LEFT_OUT, touches.get(1).verdict());
        assertTrue(touches.get(0).z() < touches.get(1).z(), touches.toString());
    }

    @Test
    void outlineIsATouchOfItsOwn() {
        RenderRequest outlined = request("cube", "painter").withOutline();
        FaceDrawing drawing = FaceDrawing.of(outlined).orElseThrow();
        boolean found = false;
        for (int x = 0; x < WIDTH && !found; x++)
            found =
                    drawing.history(x, 45, () -> false).stream()
                            .anyMatch(touch -> touch.verdict() == TouchOutcome.OUTLINED);
        assertTrue(found, "no outline on a row across the cube");
    }

    @ParameterizedTest(name = "a cut piece has the corners of its whole face: {0}")
    @ValueSource(strings = {"newell", "bsp"})
    void piecesOfCutFacesAreWithinThePicture(String method) {
        FaceDrawing drawing = drawing("cyclic-overlap", method);
        var walk = (PiecesWalk) drawing.walk(drawing.blank());
        int pieces = 0;
        while (walk.advance()) {
            if (walk.piece().isEmpty()) continue;
            pieces++;
            int face = ((VisibilityStep.FaceDrawn) walk.step()).face();
            double[] whole = FaceOutlines.corners(drawing.view(), face);
            assertTrue(area(walk.piece().get()) < 0.999 * area(whole), "face " + face);
        }
        assertTrue(pieces >= 2, "pieces " + pieces);
    }

    private static double area(double[] xy) {
        double twice = 0;
        for (int i = 0; i < xy.length; i += 2) {
            int j = (i + 2) % xy.length;
            twice += xy[i] * xy[j + 1] - xy[j] * xy[i + 1];
        }
        return Math.abs(twice) / 2;
    }

    @Test
    void wiresAndTwoEyesHaveNoFacesToWatch() {
        RenderRequest wire = request("cube", "zfloat").withShading(ShadingMethod.WIRE);
        assertTrue(FaceDrawing.of(wire).isEmpty());
        RenderRequest flat = request("cube", "zfloat");
        var eyes = new Stereo(Stereo.StereoMode.ANAGLYPH, 0);
        assertTrue(FaceDrawing.of(flat.with(flat.look().withStereo(eyes))).isEmpty());
    }

    @Test
    void pixelOutsideIsRefusedByName() {
        FaceDrawing drawing = drawing("cube", "zfloat");
        var refusal =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> drawing.history(WIDTH, 0, () -> false));
        assertEquals("pixel must be in a picture of 120×90, got (120, 0)", refusal.getMessage());
    }
}
