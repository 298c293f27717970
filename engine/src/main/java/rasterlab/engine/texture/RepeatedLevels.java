package rasterlab.engine.texture;

/**
 * The levels of a texture that is repeated both ways and whose sides are powers of two: many
 * lookups in a loop, in whole numbers.
 *
 * <p>A coordinate's fraction is kept in 31 bits, so that indices are wrapped by masks. What a
 * coordinate has below 2⁻³¹ is cut off towards 0; beyond ±2³² the place is any one. Else colours
 * are those of {@link TextureSampler}'s single lookups.
 */
final class RepeatedLevels {
    /** Of a coordinate's fraction, as a power of two. */
    private static final int BITS = 31;

    private static final float ONE = 0x1p31f;

    /** Parts of a whole in which texels are mixed, as a power of two. */
    private static final int PARTS = 8;

    private static final int WHOLE = 1 << PARTS;

    /** Half a part of a side of one texel, in a fraction's steps. */
    private static final int HALF_PART = 1 << BITS - PARTS - 1;

    private static final int LEAST_EXPONENT = 127;
    private static final int FRACTION_BITS = 23;

    private final int[][] argb;

    /** Logarithms of the sides. */
    private final int[] across;

    private final int[] up;

    RepeatedLevels(Texture texture) {
        int count = texture.levelCount();
        argb = new int[count][];
        across = new int[count];
        up = new int[count];
        for (int k = 0; k < count; k++) {
            TextureLevel level = texture.level(k);
            argb[k] = level.argb();
            across[k] = Integer.numberOfTrailingZeros(level.width());
            up[k] = Integer.numberOfTrailingZeros(level.height());
        }
    }

    static boolean fits(Texture texture, Wrap alongS, Wrap alongT) {
        return alongS == Wrap.REPEAT
                && alongT == Wrap.REPEAT
                && Integer.bitCount(texture.width()) == 1
                && Integer.bitCount(texture.height()) == 1;
    }

    private static int fraction(float coordinate) {
        return (int) (long) (coordinate * ONE) & Integer.MAX_VALUE;
    }

    void nearest(int count, float[] s, float[] t, int[] texel) {
        int[] texels = argb[0];
        int perRow = across[0];
        int toColumn = BITS - perRow;
        int toRow = BITS - up[0];
        for (int i = 0; i < count; i++)
            texel[i] = texels[fraction(t[i]) >>> toRow << perRow | fraction(s[i]) >>> toColumn];
    }

    void linear(int count, float[] s, float[] t, int[] texel) {
        for (int i = 0; i < count; i++)
            texel[i] = TexelMix.packed(linear(0, fraction(s[i]), fraction(t[i])));
    }

    /**
     * λ is found from the exponent of ρ², and a parabola through the logarithm of its fraction, as
     * {@link DetailLevel#quick} finds it, to a whole number of 256ths.
     */
    void trilinear(int count, float[] s, float[] t, float[] squaredStep, int[] texel) {
        int highest = argb.length - 1 << PARTS;
        for (int i = 0; i < count; i++) {
            int bits = Float.floatToRawIntBits(squaredStep[i]);
            float rest = Float.intBitsToFloat(bits & 0x7FFFFF | 0x3F800000) - 1;
            float twice =
                    (bits >>> FRACTION_BITS) - LEAST_EXPONENT + rest * (1.3465f - 0.3465f * rest);
            int lambda = Math.max(0, Math.min(highest, (int) (128 * twice + 0.5f)));
            int u = fraction(s[i]);
            int v = fraction(t[i]);
            int finer = lambda >> PARTS;
            int share = lambda & WHOLE - 1;
            long mixed = linear(finer, u, v);
            if (share > 0) mixed = TexelMix.of(mixed, linear(finer + 1, u, v), share);
            texel[i] = TexelMix.packed(mixed);
        }
    }

    /** x and y are places in 256ths of a texel, counted from the first texel's centre. */
    private long linear(int level, int u, int v) {
        int[] texels = argb[level];
        int perRow = across[level];
        int perColumn = up[level];
        int x = (u + (HALF_PART >>> perRow) >>> BITS - PARTS - perRow) - WHOLE / 2;
        int y = (v + (HALF_PART >>> perColumn) >>> BITS - PARTS - perColumn) - WHOLE / 2;
        int lastColumn = (1 << perRow) - 1;
        int lastRow = (1 << perColumn) - 1;
        int left = x >> PARTS & lastColumn;
        int right = left + 1 & lastColumn;
        int below = (y >> PARTS & lastRow) << perRow;
        int above = ((y >> PARTS) + 1 & lastRow) << perRow;
        int toRight = x & WHOLE - 1;
        return TexelMix.of(
                TexelMix.of(texels[below | left], texels[below | right], toRight),
                TexelMix.of(texels[above | left], texels[above | right], toRight),
                y & WHOLE - 1);
    }
}
