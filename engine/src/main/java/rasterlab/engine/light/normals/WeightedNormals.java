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
 * 20(6), 1971, pp. 623–629 (plain); G. Thürmer, C. A. Wüthrich, Computing vertex normals from
 * polygonal facets, Journal of Graphics Tools 3(1), 1998, pp. 43–46 (angles).
 */
public final class WeightedNormals implements SteppedNormals {
    /** A sum below this share of its weights has no direction. */
    private static final double CANCELLED = 1e-9;

    /** A cross product as small as that has lost digits, or all of them. */
    private static final double VANISHING = 0x1p-900;

    private final Weight weight;

    WeightedNormals(Weight weight) {
        this.weight = weight;
    }

    /** Weights by the faces' angles at the vertex: the mean that no cut of a flat face changes. */
    public static VertexNormals byAngle() {
        return new WeightedNormals(Weight.ANGLE);
    }

    @Override
    public NormalsWalk walk(double[] vertices, int[] triangles) {
        return new Walk(vertices, triangles);
    }

    @Override
    public String weightFormula() {
        return weight.formula();
    }

    private final class Walk extends FaceSums {
        private final double[] vertices;
        private final int[] triangles;
        private final double[] weights;
        private final double unitOfArea;
        private double area;

        Walk(double[] vertices, int[] triangles) {
            super(vertices, triangles);
            this.vertices = vertices;
            this.triangles = triangles;
            weights = new double[vertices.length / 3];
            unitOfArea = largestArea(vertices, triangles);
        }

        @Override
        boolean begins() {
            if (weight == Weight.ANGLE && UnitVector.length(normal) < VANISHING)
                TriangleNormal.direction(vertices, triangles, 3 * face(), normal);
            area = UnitVector.length(normal);
            return UnitVector.normalize(normal);
        }

        @Override
        double weightAt(int at, int corner) {
            double angle =
                    weight == Weight.ANGLE
                            ? TriangleNormal.angle(vertices, triangles, at, corner)
                            : 0;
            return weight.of(area / unitOfArea, angle);
        }

        @Override
        void added(int vertex, double share) {
            weights[vertex] += share;
        }

        @Override
        public double[] normals() {
            finish(sums, weights);
            return sums;
        }
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
            UnitVector.normalize(sum);
            System.arraycopy(sum, 0, sums, 3 * vertex, 3);
        }
    }
}
