package rasterlab.engine.light.normals;

/**
 * The mean of unit normals as described: every face has one, even one without area (0/0), and the
 * mean keeps its length, which is below 1 wherever the surface is curved.
 *
 * <p>Source: student's coursework "three-dimensional model of a vase", section 2.2.
 */
final class SummedNormals implements SteppedNormals {
    @Override
    public NormalsWalk walk(double[] vertices, int[] triangles) {
        return new Walk(vertices, triangles);
    }

    @Override
    public String weightFormula() {
        return Weight.PLAIN.formula();
    }

    private static final class Walk extends FaceSums {
        private final int[] faces;

        Walk(double[] vertices, int[] triangles) {
            super(vertices, triangles);
            faces = new int[vertices.length / 3];
        }

        @Override
        boolean begins() {
            double length =
                    Math.sqrt(
                            normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
            for (int c = 0; c < 3; c++) normal[c] /= length;
            return true;
        }

        @Override
        double weightAt(int at, int corner) {
            return 1;
        }

        @Override
        void added(int vertex, double weight) {
            faces[vertex]++;
        }

        @Override
        public double[] normals() {
            for (int i = 0; i < sums.length; i++) sums[i] /= faces[i / 3];
            return sums;
        }
    }
}
