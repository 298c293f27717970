package rasterlab.engine.texture;

/** The loops over many lookups in a repeated texture. */
final class TexelLoops {
    /** Added and taken away again it rounds to the nearest whole number. */
    private static final float ROUND = 0x1.8p23f;

    /** A number whose bits, taken from those of a sum, leave the whole number. */
    private static final int ROUND_BITS = Float.floatToRawIntBits(ROUND);

    /** Steps of a coordinate's fraction where texels are mixed, as a power of two. */
    private static final int BITS = 22;

    /** Where floats are 2⁻²² apart, so that a fraction's whole steps are a sum's lowest bits. */
    private static final float STEPS = 3;

    /** Parts of a whole in which texels are mixed, as a power of two. */
    static final int PARTS = 8;

    static final int WHOLE = 1 << PARTS;

    /** The bits of two channels that stand 16 bits apart in a number. */
    private static final int LEVELS = 0x00FF00FF;

    /** A half of each of these channels. */
    private static final int HALVES = 0x00800080;

    /** Half a part of a side of one texel, in a fraction's steps. */
    private static final int HALF_PART = 1 << BITS - PARTS - 1;

    /** How many of a float's bits are its fraction. */
    private static final int FRACTION_BITS = 23;

    /** The exponent in the bits of 1. */
    private static final int EXPONENT = 127;

    /** {@code 1 + x} has the logarithm {@code x·(SLOPE + BEND·x)} to the base 2, within 0.01. */
    private static final float SLOPE = 1.3465f;

    private static final float BEND = -0.3465f;

    private TexelLoops() {}

    /** NaN is taken for 0. */
    private static int texel(float coordinate, int side, int last) {
        float rest = coordinate - (coordinate + ROUND - ROUND);
        return (int) Math.floor(rest * side) & last;
    }

    private static int fraction(float coordinate) {
        float rest = coordinate - (coordinate + ROUND - ROUND);
        return Float.floatToRawIntBits(rest + STEPS) & (1 << BITS) - 1;
    }

    /**
     * The place in 256ths of a texel, counted from the first texel's centre.
     *
     * @param side logarithm of the number of texels
     */
    private static int place(int fraction, int side) {
        return (fraction + (HALF_PART >>> side) >>> BITS - PARTS - side) - WHOLE / 2;
    }

    /** Looks up the texels that the places from {@code first} to {@code end} − 1 lie in. */
    static void nearest(
            RepeatedLevel level, float[] s, float[] t, int[] texel, int first, int end) {
        int[] texels = level.argb();
        int perRow = level.across();
        int lastColumn = level.lastColumn();
        int lastRow = level.lastRow();
        for (int i = first; i < end; i++) {
            int column = texel(s[i], lastColumn + 1, lastColumn);
            int row = texel(t[i], lastRow + 1, lastRow);
            texel[i] = texels[row << perRow | column];
        }
    }

    /**
     * Finds λ in 256ths of n places, cut to 0 to {@code highest}, from the exponent of ρ² and a
     * parabola through the logarithm of its fraction, as {@link DetailLevel#quick} finds it.
     *
     * @param from the first place's number
     */
    static void levels(int n, float[] squaredStep, int from, int highest, int[] lambda) {
        for (int i = 0; i < n; i++) {
            int bits = Float.floatToRawIntBits(squaredStep[from + i]);
            int one = EXPONENT << FRACTION_BITS;
            float rest = Float.intBitsToFloat(bits & (1 << FRACTION_BITS) - 1 | one) - 1;
            float twice = (bits >>> FRACTION_BITS) - EXPONENT + rest * (SLOPE + BEND * rest);
            int whole = Float.floatToRawIntBits(WHOLE / 2 * twice + ROUND) - ROUND_BITS;
            lambda[i] = Math.max(0, Math.min(highest, whole));
        }
    }

