package rasterlab.engine.scene;

/** The rules for the triangles of a {@link TriangleMesh}. */
final class TriangleMeshCheck {
    private TriangleMeshCheck() {}

    static void triangles(int[] triangles, int vertices) {
        if (triangles.length % 3 != 0)
            throw new IllegalArgumentException(
                    "triangles need three vertex numbers each, got "
                            + triangles.length
                            + " numbers");
        for (int i = 0; i < triangles.length; i++)
            if (triangles[i] < 0 || triangles[i] >= vertices)
                throw new IllegalArgumentException(
                        "triangle %d: corner must be a vertex from 0 to %d, got %d"
                                .formatted(i / 3, vertices - 1, triangles[i]));
    }
}
