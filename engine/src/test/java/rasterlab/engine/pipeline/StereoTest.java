package rasterlab.engine.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.joml.Vector4d;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.pipeline.Stereo.StereoMode;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.transform.StereoPair;

class StereoTest {
    private static final SphericalView CAMERA = new SphericalView(0, Math.PI / 2, 10);
    private static final double EYES = 2;

    private final Renderer renderer = new Renderer();

    /** A white square of side 1 at world x, whose middle is at (x, 0, 0). */
    private static Scene square(double x) {
        double[] xyz = {x, -0.5, -0.5, x, 0.5, -0.5, x, 0.5, 0.5, x, -0.5, 0.5};
        var mesh = new Mesh(xyz, new int[][] {{0, 1, 2, 3}});
        return Scene.dull("square", mesh, new int[] {0xFFFFFF}, 0, CAMERA, 100);
    }

    private Raster draw(Scene scene, String method, StereoMode kind, int width) {
        var plain = new RenderRequest(scene, method, "tone", "perspective", CAMERA, width, 300);
        return renderer.render(
                plain.with(plain.look().withStereo(new Stereo(kind, EYES))), () -> false);
    }

    static Stream<Arguments> depths() {
        return Stream.of("painter", "zfloat", "raycast", "plain")
                .flatMap(
                        method ->
                                Stream.of(-5.0, 0.0, 4.0)
                                        .map(x -> argumentSet(method + " at " + x, method, x)));
    }

    @ParameterizedTest(name = "eyes are exchanged, or not on one picture plane: {argumentSetName}")
    @MethodSource("depths")
    void eyesSeeWhatTheStereoPairSays(String method, double x) {
        Raster both = draw(square(x), method, StereoMode.ANAGLYPH, 400);
        double pixelsPerUnit = 100 * 0.5;
        var pair = new StereoPair(CAMERA, EYES);
        double parallax = middle(both, 16) - middle(both, 8);
        double apart = EYES * (CAMERA.rho() / (10 - x) - 1);
        assertEquals(apart * pixelsPerUnit, parallax, 1.01);
        Vector4d left = pair.left().transform(new Vector4d(x, 0, 0, 1));
        assertEquals(200 + pixelsPerUnit * left.x / left.w, middle(both, 16), 1.01);
    }

    /** The middle column of the lit pixels of a channel in the middle row. */
    private static double middle(Raster picture, int shift) {
        int first = -1;
        int last = -1;
        for (int x = 0; x < picture.width(); x++) {
            if ((picture.argb(x, 150) >> shift & 255) < 128) continue;
            if (first < 0) first = x;
            last = x;
        }
        return (first + last) / 2.0;
    }

    @Test
    @DisplayName("halves are exchanged, squeezed or overlap")
    void halvesStandSideBySide() {
        for (int width : new int[] {400, 401}) {
            Raster both = draw(square(4), "zfloat", StereoMode.SIDE_BY_SIDE, width);
            int[] columns = {-1, -1};
            for (int x = 0; x < width; x++)
                if (both.argb(x, 150) == 0xFFFFFFFF) columns[x < width / 2 ? 0 : 1] = x;
            assertTrue(columns[0] > 0 && columns[1] > 0, "one half is empty");
            int inRight = columns[1] - (width - 200);
            assertTrue(columns[0] > inRight, columns[0] + " > " + inRight + ": near, so crossed");
        }
    }

    @Test
    @DisplayName("red is the right eye's, or a colour's brightness is its largest channel")
    void anaglyphHasBrightnessOnly() {
        Scene scene = square(0);
        var blue = Scene.dull("blue", scene.mesh(), new int[] {0x0000FF}, 0, CAMERA, 100);
        Raster both = draw(blue, "zfloat", StereoMode.ANAGLYPH, 400);
        assertEquals("ff1d1d1d", Integer.toHexString(both.argb(200, 150)));
    }
}
