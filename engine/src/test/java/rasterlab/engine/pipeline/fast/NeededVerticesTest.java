package rasterlab.engine.pipeline.fast;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.EnumSet;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.engine.scene.TriangleMesh;
import rasterlab.engine.scene.VertexQuantity;

/** Checks what is computed of vertices and what is not. */
class NeededVerticesTest {
    private static final int SIDE = 16;
    private static final int GROUP = ScreenVertices.GROUP;

    /**
     * A triangle of the first group's vertices that is kept and one of the second's, the other way.
     */
    private static TriangleMesh mesh(float firstDepth) {
        float[] corners = new float[4 * GROUP];
        float[] depth = new float[2 * GROUP];
        float[][] channel = new float[4][2 * GROUP];
        int[] triangles = {0, 1, 2, GROUP, GROUP + 2, GROUP + 1};
        for (int v : triangles) {
            corners[2 * v] = v % GROUP == 1 ? SIDE : 0;
            corners[2 * v + 1] = v % GROUP == 2 ? SIDE : 0;
            depth[v] = 0.5f;
            for (float[] each : channel) each[v] = 0.25f;
        }
        depth[0] = firstDepth;
        return PixelSpace.mesh(corners, depth, triangles)
                .withColors(channel[0], channel[1], channel[2], channel[3]);
    }

    private static void draw(TriangleMesh mesh, Culling culling, Surface surface) {
        try (var pipeline = new TrianglePipeline(1)) {
            var view = PixelSpace.view(SIDE, SIDE, culling);
            pipeline.draw(mesh, view, surface, new DepthRaster(SIDE, SIDE), () -> false);
        }
    }

    @ParameterizedTest(name = "culling {0}, the first vertex at depth {1}: {2} groups have colours")
    @CsvSource({"BACK, 0.5, 1", "FRONT, 0.5, 1", "NONE, 0.5, 2", "BACK, -0.5, 2"})
    void onlyTrianglesInSightOrAboutToBeClippedHaveColors(
            Culling culling, float firstDepth, int groups) {
        var colored = new AtomicInteger();
        var surface = new Surface.Smooth(block -> colored.addAndGet(block.count));
        draw(mesh(firstDepth), culling, surface);
        assertEquals(groups * GROUP, colored.get());
    }

    @Test
    void aTriangleNeedsTheGroupsOfAllItsCorners() {
        float[] corners = new float[6 * GROUP];
        corners[2 * GROUP] = SIDE;
        corners[4 * GROUP + 1] = SIDE;
        var mesh = PixelSpace.mesh(corners, 0, GROUP, 2 * GROUP);
        var colored = new AtomicInteger();
        var surface = new Surface.Smooth(block -> colored.addAndGet(block.count));
        draw(mesh, Culling.NONE, surface);
        assertEquals(3 * GROUP, colored.get());
    }

    @Test
    void alphaIsOneWhereNothingShinesThrough() {
        assertEquals(1, seenAlpha(Blending.OPAQUE));
        assertEquals(0.25f, seenAlpha(Blending.GLASS), 1e-6);
    }

    private static float seenAlpha(Blending blending) {
        float[] seen = {Float.NaN};
        PixelColors colors =
                new PixelColors() {
                    @Override
                    public Set<VertexQuantity> wants() {
                        return EnumSet.of(VertexQuantity.ALPHA);
                    }

                    @Override
                    public void color(PixelBatch batch) {
                        seen[0] = batch.values(VertexQuantity.ALPHA)[batch.count - 1];
                    }
                };
        draw(mesh(0.5f), Culling.NONE, new Surface.PerPixel(colors).with(blending));
        return seen[0];
    }
}
