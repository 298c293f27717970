package rasterlab.engine.scene;

import rasterlab.engine.geometry.VertexNumber;

/** The rules for the triangles of a {@link TriangleMesh}. */
final class TriangleMeshCheck {
    private TriangleMeshCheck() {}

    static void triangles(int[] triangles, int vertices) {
        if (triangles.length % 3 != 0)
            throw new IllegalArgumentException(
                    "triangles must have 3 vertices each, got " + triangles.length + " in all");
        for (int i = 0; i < triangles.length; i++)
            if (!VertexNumber.exists(triangles[i], vertices))
                throw new IllegalArgumentException(
                        VertexNumber.refusal(
                                "triangle " + i / 3 + ": corner", triangles[i], vertices));
    }
}
