package rasterlab.engine.pipeline.fast;

import rasterlab.engine.lanes.Lanes;

/**
 * The loops of {@link DistantLight} that there are for one lane and for eight.
 *
 * <p>Both write the same bit for bit, but cells beyond those asked for. They keep nothing, so
 * several threads may use them.
 */
interface LightLoops {
    /** Far above 1 over any cosine that a float can tell from 0 in a picture. */
    float LIT = 1e6f;

    /** 2, and so much more that rounding leaves nothing below 0. */
    float ROOM = 2 + 0x1p-19f;

    static LightLoops of(Lanes lanes) {
        return lanes.part(LightLoops.class, PlainLight::new, "VectorLight");
    }

    /**
     * Replaces nx by max(0, n·l) and ny by max(0, n·h)², or 0 where n·l is 0; all else is lost.
     *
     * <p>With p the place, {@code h = l − p/|p|}, so {@code |h|²·p² = 2p² − 2(p·l)|p|} and {@code
     * n·h·|p| = (n·l)|p| − n·p}: neither h nor its length is needed, and one division does for both
     * cosines.
     *
     * @param light l
     * @param far room for n numbers, as {@code along}
     */
    void cosines(
            int n,
            float[] light,
            float[] x,
            float[] y,
            float[] z,
            float[] nx,
            float[] ny,
            float[] nz,
            float[] far,
            float[] along);

    /** out = min(1, steady + lit·diffuse + highlight). */
    void channel(int n, float steady, float lit, float[] diffuse, float[] highlight, float[] out);
}
