package rasterlab.contract;

/**
 * Finds a normal for each vertex of a surface of triangles, as if the surface were smooth.
 *
 * <p>A vertex's normal is a weighted mean of the normals of the faces around it. A face without
 * area has no say. A vertex that no face with an area has, or whose faces cancel out to less than
 * 10⁻⁹ of their weights, has no normal: (0, 0, 0).
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
     * @return x, y, z of each vertex's normal, of length 1 and to the outside
     * @throws IllegalArgumentException if a number is missing, not finite or beyond {@link
     *     #LARGEST}, or there is no such vertex; the message names the place
     */
    double[] normals(double[] vertices, int[] triangles);
}
