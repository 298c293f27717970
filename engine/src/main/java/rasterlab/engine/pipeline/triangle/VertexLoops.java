package rasterlab.engine.pipeline.triangle;

import rasterlab.engine.lanes.Lanes;

/**
 * The loops of {@link VertexStage} that there are for one lane and for eight.
 *
 * <p>Both write the same bit for bit, but cells beyond the vertices asked for. They keep nothing,
 * so several threads may use them. Arrays have room for whole eights.
 */
interface VertexLoops {
    /** Cells beyond the last vertex that may be written. */
    int SPARE = 3;

    static VertexLoops of(Lanes lanes) {
        return lanes.part(VertexLoops.class, PlainVertices::new, "VectorVertices");
    }

    /**
     * Whether all of n vertices in clip space have the {@link ClipCode} 0; false also where a cell
     * beyond them has not.
     */
    boolean allSeen(int n, float[] x, float[] y, float[] z, float[] w);

    /**
     * Finds the {@linkplain ScreenVertices#places places} of n vertices in clip space; what w gives
     * none has any.
     *
     * @param places the first vertex's is {@code places[from]}
     */
    void place(
            int n, float[] x, float[] y, float[] w, Subpixels subpixels, long[] places, int from);

    /** Replaces z of n vertices in clip space by their depth, 0 to 1 if they are seen, w by 1/w. */
    void depths(int n, float[] z, float[] w);
}
