package rasterlab.engine.texture;

import java.util.Arrays;

/**
 * The levels of a texture that is repeated both ways and whose sides are powers of two: many
 * lookups in a loop, in whole numbers.
 *
 * <p>A coordinate's fraction is a whole number of steps, so that indices are wrapped by masks: of
 * 2⁻³¹, cut towards 0, where the nearest texel is wanted, and there colours are those of {@link
 * TextureSampler}'s single lookups; of 2⁻²², the nearest, where texels are mixed, so colours may
 * differ from those by a level or two. Beyond ±2³² or ±2²² the place is any one.
 */
final class RepeatedLevels {
    /** Of a coordinate's fraction, as a power of two. */
    private static final int BITS = 22;

    /** Where floats are 2⁻²² apart, so that a fraction's whole steps are a sum's lowest bits. */
    private static final float STEPS = 3;

    /** Added and taken away again it rounds to the nearest whole number. */
    private static final float ROUND = 0x1.8p23f;

    /** Bits of a fraction whose texel alone is wanted. */
    private static final int NEAREST_BITS = 31;

    /** Parts of a whole in which texels are mixed, as a power of two. */
    private static final int PARTS = 8;

    private static final int WHOLE = 1 << PARTS;

    /** Half a part of a side of one texel, in a fraction's steps. */
    private static final int HALF_PART = 1 << BITS - PARTS - 1;

    private static final int LEAST_EXPONENT = 127;
    private static final int FRACTION_BITS = 23;

    private final ThreadLocal<TexelBlock> blocks = ThreadLocal.withInitial(TexelBlock::new);
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
        float rest = coordinate - (coordinate + ROUND - ROUND);
        return Float.floatToRawIntBits(rest + STEPS) & (1 << BITS) - 1;
    }

    private static int cutFraction(float coordinate) {
        return (int) (long) (coordinate * 0x1p31f) & Integer.MAX_VALUE;
    }

    void nearest(int count, float[] s, float[] t, int[] texel) {
        int[] texels = argb[0];
        int perRow = across[0];
        int toColumn = NEAREST_BITS - perRow;
        int toRow = NEAREST_BITS - up[0];
        for (int i = 0; i < count; i++)
            texel[i] =
                    texels[cutFraction(t[i]) >>> toRow << perRow | cutFraction(s[i]) >>> toColumn];
    }

    void linear(int count, float[] s, float[] t, int[] texel) {
        TexelBlock block = blocks.get();
        for (int from = 0; from < count; from += TexelBlock.SIZE) {
            int n = Math.min(TexelBlock.SIZE, count - from);
            Arrays.fill(block.coarser, 0, n, 0);
            gather(n, s, t, from, block.coarser, 0, block.fine());
            block.mix(n, false, texel, from);
        }
    }

    /**
     * λ is found from the exponent of ρ², and a parabola through the logarithm of its fraction, as
     * {@link DetailLevel#quick} finds it, to a whole number of 256ths.
     */
    void trilinear(int count, float[] s, float[] t, float[] squaredStep, int[] texel) {
        TexelBlock block = blocks.get();
        for (int from = 0; from < count; from += TexelBlock.SIZE) {
            int n = Math.min(TexelBlock.SIZE, count - from);
            boolean two = levels(n, squaredStep, from, block);
            gather(n, s, t, from, block.coarser, 0, block.fine());
            if (two) gather(n, s, t, from, block.coarser, 1, block.coarse());
            for (int i = 0; i < n; i++) block.coarser[i] &= WHOLE - 1;
            block.mix(n, two, texel, from);
        }
    }

    /** Finds λ in 256ths, and whether it is anywhere between two levels. */
    private boolean levels(int n, float[] squaredStep, int from, TexelBlock block) {
        int highest = argb.length - 1 << PARTS;
        int between = 0;
        for (int i = 0; i < n; i++) {
            int bits = Float.floatToRawIntBits(squaredStep[from + i]);
            float rest = Float.intBitsToFloat(bits & 0x7FFFFF | 0x3F800000) - 1;
            float twice =
                    (bits >>> FRACTION_BITS) - LEAST_EXPONENT + rest * (1.3465f - 0.3465f * rest);
            int lambda = Math.max(0, Math.min(highest, (int) (128 * twice + 0.5f)));
            block.coarser[i] = lambda;
            between |= lambda;
        }
        return (between & WHOLE - 1) != 0;
    }

    /**
     * Looks the texels up around n places in the level of λ or the next one.
     *
     * @param next 1 for the next one, the last one's next being itself
     */
    private void gather(
            int n, float[] s, float[] t, int from, int[] lambda, int next, TexelBlock.Corners out) {
        int last = argb.length - 1;
        for (int i = 0; i < n; i++) {
            int level = Math.min(last, (lambda[i] >> PARTS) + next);
            int[] texels = argb[level];
            int perRow = across[level];
            int perColumn = up[level];
            int x = place(fraction(s[from + i]), perRow);
            int y = place(fraction(t[from + i]), perColumn);
            int lastColumn = (1 << perRow) - 1;
            int lastRow = (1 << perColumn) - 1;
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
     * The place in 256ths of a texel, counted from the first texel's centre.
     *
     * @param side logarithm of the number of texels
     */
    private static int place(int fraction, int side) {
        return (fraction + (HALF_PART >>> side) >>> BITS - PARTS - side) - WHOLE / 2;
    }
}