    /**
     * Looks the texels up around the places {@code first} to {@code end} − 1 of a block, all in one
     * level.
     *
     * @param from the number of the block's first place
     */
    static void gather(
            RepeatedLevel level,
            float[] s,
            float[] t,
            int from,
            int first,
            int end,
            TexelBlock.TexelCorners out) {
        int[] texels = level.argb();
        int perRow = level.across();
        int perColumn = level.up();
        int lastColumn = level.lastColumn();
        int lastRow = level.lastRow();
        for (int i = first; i < end; i++) {
            int x = place(fraction(s[from + i]), perRow);
            int y = place(fraction(t[from + i]), perColumn);
            int left = x >> PARTS & lastColumn;
            int right = left + 1 & lastColumn;
            int below = (y >> PARTS & lastRow) << perRow;
            int above = ((y >> PARTS) + 1 & lastRow) << perRow;
            out.leftBelow[i] = texels[below | left];
            out.rightBelow[i] = texels[below | right];
            out.leftAbove[i] = texels[above | left];
            out.rightAbove[i] = texels[above | right];
            out.toRight[i] = x & WHOLE - 1;
            out.up[i] = y & WHOLE - 1;
        }
    }

    /**
     * Mixes the four texels around each of n places by {@link TexelMix}'s formula. Leaves red and
     * blue in {@code leftBelow}, alpha and green in {@code rightBelow}; all else is lost.
     */
    static void mix(int n, TexelBlock.TexelCorners around) {
        mixOdd(n, around.leftBelow, around.rightBelow, around.toRight, around.other);
        mixEven(n, around.leftBelow, around.rightBelow, around.toRight);
        mixOdd(n, around.leftAbove, around.rightAbove, around.toRight, around.rightBelow);
        mixEven(n, around.leftAbove, around.rightAbove, around.toRight);
        mixTwo(n, around.leftBelow, around.leftAbove, around.up);
        mixTwo(n, around.other, around.rightBelow, around.up);
        System.arraycopy(around.other, 0, around.rightBelow, 0, n);
    }

    /**
     * Mixes what {@link #mix} left of two levels, into the first.
     *
     * @param lambda its lowest eight bits say how near the coarser level is
     */
    static void mixLevels(
            int n, TexelBlock.TexelCorners fine, TexelBlock.TexelCorners coarse, int[] lambda) {
        for (int i = 0; i < n; i++) fine.other[i] = lambda[i] & WHOLE - 1;
        mixTwo(n, fine.leftBelow, coarse.leftBelow, fine.other);
        mixTwo(n, fine.rightBelow, coarse.rightBelow, fine.other);
    }

    /** Mixes red and blue of two colours, into the first. */
    private static void mixEven(int n, int[] a, int[] b, int[] share) {
        for (int i = 0; i < n; i++) a[i] = mixed(a[i] & LEVELS, b[i] & LEVELS, share[i]);
    }

    /** Mixes alpha and green of two colours. */
    private static void mixOdd(int n, int[] a, int[] b, int[] share, int[] out) {
        for (int i = 0; i < n; i++)
            out[i] = mixed(a[i] >>> 8 & LEVELS, b[i] >>> 8 & LEVELS, share[i]);
    }

    /** Mixes two channels that stand 16 bits apart, into the first. */
    private static void mixTwo(int n, int[] a, int[] b, int[] share) {
        for (int i = 0; i < n; i++) a[i] = mixed(a[i], b[i], share[i]);
    }

    /** {@code a·(256 − share) + b·share}: what b − a borrows from the next channel comes back. */
    private static int mixed(int a, int b, int share) {
        return (a << PARTS) + (b - a) * share + HALVES >>> PARTS & LEVELS;
    }

    /**
     * Multiplies each channel of n pixels by the texel's, as {@link TextureEnvironment} does; one
     * channel after the other, so that the loop becomes vector instructions.
     *
     * @param keepsAlpha whether the alpha stays as it is
     */
    static void modulate(int n, int[] surface, int[] texel, boolean keepsAlpha) {
        for (int shift = 0; shift < (keepsAlpha ? 24 : 32); shift += 8)
            modulate(n, surface, texel, shift);
    }

    private static void modulate(int n, int[] surface, int[] texel, int shift) {
        int others = ~(255 << shift);
        for (int i = 0; i < n; i++) {
            int f = surface[i];
            int level = TextureEnvironment.product(f >> shift & 255, texel[i] >> shift & 255);
            surface[i] = f & others | level << shift;
        }
    }
}
