package rasterlab.engine.pipeline.fast;

import java.util.Arrays;

/**
 * A frame's bands, those with the most triangles first: what is shared out last is short, so all
 * threads end nearly together.
 *
 * <p>Source: R. L. Graham, Bounds on Multiprocessing Timing Anomalies, SIAM Journal on Applied
 * Mathematics 17(2), 1969, pp. 416–429.
 */
final class BandOrder {
    /** A band's number less 2³² times its triangles, in order. */
    private long[] keys = new long[0];

    /**
     * Bands with as many triangles go from the top down.
     *
     * @param chunks how many of {@code sorted} are the frame's
     */
    void find(TriangleChunk[] sorted, int chunks, int bands) {
        if (keys.length < bands) keys = new long[bands];
        for (int band = 0; band < bands; band++) keys[band] = band;
        for (int k = 0; k < chunks; k++)
            for (int band = 0; band < bands; band++)
                keys[band] -= (long) sorted[k].triangles(band) << Integer.SIZE;
        Arrays.sort(keys, 0, bands);
    }

    /**
     * The number of the band that comes after {@code before} others.
     *
     * @param before from 0 to the frame's bands − 1
     */
    int band(int before) {
        return (int) keys[before];
    }
}
