package rasterlab.engine.texture;

import rasterlab.engine.lanes.Lanes;

/**
 * The loops over many lookups in a repeated texture that there are for one lane and for eight.
 *
 * <p>All find the same bit for bit, but in cells of a block beyond those asked for.
 */
interface TexelLoops {
    /** Rounds a number to the nearest whole one when added and taken away again. */
    float ROUND = 0x1.8p23f;

    /** What is left of its bits when they are taken from a sum's is that whole number. */
    int ROUND_BITS = Float.floatToRawIntBits(ROUND);

    /** Steps of a coordinate's fraction where texels are mixed, as a power of two. */
    int BITS = 22;

    /** Where floats are 2⁻²² apart, so that a fraction's whole steps are a sum's lowest bits. */
    float STEPS = 3;

    /** Parts of a whole in which texels are mixed, as a power of two. */
    int PARTS = 8;

    int WHOLE = 1 << PARTS;

    /** The bits of two channels that stand 16 bits apart in one number, and a half of each. */
    int LEVELS = 0x00FF00FF;

    int HALVES = 0x00800080;

    /** Half a part of a side of one texel, in a fraction's steps. */
    int HALF_PART = 1 << BITS - PARTS - 1;

    /** A float's bits: of its fraction, and the exponent of 1. */
    int FRACTION_BITS = 23;

    int EXPONENT = 127;

    /** {@code 1 + x} has the logarithm {@code x·(SLOPE + BEND·x)} to the base 2, within 0.01. */
    float SLOPE = 1.3465f;

    float BEND = -0.3465f;

    static TexelLoops of(Lanes lanes) {
        return lanes.part(TexelLoops.class, PlainTexels::new, "VectorTexels");
    }

    /** Looks up the texels that the places from {@code first} to {@code end} − 1 lie in. */
    void nearest(RepeatedLevel level, float[] s, float[] t, int[] texel, int first, int end);

    /**
     * Finds λ in 256ths of n places, cut to 0 to {@code highest}, from the exponent of ρ² and a
     * parabola through the logarithm of its fraction, as {@link DetailLevel#quick} finds it.
     *
     * @param from the first place's number
     */
    void levels(int n, float[] squaredStep, int from, int highest, int[] lambda);

    /**
     * Looks the texels up around the places {@code first} to {@code end} − 1 of a block of n, all
     * in one level.
     *
     * @param from the number of the block's first place
     */
    void gather(
            RepeatedLevel level,
            float[] s,
            float[] t,
            int from,
            int first,
            int end,
            int n,
            TexelBlock.Corners out);

    /**
     * Mixes the four texels around each of n places by {@link TexelMix}'s formula. Leaves red and
     * blue in {@code leftBelow}, alpha and green in {@code rightBelow}; all else is lost.
     */
    void mix(int n, TexelBlock.Corners around);

    /**
     * Mixes what {@link #mix} left of two levels, into the first.
     *
     * @param lambda its lowest eight bits say how near the coarser level is
     */
    void mixLevels(int n, TexelBlock.Corners fine, TexelBlock.Corners coarse, int[] lambda);

    /**
     * Multiplies each channel of n pixels by the texel's, as {@link TextureEnvironment} does.
     *
     * @param keepsAlpha whether the alpha stays as it is
     */
    void modulate(int n, int[] surface, int[] texel, boolean keepsAlpha);
}
