package rasterlab.engine.pipeline.triangle;

import java.util.Arrays;

/**
 * Some successive triangles of the mesh, sorted into bands of rows, each band in the mesh's order.
 *
 * <p>An entry t ≥ 0 is triangle t of the mesh; an entry ~t is triangle t of those that clipping
 * made, whose vertices are the chunk's own.
 */
final class TriangleChunk {
    /** Triangles of a chunk. */
    static final int SIZE = 2048;

    int[] entries = new int[0];

    /** Band b has the entries from start[b] to start[b + 1]. */
    int[] start = new int[0];

    final ScreenVertices clipped = new ScreenVertices();
    int clippedVertices;
    int[] clippedTriangles = new int[0];
    int clippedCount;

    void begin(int bands) {
        if (start.length < bands + 1) start = new int[bands + 1];
        Arrays.fill(start, 0);
        clippedVertices = 0;
        clippedCount = 0;
    }

    /** Adds a clipped triangle and returns its entry. */
    int addClipped(int a, int b, int c) {
        int at = 3 * clippedCount;
        if (clippedTriangles.length < at + 3)
            clippedTriangles = Arrays.copyOf(clippedTriangles, 2 * at + 48);
        clippedTriangles[at] = a;
        clippedTriangles[at + 1] = b;
        clippedTriangles[at + 2] = c;
        return ~clippedCount++;
    }
}
