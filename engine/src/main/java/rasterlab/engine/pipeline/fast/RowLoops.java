package rasterlab.engine.pipeline.fast;

import rasterlab.engine.lanes.Lanes;

/**
 * The loops over rows and pixels that there are for one lane and for eight. One per thread.
 *
 * <p>All write the same bit for bit, but cells of a batch beyond its pixels.
 */
interface RowLoops {
    /** The most pixels that are computed at a time. */
    int MOST_LANES = 8;

    /** Room for all values that grow from corner to corner: the attributes and 1/w. */
    int VALUES = FrameState.QUANTITIES.length + 1;

    static RowLoops of(Lanes lanes) {
        return lanes.part(RowLoops.class, PlainLoops::new, "VectorLoops");
    }

    /** How many pixels are computed at a time. */
    Lanes lanes();

    /** Finds each row's pixels, as {@link TriangleScan#scan} does. */
    void scan(TriangleScan scan);

    /** Whether small triangles, where there are many, are found faster in blocks. */
    boolean findsInBlocks();

    /**
     * Finds the small triangles of a block and which pixels they own. Only where {@link
     * #findsInBlocks}.
     */
    void find(TinyBlock block, Band band);

    /** Finds the pixels of a small triangle and draws them, with a division for each. */
    void smooth(Band band, TinyScan scan, ScreenVertices v);

    /** Draws a triangle whose depth and colours are linear. */
    void linear(Band band, TriangleScan scan, LinearColors colors);

    /**
     * Adds pixels to a batch that are nearer than what is there, from where the weights' row is,
     * until the triangle has no more or the batch has less room than for {@link #MOST_LANES}; it
     * may be filled further.
     *
     * @param depthStart the cell whose depth is {@code depth[0]}
     * @param early whether their depth is written at once
     */
    void collect(
            float[] depth,
            int depthStart,
            TriangleScan scan,
            RowWeights weights,
            boolean early,
            PixelBatch batch);

    /** What {@link #findInBox} returns where it does nothing. */
    int NOT_SOUGHT = -1;

    /**
     * Finds those pixels of a {@linkplain RowDepth#gentle gentle} triangle that are nearer than
     * what is there, and writes their depth; its rows need not have been found. Returns how many
     * there are, at most as many as a batch has, or {@link #NOT_SOUGHT} where {@link #collect} has
     * to do it.
     *
     * @param depthStart the cell whose depth is {@code depth[0]}
     * @param width of the picture
     */
    int findInBox(float[] depth, int depthStart, int width, TriangleScan scan, RowDepth at);

    /**
     * Adds the pixels that were found last to a batch that has room for them, in any order.
     *
     * @param width of the picture
     */
    void addFound(int width, TriangleScan scan, RowWeights weights, PixelBatch batch);

    /**
     * Adds those pixels of a small triangle to a batch that are nearer than what is there.
     *
     * @param depthStart the cell whose depth is {@code depth[0]}
     * @param width of the picture
     * @param early whether their depth is written at once
     * @param batch with room for the whole box
     */
    void collect(
            float[] depth,
            int depthStart,
            int width,
            TinyScan scan,
            ScreenVertices v,
            boolean early,
            PixelBatch batch);

    /**
     * Writes {@code a + weightB·b + weightC·c} for the batch's pixels from {@code first} on, to
     * each of n arrays.
     *
     * @param corners the a of each array, from {@link #VALUES} on the b, from twice that on the c
     */
    void between(PixelBatch batch, float[][] to, float[] corners, int n, int first);

    /**
     * Finds ρ² of the batch's pixels from their texture coordinates, w and the slopes of their
     * runs.
     */
    void squareSteps(PixelBatch batch, int width, int height, float[] squaredSteps);

    /** Packs the colours of a batch as {@link PixelLevels} does. */
    void pack(PixelBatch batch, float[] red, float[] green, float[] blue);
}
