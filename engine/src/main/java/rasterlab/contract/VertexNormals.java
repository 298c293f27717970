package rasterlab.contract;

/**
 * Finds a normal for each vertex of a surface of triangles, as if the surface were smooth.
 *
 * <p>A vertex's normal is a weighted mean of the normals of the faces around it. Three kinds of
 * weights are in use: 1 for each face, its area, and its angle at the vertex. Where nothing else is
 * said it is the angle, the only one that does not change when flat faces are cut otherwise; an
 * exercise says which it asks for. Tips of normals may be off by 10⁻¹² of their length, or by what
 * an exercise allows.
 *
 * <p>A face without area has no say. A vertex that no face with an area has, or whose weighted sum
 * is not longer than 10⁻⁹ of the sum of its weights, has no normal: (0, 0, 0).
 */
@FunctionalInterface
public interface VertexNormals {
    /** The largest magnitude of a coordinate. */
    double LARGEST = 1e75;

    /**
     * The normals.
     *
     * @param vertices x, y, z of each vertex, one after the other
     * @param triangles three vertex numbers from 0 of each face, counter-clockwise seen from
     *     outside
     * @return x, y, z of each vertex's normal in the order of the vertices, of length 1 and to the
     *     outside; space is right-handed
     * @throws IllegalArgumentException if a number is missing, not finite or beyond {@link
     *     #LARGEST}, or there is no such vertex; the message names the place
     */
    double[] normals(double[] vertices, int[] triangles);
}
