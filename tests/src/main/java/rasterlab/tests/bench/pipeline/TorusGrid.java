package rasterlab.tests.bench.pipeline;

import java.util.Comparator;
import java.util.stream.IntStream;
import org.joml.Matrix4d;
import rasterlab.engine.scene.TriangleMesh;
import rasterlab.engine.scene.VertexQuantity;
import rasterlab.engine.scene.shape.SurfacePoint;
import rasterlab.engine.scene.shape.Torus;

/** The vertices of a torus, each once but at the texture's seams, and pairs of triangles. */
final class TorusGrid {
    private static final int QUANTITIES = 8;

    private final int rings;
    private final int sides;
    private final float[][] values;

    TorusGrid(Torus torus, int rings, int sides) {
        this.rings = rings;
        this.sides = sides;
        values = new float[QUANTITIES][(rings + 1) * (sides + 1)];
        var point = new SurfacePoint();
        for (int i = 0, at = 0; i <= rings; i++)
            for (int j = 0; j <= sides; j++, at++) {
                torus.at(
                        2 * Math.PI * (i % rings) / rings,
                        2 * Math.PI * (j % sides) / sides,
                        point);
                double[] all = {
                    point.x(),
                    point.y(),
                    point.z(),
                    point.normalX(),
                    point.normalY(),
                    point.normalZ(),
                    (double) i / rings,
                    (double) j / sides
                };
                for (int k = 0; k < QUANTITIES; k++) values[k][at] = (float) all[k];
            }
    }

    /** Ring after ring. */
    TriangleMesh mesh() {
        return mesh(IntStream.range(0, rings * sides).toArray());
    }

    /** The pairs with the largest mean z of eye space first. */
    TriangleMesh farthestFirst(Matrix4d toEye) {
        double[] z = new double[rings * sides];
        for (int pair = 0; pair < z.length; pair++)
            for (int v : corners(pair))
                z[pair] +=
                        toEye.m02() * values[0][v]
                                + toEye.m12() * values[1][v]
                                + toEye.m22() * values[2][v];
        return mesh(
                IntStream.range(0, z.length)
                        .boxed()
                        .sorted(Comparator.comparingDouble(pair -> -z[pair]))
                        .mapToInt(Integer::intValue)
                        .toArray());
    }

    private int[] corners(int pair) {
        int v = pair / sides * (sides + 1) + pair % sides;
        return new int[] {v, v + sides + 1, v + sides + 2, v + 1};
    }

    private TriangleMesh mesh(int[] pairs) {
        int[] triangles = new int[6 * pairs.length];
        int at = 0;
        for (int pair : pairs) {
            int[] corner = corners(pair);
            for (int k : new int[] {0, 1, 2, 0, 2, 3}) triangles[at++] = corner[k];
        }
        return TriangleMesh.of(values[0], values[1], values[2], triangles)
                .withNormals(values[3], values[4], values[5])
                .withTexture(values[6], values[7]);
    }

    /** The mesh with its normals as colours. */
    TriangleMesh colored() {
        TriangleMesh mesh = mesh();
        float[][] rgba = new float[4][mesh.vertexCount()];
        for (int v = 0; v < rgba[0].length; v++) {
            rgba[0][v] = (mesh.values(VertexQuantity.NORMAL_X)[v] + 1) / 2;
            rgba[1][v] = (mesh.values(VertexQuantity.NORMAL_Y)[v] + 1) / 2;
            rgba[2][v] = (mesh.values(VertexQuantity.NORMAL_Z)[v] + 1) / 2;
            rgba[3][v] = 1;
        }
        return mesh.withColors(rgba[0], rgba[1], rgba[2], rgba[3]);
    }
}
