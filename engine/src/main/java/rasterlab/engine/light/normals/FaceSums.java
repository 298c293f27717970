package rasterlab.engine.light.normals;

/** Goes from corner to corner of all faces; how they are weighted and what comes of it is open. */
abstract class FaceSums implements NormalsWalk {
    /** x, y, z of each vertex. */
    final double[] sums;

    /** x, y, z of the face's normal. */
    final double[] normal = new double[3];

    private final double[] vertices;
    private final int[] triangles;
    private int face = -3;
    private int corner = 2;
    private double weight;
    private int leftOut;

    /**
     * @throws IllegalArgumentException as {@link SteppedNormals#normals} does
     */
    FaceSums(double[] vertices, int[] triangles) {
        TriangleSurface.require(vertices, triangles);
        this.vertices = vertices;
        this.triangles = triangles;
        sums = new double[vertices.length];
    }

    /**
     * Brings the face's normal, a cross product, to length 1.
     *
     * @return whether the face has a say
     */
    abstract boolean begins();

    /** The face's weight at its corner 0, 1 or 2, where its vertex numbers begin at {@code at}. */
    abstract double weightAt(int at, int corner);

    /** Called once for each face added to a vertex. */
    abstract void added(int vertex, double weight);

    @Override
    public final boolean advance() {
        if (corner == 2 && !nextFace()) return false;
        corner = (corner + 1) % 3;
        weight = weightAt(face, corner);
        int vertex = vertex();
        for (int c = 0; c < 3; c++) sums[3 * vertex + c] += weight * normal[c];
        added(vertex, weight);
        return true;
    }

    private boolean nextFace() {
        while ((face += 3) < triangles.length) {
            TriangleNormal.cross(vertices, triangles, face, normal);
            if (begins()) return true;
            leftOut++;
        }
        return false;
    }

    @Override
    public final int face() {
        return face / 3;
    }

    @Override
    public final int vertex() {
        return triangles[face + corner];
    }

    @Override
    public final double weight() {
        return weight;
    }

    @Override
    public final double[] sum() {
        int at = 3 * vertex();
        return new double[] {sums[at], sums[at + 1], sums[at + 2]};
    }

    @Override
    public final int leftOut() {
        return leftOut;
    }
}
