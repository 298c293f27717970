package rasterlab.engine.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Appearance;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.SceneLight;
import rasterlab.engine.transform.SphericalView;

/** A white square, red on the left, green on the right, seen from above. */
class VertexColorsTest {
    private static final int SIZE = 40;
    private static final double[] RED_GREEN = {1, 0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0};

    private static Scene scene(double[] colors) {
        Mesh square =
                new Mesh(
                                new double[] {-50, -50, 0, 50, -50, 0, 50, 50, 0, -50, 50, 0},
                                new int[][] {{0, 1, 2, 3}})
                        .withNormals(new double[] {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
        return new Scene(
                "square",
                colors.length == 0 ? square : square.withColors(colors),
                List.of(Appearance.dull(0xFFFFFF)),
                new int[] {0},
                SceneLight.lampAtEye(),
                0,
                new SphericalView(-Math.PI / 2, 0.01, 500),
                4);
    }

    private static int[] pixels(double[] colors, String visibility, ShadingMethod shading) {
        Scene scene = scene(colors);
        var request =
                new RenderRequest(
                        scene,
                        visibility,
                        shading.code(),
                        "perspective",
                        scene.defaultCamera(),
                        SIZE,
                        SIZE);
        try (var renderer = new Renderer()) {
            Raster out = renderer.render(request, () -> false);
            return out.argb();
        }
    }

    static Stream<Arguments> ways() {
        return Stream.of("zfloat", "painter", "raycast", Renderer.PLAIN, Renderer.PIPELINE)
                .flatMap(
                        visibility ->
                                Stream.of(ShadingMethod.GOURAUD, ShadingMethod.PHONG)
                                        .map(shading -> Arguments.of(visibility, shading)));
    }

    @ParameterizedTest(name = "{0} with {1} shading loses the corners' colours")
    @MethodSource("ways")
    void mixesColorsBetweenCorners(String visibility, ShadingMethod shading) {
        double[] white = new double[12];
        Arrays.fill(white, 1);
        int[] argb = pixels(RED_GREEN, visibility, shading);
        int[] plain = pixels(new double[0], visibility, shading);
        int row = SIZE / 2 * SIZE;
        int drawn = 0;
        for (int x = 0; x < SIZE; x++) {
            if ((plain[row + x] & 0xFFFFFF) == 0) continue;
            drawn++;
            int red = argb[row + x] >> 16 & 255;
            int green = argb[row + x] >> 8 & 255;
            int whole = plain[row + x] >> 8 & 255;
            assertEquals(whole, red + green, 3, "pixel " + x);
            assertEquals(0, argb[row + x] & 255, "pixel " + x);
        }
        assertTrue(drawn > SIZE / 3, "drawn " + drawn);
        int left = argb[row + SIZE / 2 - drawn / 2 + 1];
        assertTrue((left >> 16 & 255) > 2 * (left >> 8 & 255), Integer.toHexString(left));
        assertTrue(Arrays.equals(plain, pixels(white, visibility, shading)), "white tints");
    }

    @ParameterizedTest(name = "{0} shading loses the corners' colours")
    @MethodSource("facewise")
    void facesHaveTheMeanOfTheirCorners(ShadingMethod shading) {
        int middle = pixels(RED_GREEN, "zfloat", shading)[SIZE / 2 * SIZE + SIZE / 2];
        assertEquals(middle >> 16 & 255, middle >> 8 & 255);
        assertEquals(0, middle & 255);
        assertTrue((middle & 0xFFFFFF) != 0);
    }

    static Stream<ShadingMethod> facewise() {
        return Stream.of(ShadingMethod.FLAT, ShadingMethod.TONE);
    }

    @Test
    @DisplayName("a colour beyond 1 is let in")
    void refusesColorsBeyondOne() {
        double[] bright = RED_GREEN.clone();
        bright[5] = 1.5;
        assertEquals(
                "corner 1: colour (0.0, 1.0, 1.5) must have shares from 0 to 1",
                assertThrows(IllegalArgumentException.class, () -> scene(bright)).getMessage());
    }
}
