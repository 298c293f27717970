package rasterlab.engine.pipeline.fast;

import java.util.Arrays;

/**
 * Some successive triangles of the mesh, sorted into bands of rows, each band in the mesh's order.
 *
 * <p>A corner v ≥ 0 is vertex v of the mesh; a corner ~v is vertex v of those that clipping made,
 * which are the chunk's own.
 */
final class TriangleChunk {
    /** Triangles of a chunk. */
    static final int SIZE = 2048;

    /** Three for each triangle. */
    int[] corners = new int[0];

    /** Band b has the triangles from start[b] to start[b + 1]. */
    int[] start = new int[0];

    final ScreenVertices clipped = new ScreenVertices();
    int clippedVertices;

    void begin(int bands, int attributeCount) {
        if (start.length < bands + 1) start = new int[bands + 1];
        Arrays.fill(start, 0);
        clippedVertices = 0;
        clipped.begin(0, attributeCount);
    }

    /** How many triangles touch a band. */
    int triangles(int band) {
        return start[band + 1] - start[band];
    }
}
