package rasterlab.engine.texture;

/** One place after the other. */
final class PlainTexels implements TexelLoops {
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

    @Override
    public void nearest(
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

    @Override
    public void levels(int n, float[] squaredStep, int from, int highest, int[] lambda) {
        levels(0, n, squaredStep, from, highest, lambda);
    }

    static void levels(int first, int n, float[] squaredStep, int from, int highest, int[] lambda) {
        for (int i = first; i < n; i++) {
            int bits = Float.floatToRawIntBits(squaredStep[from + i]);
            int one = EXPONENT << FRACTION_BITS;
            float rest = Float.intBitsToFloat(bits & (1 << FRACTION_BITS) - 1 | one) - 1;
            float twice = (bits >>> FRACTION_BITS) - EXPONENT + rest * (SLOPE + BEND * rest);
            int whole = Float.floatToRawIntBits(WHOLE / 2 * twice + ROUND) - ROUND_BITS;
            lambda[i] = Math.max(0, Math.min(highest, whole));
        }
    }

    @Override
    public void gather(
            RepeatedLevel level,
            float[] s,
            float[] t,
            int from,
            int first,
            int end,
            int n,
            TexelBlock.Corners out) {
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

    @Override
    public void mix(int n, TexelBlock.Corners around) {
        mixOdd(n, around.leftBelow, around.rightBelow, around.toRight, around.other);
        mixEven(n, around.leftBelow, around.rightBelow, around.toRight);
        mixOdd(n, around.leftAbove, around.rightAbove, around.toRight, around.rightBelow);
        mixEven(n, around.leftAbove, around.rightAbove, around.toRight);
        mixTwo(n, around.leftBelow, around.leftAbove, around.up);
        mixTwo(n, around.other, around.rightBelow, around.up);
        System.arraycopy(around.other, 0, around.rightBelow, 0, n);
    }

    @Override
    public void mixLevels(int n, TexelBlock.Corners fine, TexelBlock.Corners coarse, int[] lambda) {
        for (int i = 0; i < n; i++) fine.other[i] = lambda[i] & WHOLE - 1;
        mixTwo(n, fine.leftBelow, coarse.leftBelow, fine.other);
        mixTwo(n, fine.rightBelow, coarse.rightBelow, fine.other);
    }

    /** Mixes red and blue of two colours, into the first. */
    private static void mixEven(int n, int[] a, int[] b, int[] share) {
        for (int i = 0; i < n; i++) a[i] = mixed(a[i] & LEVELS, b[i] & LEVELS, share[i]);
    }

    /** Alpha and green of two colours. */
    private static void mixOdd(int n, int[] a, int[] b, int[] share, int[] out) {
        for (int i = 0; i < n; i++)
            out[i] = mixed(a[i] >>> 8 & LEVELS, b[i] >>> 8 & LEVELS, share[i]);
    }

    /** Two channels that stand 16 bits apart, into the first. */
    private static void mixTwo(int n, int[] a, int[] b, int[] share) {
        for (int i = 0; i < n; i++) a[i] = mixed(a[i], b[i], share[i]);
    }

    /** {@code a·(256 − share) + b·share}: what b − a borrows from the next channel comes back. */
    private static int mixed(int a, int b, int share) {
        return (a << PARTS) + (b - a) * share + HALVES >>> PARTS & LEVELS;
    }

    @Override
    public void modulate(int n, int[] surface, int[] texel, boolean keepsAlpha) {
        modulate(0, n, surface, texel, keepsAlpha);
    }

    /** One channel after the other: so short a loop becomes vector instructions. */
    static void modulate(int first, int n, int[] surface, int[] texel, boolean keepsAlpha) {
        for (int shift = 0; shift < (keepsAlpha ? 24 : 32); shift += 8)
            modulate(first, n, surface, texel, shift);
    }

    static void modulate(int first, int n, int[] surface, int[] texel, int shift) {
        int others = ~(255 << shift);
        for (int i = first; i < n; i++) {
            int f = surface[i];
            int level = TextureEnvironment.product(f >> shift & 255, texel[i] >> shift & 255);
            surface[i] = f & others | level << shift;
        }
    }
}
