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
}
