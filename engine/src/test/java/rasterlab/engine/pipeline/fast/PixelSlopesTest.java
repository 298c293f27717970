package rasterlab.engine.pipeline.fast;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static rasterlab.engine.scene.VertexQuantity.TEXTURE_S;
import static rasterlab.engine.scene.VertexQuantity.TEXTURE_T;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.function.BiConsumer;
import org.joml.Matrix4d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.scene.TriangleMesh;
import rasterlab.engine.scene.VertexQuantity;
import rasterlab.engine.texture.DetailLevel;
import rasterlab.engine.transform.GlMatrices;

/** Slopes of texture coordinates on triangles that lean back, some hundred in a batch. */
class PixelSlopesTest {
    private static final int SIDE = 40;
    private static final Set<VertexQuantity> COORDINATES = EnumSet.of(TEXTURE_S, TEXTURE_T);

    private int compared;

    /** Gives each batch to a check. */
    private record Checked(boolean linear, BiConsumer<PixelBatch, Slopes> check)
            implements PixelColors {
        @Override
        public Set<VertexQuantity> wants() {
            return COORDINATES;
        }

        @Override
        public Set<VertexQuantity> wantsSlopes() {
            return COORDINATES;
        }

        @Override
        public Set<VertexQuantity> affine() {
            return linear ? COORDINATES : Set.of();
        }

        @Override
        public void color(PixelBatch batch) {
            check.accept(batch, new Slopes(batch));
        }
    }

    private record Slopes(
            float[] s, float[] t, float[] right, float[] down, float[] rightT, float[] downT) {
        Slopes(PixelBatch batch) {
            this(
                    batch.values(TEXTURE_S),
                    batch.values(TEXTURE_T),
                    batch.right(TEXTURE_S),
                    batch.down(TEXTURE_S),
                    batch.right(TEXTURE_T),
                    batch.down(TEXTURE_T));
        }
    }

    /** Strips that lean back, each of two triangles with coordinates of their own. */
    private static TriangleMesh strips() {
        int strips = 7;
        float[][] corner = new float[3][6 * strips];
        float[][] st = new float[2][6 * strips];
        int[] triangles = new int[6 * strips];
        for (int k = 0; k < 6 * strips; k++) {
            boolean far = k % 6 == 2 || k % 6 == 4 || k % 6 == 5;
            boolean right = k % 6 == 1 || k % 6 == 3 || k % 6 == 5;
            corner[0][k] = (k / 6 + (right ? 1 : 0)) * 0.3f - 1;
            corner[1][k] = far ? 3 : -1;
            corner[2][k] = far ? -8 : -2;
            st[0][k] = (right ? 2 : 0) + k / 3;
            st[1][k] = far ? 3 - k / 3 % 2 : 0;
            triangles[k] = k;
        }
        return TriangleMesh.of(corner[0], corner[1], corner[2], triangles)
                .withTexture(st[0], st[1]);
    }

    private static void draw(PixelColors colors) {
        var view =
                new TriangleView(
                        new Matrix4d(),
                        GlMatrices.perspective(60, 1, 1, 10),
                        List.of(),
                        Culling.NONE);
        try (var pipeline = new TrianglePipeline(1)) {
            var surface = new Surface.PerPixel(colors);
            pipeline.drawOn(0, strips(), view, surface, new DepthRaster(SIDE, SIDE), () -> false);
        }
    }

    /** The next pixel has v + v'·q/(q + q') with v = n/q, which is as exact as the slope. */
    @ParameterizedTest(name = "linear on the picture: {0}")
    @ValueSource(booleans = {false, true})
    void leadToTheNextPixels(boolean linear) {
        draw(
                new Checked(
                        linear,
                        (batch, slopes) -> {
                            for (int i = 0; i + 1 < batch.count; i++) {
                                if (batch.cell[i + 1] != batch.cell[i] + 1) continue;
                                if (runOf(batch, i) != runOf(batch, i + 1)) continue;
                                double per = linear ? 1 : batch.nearness[i + 1] / batch.nearness[i];
                                assertNext(slopes.s, slopes.right, per, i, i + 1);
                                assertNext(slopes.t, slopes.rightT, per, i, i + 1);
                                int below = below(batch, i);
                                if (below < 0) continue;
                                per = linear ? 1 : batch.nearness[below] / batch.nearness[i];
                                assertNext(slopes.s, slopes.down, per, i, below);
                                assertNext(slopes.t, slopes.downT, per, i, below);
                            }
                        }));
        assertTrue(compared > 1000, compared + " values were compared");
    }

    private static int runOf(PixelBatch batch, int pixel) {
        int run = 0;
        while (batch.slopes.end[run] <= pixel) run++;
        return run;
    }

    /** The pixel below of the same triangle, or −1. */
    private static int below(PixelBatch batch, int pixel) {
        for (int i = pixel; i < batch.count && runOf(batch, i) == runOf(batch, pixel); i++)
            if (batch.cell[i] == batch.cell[pixel] + SIDE) return i;
        return -1;
    }

    private void assertNext(float[] value, float[] slope, double per, int here, int next) {
        compared++;
        assertEquals(
                value[next] - value[here],
                slope[here] * per,
                2e-5,
                "pixels %d and %d".formatted(here, next));
    }

    @Test
    void makeTheSquaredSteps() {
        draw(
                new Checked(
                        false,
                        (batch, slopes) -> {
                            float[] found = Arrays.copyOf(batch.squaredSteps(64, 32), batch.count);
                            for (int i = 0; i < batch.count; i++) {
                                double step =
                                        DetailLevel.squaredStep(
                                                slopes.right[i],
                                                slopes.rightT[i],
                                                slopes.down[i],
                                                slopes.downT[i],
                                                64,
                                                32);
                                assertEquals(step, found[i], 1e-5 * step, "pixel " + i);
                                compared++;
                            }
                        }));
        assertTrue(compared > 500, compared + " pixels were compared");
    }
}
