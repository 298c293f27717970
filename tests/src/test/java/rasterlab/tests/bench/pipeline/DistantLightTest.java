package rasterlab.tests.bench.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import org.joml.Matrix4d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.engine.pipeline.fast.PixelBatch;
import rasterlab.engine.pipeline.fast.PixelColors;
import rasterlab.engine.pipeline.fast.Surface;
import rasterlab.engine.pipeline.fast.TrianglePipeline;
import rasterlab.engine.pipeline.fast.TriangleView;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.TriangleMesh;
import rasterlab.engine.scene.VertexQuantity;
import rasterlab.engine.transform.GlMatrices;

/** The loops over arrays against the formula, one point at a time in doubles. */
class DistantLightTest {
    private static final double[] TO_LIGHT = {3, -1, 2};
    private static final int RGB = 0xE68040;
    private static final int SIDE = 64;
    private static final int TRIANGLES = 40;

    private final Random random = new Random(1977);

    /** Triangles across the picture, with normals in all directions: many batches of pixels. */
    @ParameterizedTest(name = "shininess {0}")
    @CsvSource({"1", "2", "31", "32", "200"})
    void pixelsAreWithinOneLevelOfTheFormula(int shininess) {
        var light = new DistantLight(TO_LIGHT, RGB, 0.2, 0.5, shininess);
        var compared = new AtomicInteger();
        var colors =
                new PixelColors() {
                    @Override
                    public Set<VertexQuantity> wants() {
                        return light.wants();
                    }

                    @Override
                    public Set<VertexQuantity> directions() {
                        return light.directions();
                    }

                    @Override
                    public void color(PixelBatch batch) {
                        double[][] expected = new double[batch.count][];
                        for (int i = 0; i < batch.count; i++)
                            expected[i] =
                                    formula(
                                            vector(batch, VertexQuantity.X, i),
                                            vector(batch, VertexQuantity.NORMAL_X, i),
                                            shininess);
                        light.color(batch);
                        for (int i = 0; i < batch.count; i++)
                            assertNear(expected[i], batch.argb[i]);
                        compared.addAndGet(batch.count);
                    }
                };
        var view = new TriangleView(new Matrix4d(), GlMatrices.ortho(-2, 2, -2, 2, -2, 2));
        try (var pipeline = new TrianglePipeline(1)) {
            var surface = new Surface.PerPixel(colors);
            pipeline.drawOn(0, triangles(), view, surface, new Raster(SIDE, SIDE), () -> false);
        }
        assertTrue(compared.get() > 1000, compared + " pixels were compared");
    }

    private TriangleMesh triangles() {
        float[][] numbers = new float[6][3 * TRIANGLES];
        int[] corners = new int[3 * TRIANGLES];
        for (int v = 0; v < corners.length; v++) {
            for (float[] each : numbers) each[v] = random.nextFloat() * 4 - 2;
            double[] normal = unit(new double[] {numbers[3][v], numbers[4][v], numbers[5][v]});
            for (int k = 0; k < 3; k++) numbers[3 + k][v] = (float) normal[k];
            corners[v] = v;
        }
        return TriangleMesh.of(numbers[0], numbers[1], numbers[2], corners)
                .withNormals(numbers[3], numbers[4], numbers[5]);
    }

    private static void assertNear(double[] levels, int argb) {
        for (int c = 0; c < 3; c++) assertEquals(levels[c], argb >> 16 - 8 * c & 255, 1);
    }

    private static double[] vector(PixelBatch batch, VertexQuantity first, int i) {
        double[] v = new double[3];
        for (int k = 0; k < 3; k++)
            v[k] = batch.values(VertexQuantity.values()[first.ordinal() + k])[i];
        return v;
    }

    private static double[] formula(double[] place, double[] normal, int shininess) {
        double[] n = unit(normal);
        double[] l = unit(TO_LIGHT);
        double[] p = unit(place);
        double[] h = unit(new double[] {l[0] - p[0], l[1] - p[1], l[2] - p[2]});
        double diffuse = Math.max(0, dot(n, l));
        double highlight = diffuse > 0 ? Math.pow(Math.max(0, dot(n, h)), shininess) : 0;
        double[] levels = new double[3];
        for (int c = 0; c < 3; c++) {
            double base = (RGB >> 16 - 8 * c & 255) / 255.0;
            levels[c] = 255 * Math.min(1, base * (0.2 + 0.8 * diffuse) + 0.5 * highlight);
        }
        return levels;
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    private static double[] unit(double[] v) {
        double length = Math.sqrt(dot(v, v));
        return new double[] {v[0] / length, v[1] / length, v[2] / length};
    }

    @Test
    void refusesWhatHasNoMeaning() {
        var zero =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> new DistantLight(new double[3], RGB, 0.2, 0.5, 9));
        assertEquals(
                "direction to the light must be finite and not zero, got (0.0, 0.0, 0.0)",
                zero.getMessage());
        var shiny =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> new DistantLight(TO_LIGHT, RGB, 0.2, 0.5, 201));
        assertEquals("shininess must be from 1 to 200, got 201", shiny.getMessage());
    }
}
