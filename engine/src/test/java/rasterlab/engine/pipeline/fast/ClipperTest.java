package rasterlab.engine.pipeline.fast;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.Random;
import org.joml.Matrix4d;
import org.junit.jupiter.api.Test;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.TriangleMesh;
import rasterlab.engine.transform.GlMatrices;

class ClipperTest {
    /** Two triangles that share an edge get the same new vertex on it, to the last bit. */
    @Test
    void aSharedEdgeIsCutAtOnePlaceOnly() {
        var view = new TriangleView(new Matrix4d(), GlMatrices.perspective(60, 1, 1, 9));
        var surface = new Surface.Flat(VertexColors.own());
        var out = new Raster(8, 8);
        for (int seed = 0; seed < 2000; seed++) {
            var frame = new FrameState();
            frame.begin(pair(new Random(seed)), view, surface, out, new float[0]);
            new VertexStage().place(frame, 0);
            Arrays.fill(frame.vertices.needed, true);
            new VertexStage().fill(frame, 0);
            var one = new Clipper().clip(frame, 0, 1, 2);
            var other = new Clipper().clip(frame, 1, 0, 3);
            assertEquals(0, least(one, other), "seed " + seed);
        }
    }

    /** The shared edge goes from beyond the near plane to before it. */
    private static TriangleMesh pair(Random random) {
        float[] x = new float[4];
        float[] y = new float[4];
        float[] z = {-random.nextFloat() * 0.9f, -1.5f - random.nextFloat(), -2, -3};
        for (int v = 0; v < 4; v++) {
            x[v] = random.nextFloat() - 0.5f;
            y[v] = random.nextFloat() - 0.5f;
        }
        return TriangleMesh.of(x, y, z, new int[] {0, 1, 2, 1, 0, 3});
    }

    /** The least distance between a new corner of one and a new corner of the other. */
    private static double least(ClipPolygon one, ClipPolygon other) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < one.size; i++)
            for (int k = 0; k < other.size; k++) {
                if (one.vertex[i] != ClipPolygon.NEW || other.vertex[k] != ClipPolygon.NEW)
                    continue;
                double distance = 0;
                for (int c = 0; c < 4; c++)
                    distance += Math.abs(one.values[i][c] - other.values[k][c]);
                least = Math.min(least, distance);
            }
        return least;
    }
}
