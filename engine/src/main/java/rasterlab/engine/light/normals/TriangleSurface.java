package rasterlab.engine.light.normals;

import rasterlab.contract.VertexNormals;
import rasterlab.engine.geometry.VertexNumber;

/**
 * A surface of triangles.
 *
 * @param vertices x, y, z of each vertex, one after the other
 * @param triangles three vertex numbers from 0 of each face, counter-clockwise seen from outside
 */
public record TriangleSurface(double[] vertices, int[] triangles) {
    public TriangleSurface {
        require(vertices, triangles);
        vertices = vertices.clone();
        triangles = triangles.clone();
    }

    /**
     * @throws IllegalArgumentException as {@link VertexNormals#normals} does
     */
    static void require(double[] vertices, int[] triangles) {
        if (vertices.length % 3 != 0)
            throw new IllegalArgumentException(
                    "vertices must have 3 numbers each, got " + vertices.length + " in all");
        if (triangles.length % 3 != 0)
            throw new IllegalArgumentException(
                    "triangles must have 3 vertices each, got " + triangles.length + " in all");
        for (int i = 0; i < vertices.length; i++)
            if (!(Math.abs(vertices[i]) <= VertexNormals.LARGEST))
                throw new IllegalArgumentException(
                        "vertices[%d].%s must be from -1E75 to 1E75, got %s"
                                .formatted(i / 3, "xyz".charAt(i % 3), vertices[i]));
        for (int i = 0; i < triangles.length; i++)
            if (!VertexNumber.exists(triangles[i], vertices.length / 3))
                throw new IllegalArgumentException(
                        VertexNumber.refusal(
                                "triangles[%d][%d]".formatted(i / 3, i % 3),
                                triangles[i],
                                vertices.length / 3));
    }
}
