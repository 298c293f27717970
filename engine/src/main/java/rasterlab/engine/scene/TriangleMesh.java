package rasterlab.engine.scene;

/**
 * Triangles over shared vertices, each quantity in an array of its own, valid by construction.
 *
 * <p>Coordinates are world units. A triangle lists its three vertices counter-clockwise seen from
 * outside; one without an area is allowed and covers nothing. Normals, texture coordinates and
 * colours are there for every vertex or for none.
 *
 * <p>Fast loops read the arrays themselves, so what hands one out hands out no copy: nobody writes
 * to it.
 */
public final class TriangleMesh {
    private final VertexQuantities vertices;
    private final int[] triangles;

    private TriangleMesh(VertexQuantities vertices, int[] triangles) {
        this.vertices = vertices;
        this.triangles = triangles;
    }

    /**
     * A mesh of bare positions.
     *
     * @param x world x of every vertex, finite
     * @param triangles three vertex numbers for each triangle
     * @throws IllegalArgumentException naming the vertex or triangle that breaks a rule
     */
    public static TriangleMesh of(float[] x, float[] y, float[] z, int[] triangles) {
        VertexQuantities vertices = VertexQuantities.positions(x, y, z);
        int[] copy = triangles.clone();
        TriangleMeshCheck.triangles(copy, x.length);
        return new TriangleMesh(vertices, copy);
    }

    /**
     * This mesh with normals.
     *
     * @param nx world x of every vertex's outward normal, which has length 1 within 10⁻³
     */
    public TriangleMesh withNormals(float[] nx, float[] ny, float[] nz) {
        return new TriangleMesh(vertices.withNormals(nx, ny, nz), triangles);
    }

    /** This mesh with texture coordinates, finite. */
    public TriangleMesh withTexture(float[] s, float[] t) {
        return new TriangleMesh(vertices.withTexture(s, t), triangles);
    }

    /** This mesh with opaque or transparent colours of 0 to 1. */
    public TriangleMesh withColors(float[] red, float[] green, float[] blue, float[] alpha) {
        return new TriangleMesh(vertices.withColors(red, green, blue, alpha), triangles);
    }

    /**
     * Other triangles over the same vertices.
     *
     * @param other three vertex numbers for each triangle
     * @throws IllegalArgumentException naming the triangle that breaks a rule
     */
    public TriangleMesh withTriangles(int[] other) {
        int[] copy = other.clone();
        TriangleMeshCheck.triangles(copy, vertexCount());
        return new TriangleMesh(vertices, copy);
    }

    public int vertexCount() {
        return vertices.count();
    }

    public int triangleCount() {
        return triangles.length / 3;
    }

    /** Three vertex numbers for each triangle: not a copy. */
    public int[] triangles() {
        return triangles;
    }

    public boolean hasNormals() {
        return vertices.has(VertexQuantity.NORMAL_X);
    }

    public boolean hasColors() {
        return vertices.has(VertexQuantity.RED);
    }

    /**
     * One number for each vertex: not a copy.
     *
     * @throws IllegalArgumentException where the mesh has none
     */
    public float[] values(VertexQuantity quantity) {
        return vertices.values(quantity);
    }
}
