package rasterlab.engine.scene.shape;

import java.util.Arrays;
import java.util.List;
import rasterlab.engine.scene.TriangleMesh;

/** Puts the vertices and triangles of a {@link Tessellation} into arrays. */
public final class TriangleGrid {
    private static final int QUANTITIES = 8;

    private final List<Patch> patches;
    private final int uSteps;
    private final int vSteps;
    private final float[][] values;
    private final int[] triangles;
    private final SurfacePoint point = new SurfacePoint();
    private int vertexCount;
    private int cornerCount;

    TriangleGrid(Tessellation asked) {
        patches = asked.shape().patches();
        uSteps = asked.uSteps();
        vSteps = asked.vSteps();
        int vertices = 0;
        int corners = 0;
        for (Patch patch : patches) {
            int v = patch.vSteps(vSteps);
            vertices += (uSteps + 1) * (v + 1);
            corners += 6 * uSteps * v;
        }
        values = new float[QUANTITIES][vertices];
        triangles = new int[corners];
    }

    /** Triangles of a torus of major radius 1 and minor radius 0.45, 2·rings·sides of them. */
    public static TriangleMesh torus(int rings, int sides) {
        return new TriangleGrid(new Tessellation(new Torus(1, 0.45), rings, sides)).mesh();
    }

    TriangleMesh mesh() {
        for (Patch patch : patches) {
            triangles(patch);
            vertices(patch);
        }
        return TriangleMesh.of(
                        values[0], values[1], values[2], Arrays.copyOf(triangles, cornerCount))
                .withNormals(values[3], values[4], values[5])
                .withTexture(values[6], values[7]);
    }

    private void vertices(Patch patch) {
        int n = patch.vSteps(vSteps);
        for (int i = 0; i <= uSteps; i++)
            for (int j = 0; j <= n; j++) {
                double v = patch.v().at(j, n);
                boolean halfway = i < uSteps && patch.isPole(v);
                double u = halfway ? patch.u().between(i, i + 1, uSteps) : patch.u().at(i, uSteps);
                patch.at(u, v, point);
                put();
            }
    }

    private void put() {
        int at = vertexCount++;
        values[0][at] = (float) point.x;
        values[1][at] = (float) point.y;
        values[2][at] = (float) point.z;
        values[3][at] = (float) point.normalX;
        values[4][at] = (float) point.normalY;
        values[5][at] = (float) point.normalZ;
        values[6][at] = (float) point.s;
        values[7][at] = (float) point.t;
    }

    private void triangles(Patch patch) {
        int n = patch.vSteps(vSteps);
        for (int i = 0; i < uSteps; i++)
            for (int j = 0; j < n; j++) {
                int here = vertexCount + i * (n + 1) + j;
                int next = here + n + 1;
                if (patch.isPole(patch.v().at(j, n))) triangle(here, next + 1, here + 1);
                else if (patch.isPole(patch.v().at(j + 1, n))) triangle(here, next, here + 1);
                else {
                    triangle(here, next, next + 1);
                    triangle(here, next + 1, here + 1);
                }
            }
    }

    private void triangle(int a, int b, int c) {
        triangles[cornerCount++] = a;
        triangles[cornerCount++] = b;
        triangles[cornerCount++] = c;
    }
}
