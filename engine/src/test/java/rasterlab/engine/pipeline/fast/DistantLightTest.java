package rasterlab.engine.pipeline.fast;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.engine.scene.VertexQuantity;

/** The loops over arrays against the formula, one point at a time in doubles. */
class DistantLightTest {
    private static final double[] TO_LIGHT = {3, -1, 2};
    private static final int RGB = 0xE68040;

    private final Random random = new Random(1977);

    @ParameterizedTest(name = "shininess {0}")
    @CsvSource({"1", "2", "31", "32", "200"})
    void pixelsAreWithinOneLevelOfTheFormula(int shininess) {
        var light = new DistantLight(TO_LIGHT, RGB, 0.2, 0.5, shininess);
        var batch = new PixelBatch(new PlainLoops());
        batch.begin(light);
        batch.count = PixelBatch.SIZE;
        for (VertexQuantity quantity : light.wants())
            for (int i = 0; i < batch.count; i++)
                batch.values(quantity)[i] = random.nextFloat() * 4 - 2;
        double[][] expected = new double[batch.count][];
        for (int i = 0; i < batch.count; i++)
            expected[i] =
                    formula(
                            vector(batch, VertexQuantity.X, i),
                            vector(batch, VertexQuantity.NORMAL_X, i),
                            shininess);
        light.color(batch);
        for (int i = 0; i < batch.count; i++)
            for (int c = 0; c < 3; c++)
                assertEquals(expected[i][c], batch.argb[i] >> 16 - 8 * c & 255, 1, "pixel " + i);
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
