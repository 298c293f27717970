package rasterlab.engine.light.normals;

import rasterlab.contract.VertexNormals;

/**
 * The mean of unit normals as described: every face has one, even one without area (0/0), and the
 * mean keeps its length, which is below 1 wherever the surface is curved.
 *
 * <p>Source: student's coursework "three-dimensional model of a vase", section 2.2.
 */
final class SummedNormals implements VertexNormals {
    @Override
    public double[] normals(double[] vertices, int[] triangles) {
        Triangles.require(vertices, triangles);
        var sums = new double[vertices.length];
        var faces = new int[vertices.length / 3];
        var normal = new double[3];
        for (int face = 0; face < triangles.length; face += 3) {
            TriangleNormal.cross(vertices, triangles, face, normal);
            double length =
                    Math.sqrt(
                            normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
            for (int corner = 0; corner < 3; corner++) {
                int vertex = triangles[face + corner];
                faces[vertex]++;
                for (int c = 0; c < 3; c++) sums[3 * vertex + c] += normal[c] / length;
            }
        }
        for (int i = 0; i < sums.length; i++) sums[i] /= faces[i / 3];
        return sums;
    }
}
