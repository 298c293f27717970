package rasterlab.engine.light.normals;

import rasterlab.contract.VertexNormals;
import rasterlab.engine.light.UnitVector;

/**
 * The mean of the normals of a vertex's faces, by weights.
 *
 * <p>Face normals are cross products of two edges, brought to length 1 before they are weighted; a
 * face whose cross product is (0, 0, 0) is left out, whatever its weight.
 *
 * <p>Sources: H. Gouraud, Continuous shading of curved surfaces, IEEE Transactions on Computers
 * 20(6), 1971 (plain); G. Thürmer, C. A. Wüthrich, Computing vertex normals from polygonal facets,
 * Journal of Graphics Tools 3(1), 1998 (angles).
 */
public final class WeightedNormals implements VertexNormals {
    /** A sum below this share of its weights has no direction. */
    private static final double CANCELLED = 1e-9;

    private final Weight weight;

    WeightedNormals(Weight weight) {
        this.weight = weight;
    }

    /** By the faces' angles at the vertex: the mean that no cut of a flat face changes. */
    public static VertexNormals byAngle() {
        return new WeightedNormals(Weight.ANGLE);
    }

    @Override
    public double[] normals(double[] vertices, int[] triangles) {
        Triangles.require(vertices, triangles);
        var sums = new double[vertices.length];
        var weights = new double[vertices.length / 3];
        double unitOfArea = largestArea(vertices, triangles);
        var normal = new double[3];
        for (int face = 0; face < triangles.length; face += 3) {
            TriangleNormal.cross(vertices, triangles, face, normal);
            double area = UnitVector.length(normal);
            if (!UnitVector.normalise(normal)) continue;
            for (int corner = 0; corner < 3; corner++) {
                double angle =
                        weight == Weight.ANGLE
                                ? TriangleNormal.angle(vertices, triangles, face, corner)
                                : 0;
                double share = weight.of(area / unitOfArea, angle);
                int vertex = triangles[face + corner];
                weights[vertex] += share;
                for (int c = 0; c < 3; c++) sums[3 * vertex + c] += share * normal[c];
            }
        }
        finish(sums, weights);
        return sums;
    }

    private static double largestArea(double[] vertices, int[] triangles) {
        var normal = new double[3];
        double largest = 0;
        for (int face = 0; face < triangles.length; face += 3) {
            TriangleNormal.cross(vertices, triangles, face, normal);
            largest = Math.max(largest, UnitVector.length(normal));
        }
        return largest;
    }

    private static void finish(double[] sums, double[] weights) {
        var sum = new double[3];
        for (int vertex = 0; vertex < weights.length; vertex++) {
            System.arraycopy(sums, 3 * vertex, sum, 0, 3);
            if (UnitVector.length(sum) <= CANCELLED * weights[vertex]) sum = new double[3];
            UnitVector.normalise(sum);
            System.arraycopy(sum, 0, sums, 3 * vertex, 3);
        }
    }
}
