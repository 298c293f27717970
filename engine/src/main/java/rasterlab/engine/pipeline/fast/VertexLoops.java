package rasterlab.engine.pipeline.fast;

import rasterlab.engine.lanes.Lanes;

/**
 * The loops of {@link VertexStage} that there are for one lane and for eight.
 *
 * <p>Both write the same bit for bit, but cells beyond the vertices asked for. They keep nothing,
 * so several threads may use them. Arrays have room for whole eights, places for {@link #SPARE}
 * more than the mesh's vertices.
 */
interface VertexLoops {
    /**
     * Places beyond the mesh's last vertex that may be written; none of another block's are, since
     * {@link VertexBlock#SIZE} is whole fours.
     */
    int SPARE = 3;

    static VertexLoops of(Lanes lanes) {
        return lanes.part(VertexLoops.class, PlainVertices::new, "VectorVertices");
    }

    /**
     * Whether all of n vertices in clip space have the {@link ClipCode} 0; may be false, too, for
     * what up to seven cells beyond them hold and for a number that is none.
     */
    boolean allSeen(int n, float[] x, float[] y, float[] z, float[] w);

    /**
     * Finds the {@linkplain ScreenVertices#places places} of n vertices in clip space; one that w
     * gives none, or that is beyond the guard, has any.
     *
     * @param places the first vertex's is {@code places[from]}
     */
    void place(
            int n, float[] x, float[] y, float[] w, Subpixels subpixels, long[] places, int from);

    /** Replaces z of n vertices in clip space by their depth, 0 to 1 if they are seen, w by 1/w. */
    void depths(int n, float[] z, float[] w);
}
