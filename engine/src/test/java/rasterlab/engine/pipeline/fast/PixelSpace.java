package rasterlab.engine.pipeline.fast;

import java.util.Arrays;
import java.util.List;
import org.joml.Matrix4d;
import rasterlab.engine.scene.TriangleMesh;

/** Scenes whose world is the picture: x and y in pixels, (0, 0) the top left centre, z 0 to 1. */
final class PixelSpace {
    private PixelSpace() {}

    /** The view from pixels to −1..1, y turned up, in the textbook's layout. */
    static TriangleView view(int width, int height, Culling culling) {
        var clip =
                new Matrix4d(
                        2.0 / width,
                        0,
                        0,
                        0,
                        0,
                        -2.0 / height,
                        0,
                        0,
                        0,
                        0,
                        2,
                        0,
                        1.0 / width - 1,
                        1 - 1.0 / height,
                        -1,
                        1);
        return new TriangleView(new Matrix4d(), clip, List.of(), culling);
    }

    /** Triangles of x, y pairs, all at depth 0.5. */
    static TriangleMesh mesh(float[] xy, int... triangles) {
        float[] depth = new float[xy.length / 2];
        Arrays.fill(depth, 0.5f);
        return mesh(xy, depth, triangles);
    }

    /** Triangles of x, y pairs, each pair with its depth. */
    static TriangleMesh mesh(float[] xy, float[] depth, int... triangles) {
        float[] x = new float[depth.length];
        float[] y = new float[depth.length];
        for (int i = 0; i < depth.length; i++) {
            x[i] = xy[2 * i];
            y[i] = xy[2 * i + 1];
        }
        return TriangleMesh.of(x, y, depth, triangles);
    }
}
