package rasterlab.engine.pipeline.triangle;

import rasterlab.engine.lanes.Lanes;

/**
 * The loops over rows and pixels that there are for one lane and for eight. One per thread.
 *
 * <p>All write the same bit for bit, but cells of a batch beyond its pixels.
 */
interface RowLoops {
    /** The most pixels that are computed at a time. */
    int MOST_LANES = 8;

    /** Room for all values that grow from corner to corner, whole lanes. */
    int VALUES = (Frame.QUANTITIES.length / MOST_LANES + 1) * MOST_LANES;

    static RowLoops of(Lanes lanes) {
        return lanes.part(RowLoops.class, PlainLoops::new, "VectorLoops");
    }

    /** How many pixels are computed at a time. */
    Lanes lanes();

    /** Finds each row's pixels, as {@link TriangleScan#scan} does. */
    void scan(TriangleScan scan);

    /** Finds the pixels of a small triangle and draws them, with a division for each. */
    void smooth(DepthRaster out, TinyScan scan, ScreenVertices v);

    /** Draws a triangle whose depth and colours are linear. */
    void linear(DepthRaster out, TriangleScan scan, LinearColors colors);

    /**
     * Adds pixels to a batch that are nearer than what is there, from where the weights' row is,
     * until the triangle has no more or the batch has hardly room, for less than {@link
     * #MOST_LANES}.
     *
     * @param early whether their depth is written at once
     */
    void collect(
            float[] depth, TriangleScan scan, RowWeights weights, boolean early, PixelBatch batch);

    /**
     * Writes the first n attributes of a triangle's corner a, and from {@link #VALUES} and twice
     * that on what b and c have more; beyond n there may be anything.
     *
     * @param affine which attributes are taken as they are, {@link #VALUES} of them; others are
     *     multiplied by 1/w
     */
    void corners(Scan scan, ScreenVertices v, boolean[] affine, int n, float[] corners);

    /**
     * Writes {@code a + weightB·b + weightC·c} for the batch's pixels from {@code first} on, to
     * each of n arrays.
     *
     * @param corners a, b and c of each array, as {@link #corners} writes them
     */
    void between(PixelBatch batch, float[][] to, float[] corners, int n, int first);

    /** Writes a number for the batch's pixels from {@code first} on. */
    void fill(PixelBatch batch, float[] to, int first, float value);

    /** Packs the colours of a batch as {@link PixelLevels} does. */
    void pack(PixelBatch batch, float[] red, float[] green, float[] blue);
}
