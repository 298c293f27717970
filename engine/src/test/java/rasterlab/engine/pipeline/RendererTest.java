package rasterlab.engine.pipeline;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.transform.SphericalView;

class RendererTest {
    private static final int BACKGROUND = 0xFF000000 | Scenes.named("vase").backgroundRgb();

    private final Renderer renderer = new Renderer();
    private final Scene vase = Scenes.named("vase");

    /** The methods that draw a scene whatever it is; the open vase is none for the other two. */
    static Stream<String> methods() {
        return Renderer.visibilities().stream()
                .filter(method -> !List.of("back-face", "convex").contains(method));
    }

    @ParameterizedTest(name = "picture is mirrored or upside down: {0}")
    @MethodSource("methods")
    void drawsRightOfTheMiddleAndAboveIt(String method) {
        double[] xyz = {0, 2, 1, 0, 5, 1, 0, 5, 3, 0, 2, 3};
        double onePixelPerUnit = 1 / Math.min(13 / 800.0, 7 / 600.0);
        var flag =
                Scene.dull(
                        "flag",
                        new Mesh(xyz, new int[][] {{0, 1, 2, 3}}),
                        new int[] {0xFFFFFF},
                        0x000000,
                        new SphericalView(0, Math.PI / 2, 100),
                        onePixelPerUnit);
        assertEquals(
                "........###.. ........###.. ............. ............. "
                        + "............. ............. ............. ",
                text(draw(flag, method, flag.defaultCamera(), 13, 7)));
    }

    @ParameterizedTest(name = "vase stands on its head: {0}")
    @MethodSource("methods")
    void defaultVaseStandsUprightAndIsSeenFromBelow(String method) {
        Raster picture = draw(vase, method, vase.defaultCamera(), 800, 600);
        int neck = width(picture, 200);
        int belly = width(picture, 340);
        int foot = width(picture, 430);
        assertTrue(neck < foot && foot < belly, neck + " < " + foot + " < " + belly);
        int bottom = picture.argb(400, 425);
        assertTrue((bottom >> 16 & 255) > 2 * (bottom & 255), Integer.toHexString(bottom));
    }

    @ParameterizedTest(name = "vase has a lid: {0}")
    @MethodSource("methods")
    void bottomIsSeenThroughTheOpenTopAtSixTenthsOfItsTone(String method) {
        Raster picture = draw(vase, method, new SphericalView(0, 0, 500), 800, 600);
        assertEquals("ff7d5c27", Integer.toHexString(picture.argb(400, 300)));
    }

    @ParameterizedTest(name = "camera inside the vase sees the background: {0}")
    @MethodSource("methods")
    void levelEyeInsideTheVaseSeesOnlyItsWallBelowTheHorizon(String method) {
        Raster picture = draw(vase, method, new SphericalView(0.3, Math.PI / 2, 5), 80, 60);
        for (int i = 30 * 80; i < picture.argb().length; i++)
            assertTrue(
                    picture.argb()[i] != BACKGROUND,
                    "pixel (%d, %d) is background".formatted(i % 80, i / 80));
    }

    @ParameterizedTest(name = "smallest picture fails: {0}")
    @MethodSource("methods")
    void onePixelShowsWhatIsInTheMiddle(String method) {
        Raster picture = draw(vase, method, new SphericalView(0, 0, 500), 1, 1);
        int roundedToNothing = BACKGROUND;
        assertEquals(
                method.equals("painter-textbook") ? roundedToNothing : 0xFF7D5C27,
                picture.argb(0, 0));
    }

    @ParameterizedTest(name = "last frame shines through: {0}")
    @MethodSource("methods")
    void laterFrameEqualsAFreshOne(String method) {
        var near = new SphericalView(1, 1, 300);
        var used = new Raster(160, 120);
        renderer.render(request(vase, method, vase.defaultCamera(), 160, 120), used, () -> false);
        renderer.render(request(vase, method, near, 160, 120), used, () -> false);
        var fresh = new Renderer().render(request(vase, method, near, 160, 120), () -> false);
        assertArrayEquals(fresh.argb(), used.argb());
    }

    @ParameterizedTest(name = "cancel is not asked while drawing: {0}")
    @MethodSource("methods")
    void stopsInTheMiddle(String method) {
        var asked = new AtomicInteger();
        var request = request(vase, method, vase.defaultCamera(), 80, 60);
        assertThrows(
                CancellationException.class,
                () -> renderer.render(request, () -> asked.incrementAndGet() > 20));
        renderer.render(request, () -> false);
    }

    @ParameterizedTest(name = "outline is drawn in the fill's colour: {0}")
    @ValueSource(strings = {"tone", "flat", "gouraud", "phong"})
    void outlineIsDarkerThanTheFill(String shading) {
        var level = new SphericalView(0, Math.PI / 2, 500);
        var request =
                request(vase, "painter", level, 800, 600).withShading(ShadingMethod.named(shading));
        Raster plain = renderer.render(request, () -> false);
        Raster outlined = renderer.render(request.withOutline(), () -> false);
        int darker = 0;
        for (int i = 0; i < plain.argb().length; i++)
            if (plain.argb()[i] != BACKGROUND
                    && (outlined.argb()[i] & 255) > 20
                    && (outlined.argb()[i] & 255) < (plain.argb()[i] & 255)) darker++;
        assertTrue(darker > 2000, darker + " pixels are darker");
    }

    @Test
    @DisplayName("a picture of another size is written")
    void refusesAnotherSize() {
        var request = request(vase, "zfloat", vase.defaultCamera(), 4, 3);
        var refusal =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> renderer.render(request, new Raster(3, 4), () -> false));
        assertEquals("picture must have the requested size 4×3, got 3×4", refusal.getMessage());
    }

    private Raster draw(Scene scene, String method, SphericalView camera, int w, int h) {
        return renderer.render(request(scene, method, camera, w, h), () -> false);
    }

    private static RenderRequest request(
            Scene scene, String method, SphericalView camera, int width, int height) {
        return new RenderRequest(scene, method, "tone", "perspective", camera, width, height);
    }

    private static int width(Raster picture, int row) {
        int width = 0;
        for (int x = 0; x < picture.width(); x++) if (picture.argb(x, row) != BACKGROUND) width++;
        return width;
    }

    private static String text(Raster picture) {
        var text = new StringBuilder();
        for (int y = 0; y < picture.height(); y++) {
            for (int x = 0; x < picture.width(); x++)
                text.append(picture.argb(x, y) == 0xFF000000 ? '.' : '#');
            text.append(' ');
        }
        return text.toString();
    }
}
