package rasterlab.engine.texture;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * Eight places at a time, each looked up as {@link PlainTexels} looks it up; the last few one by
 * one. Eight may reach beyond the places of a level into those of the next one, whose turn comes
 * later.
 *
 * <p>Each loop is a method of its own with at most fifty operations on vectors: of more the
 * compiler would make objects.
 */
final class VectorTexels implements TexelLoops {
    private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_256;
    private static final VectorSpecies<Integer> INTS = IntVector.SPECIES_256;
    private static final int LANES = FLOATS.length();

    private final PlainTexels plain = new PlainTexels();

    /** A multiple of 2⁻²², from −1/2 to 1/2, congruent to a coordinate of moderate size. */
    private static FloatVector rest(float[] coordinate, int i) {
        FloatVector whole = FloatVector.fromArray(FLOATS, coordinate, i).add(ROUND).sub(ROUND);
        return FloatVector.fromArray(FLOATS, coordinate, i).sub(whole);
    }

    /** The whole number below is found by rounding, which may have gone up. */
    private static IntVector texel(float[] coordinate, int i, int last) {
        FloatVector place = rest(coordinate, i).mul(last + 1);
        FloatVector whole = place.add(ROUND).sub(ROUND);
        VectorMask<Float> up = whole.compare(VectorOperators.GT, place);
        return whole.sub(1, up).add(ROUND).reinterpretAsInts().and(last);
    }

    @Override
    public void nearest(
            RepeatedLevel level, float[] s, float[] t, int[] texel, int first, int end) {
        int whole = first + (end - first) / LANES * LANES;
        nearestInLanes(level, s, t, texel, first, whole);
        lookUp(level.argb(), texel, first, whole);
        plain.nearest(level, s, t, texel, whole, end);
    }

    private static void nearestInLanes(
            RepeatedLevel level, float[] s, float[] t, int[] number, int first, int end) {
        int lastColumn = level.lastColumn();
        int lastRow = level.lastRow();
        int across = level.across();
        for (int i = first; i < end; i += LANES) {
            texel(t, i, lastRow)
                    .lanewise(VectorOperators.LSHL, across)
                    .or(texel(s, i, lastColumn))
                    .intoArray(number, i);
        }
    }

    /** Replaces numbers of texels by the texels. */
    private static void lookUp(int[] texels, int[] number, int first, int end) {
        for (int i = first; i < end; i++) number[i] = texels[number[i]];
    }

    @Override
    public void levels(int n, float[] squaredStep, int from, int highest, int[] lambda) {
        int whole = n / LANES * LANES;
        levelsInLanes(whole, squaredStep, from, highest, lambda);
        PlainTexels.levels(whole, n, squaredStep, from, highest, lambda);
    }

    private static void levelsInLanes(
            int end, float[] squaredStep, int from, int highest, int[] lambda) {
        for (int i = 0; i < end; i += LANES) {
            IntVector bits =
                    FloatVector.fromArray(FLOATS, squaredStep, from + i).reinterpretAsInts();
            FloatVector rest =
                    bits.and((1 << FRACTION_BITS) - 1)
                            .or(EXPONENT << FRACTION_BITS)
                            .reinterpretAsFloats()
                            .sub(1);
            FloatVector exponent =
                    bits.lanewise(VectorOperators.LSHR, FRACTION_BITS)
                            .add(ROUND_BITS - EXPONENT)
                            .reinterpretAsFloats()
                            .sub(ROUND);
            rest.mul(BEND)
                    .add(SLOPE)
                    .mul(rest)
                    .add(exponent)
                    .mul(WHOLE / 2)
                    .add(ROUND)
                    .reinterpretAsInts()
                    .sub(ROUND_BITS)
                    .min(highest)
                    .max(0)
                    .intoArray(lambda, i);
        }
    }

    /** The texel's place as {@link PlainTexels} has it. */
    private static IntVector place(float[] coordinate, int i, int side) {
        return rest(coordinate, i)
                .add(STEPS)
                .reinterpretAsInts()
                .and((1 << BITS) - 1)
                .add(HALF_PART >>> side)
                .lanewise(VectorOperators.LSHR, BITS - PARTS - side)
                .sub(WHOLE / 2);
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
        int eights = Math.min((end - first + LANES - 1) / LANES, (n - first) / LANES);
        int i = first + eights * LANES;
        placesInLanes(level, s, t, from, first, i, out.toRight, out.up);
        aroundInLanes(level, first, i, out);
        lookUp(texels, out.leftBelow, first, i);
        lookUp(texels, out.rightBelow, first, i);
        lookUp(texels, out.leftAbove, first, i);
        lookUp(texels, out.rightAbove, first, i);
        plain.gather(level, s, t, from, i, end, n, out);
    }

    private static void placesInLanes(
            RepeatedLevel level,
            float[] s,
            float[] t,
            int from,
            int first,
            int end,
            int[] x,
            int[] y) {
        int across = level.across();
        int up = level.up();
        for (int i = first; i < end; i += LANES) {
            place(s, from + i, across).intoArray(x, i);
            place(t, from + i, up).intoArray(y, i);
        }
    }

    /** Finds the numbers of the texels around places, and leaves their shares of them. */
    private static void aroundInLanes(
            RepeatedLevel level, int first, int end, TexelBlock.Corners out) {
        int across = level.across();
        int lastColumn = level.lastColumn();
        int lastRow = level.lastRow();
        for (int i = first; i < end; i += LANES) {
            IntVector x = IntVector.fromArray(INTS, out.toRight, i);
            IntVector y = IntVector.fromArray(INTS, out.up, i);
            x.and(WHOLE - 1).intoArray(out.toRight, i);
            y.and(WHOLE - 1).intoArray(out.up, i);
            IntVector column = x.lanewise(VectorOperators.ASHR, PARTS);
            IntVector row = y.lanewise(VectorOperators.ASHR, PARTS);
            IntVector left = column.and(lastColumn);
            IntVector right = column.add(1).and(lastColumn);
            IntVector below = row.and(lastRow).lanewise(VectorOperators.LSHL, across);
            IntVector above = row.add(1).and(lastRow).lanewise(VectorOperators.LSHL, across);
            below.or(left).intoArray(out.leftBelow, i);
            below.or(right).intoArray(out.rightBelow, i);
            above.or(left).intoArray(out.leftAbove, i);
            above.or(right).intoArray(out.rightAbove, i);
        }
    }

    @Override
    public void mix(int n, TexelBlock.Corners around) {
        mixAcrossInLanes(n, around.leftBelow, around.rightBelow, around.toRight);
        mixAcrossInLanes(n, around.leftAbove, around.rightAbove, around.toRight);
        mixPairInLanes(n, around.leftBelow, around.leftAbove, around.up);
        mixPairInLanes(n, around.rightBelow, around.rightAbove, around.up);
    }

    @Override
    public void mixLevels(int n, TexelBlock.Corners fine, TexelBlock.Corners coarse, int[] lambda) {
        mixPairInLanes(n, fine.leftBelow, coarse.leftBelow, lambda);
        mixPairInLanes(n, fine.rightBelow, coarse.rightBelow, lambda);
    }

    /** Leaves red and blue in the left one, alpha and green in the right one. */
    private static void mixAcrossInLanes(int n, int[] left, int[] right, int[] toRight) {
        for (int i = 0; i < n; i += LANES) {
            IntVector a = IntVector.fromArray(INTS, left, i);
            IntVector b = IntVector.fromArray(INTS, right, i);
            IntVector share = IntVector.fromArray(INTS, toRight, i);
            mixed(a.and(LEVELS), b.and(LEVELS), share).intoArray(left, i);
            mixed(odd(a), odd(b), share).intoArray(right, i);
        }
    }

    /** Alpha and green, where red and blue are. */
    private static IntVector odd(IntVector argb) {
        return argb.lanewise(VectorOperators.LSHR, 8).and(LEVELS);
    }

    /**
     * Mixes a pair of channels, into the first one.
     *
     * @param shares the lowest eight bits count
     */
    private static void mixPairInLanes(int n, int[] pair, int[] other, int[] shares) {
        for (int i = 0; i < n; i += LANES)
            mixed(
                            IntVector.fromArray(INTS, pair, i),
                            IntVector.fromArray(INTS, other, i),
                            IntVector.fromArray(INTS, shares, i).and(WHOLE - 1))
                    .intoArray(pair, i);
    }

    /** Mixes two pairs of channels into one: a share of b and the rest of a. */
    private static IntVector mixed(IntVector a, IntVector b, IntVector share) {
        return b.sub(a)
                .mul(share)
                .add(a.lanewise(VectorOperators.LSHL, PARTS))
                .add(HALVES)
                .lanewise(VectorOperators.LSHR, PARTS)
                .and(LEVELS);
    }

    @Override
    public void modulate(int n, int[] surface, int[] texel, boolean keepsAlpha) {
        int end = n / LANES * LANES;
        modulateRedAndBlueInLanes(end, surface, texel);
        modulateGreenInLanes(end, surface, texel);
        if (!keepsAlpha) PlainTexels.modulate(0, end, surface, texel, 24);
        PlainTexels.modulate(end, n, surface, texel, keepsAlpha);
    }

    /**
     * Multiplies red and blue: with v = a·b + 128, the upper half of v + v/256 is a·b/255, rounded.
     */
    private static void modulateRedAndBlueInLanes(int end, int[] surface, int[] texel) {
        for (int i = 0; i < end; i += LANES) {
            IntVector f = IntVector.fromArray(INTS, surface, i);
            IntVector t = IntVector.fromArray(INTS, texel, i);
            IntVector red = t.lanewise(VectorOperators.LSHR, 16).and(255).mul(f.and(255 << 16));
            IntVector v = t.and(255).mul(f.and(255)).add(red).add(HALVES);
            v.lanewise(VectorOperators.LSHR, 8)
                    .and(LEVELS)
                    .add(v)
                    .lanewise(VectorOperators.LSHR, 8)
                    .and(LEVELS)
                    .or(f.and(~LEVELS))
                    .intoArray(surface, i);
        }
    }

    private static void modulateGreenInLanes(int end, int[] surface, int[] texel) {
        for (int i = 0; i < end; i += LANES) {
            IntVector f = IntVector.fromArray(INTS, surface, i);
            IntVector t = IntVector.fromArray(INTS, texel, i);
            IntVector v =
                    t.lanewise(VectorOperators.LSHR, 8)
                            .and(255)
                            .mul(f.lanewise(VectorOperators.LSHR, 8).and(255))
                            .add(128);
            v.lanewise(VectorOperators.LSHR, 8)
                    .add(v)
                    .and(255 << 8)
                    .or(f.and(~(255 << 8)))
                    .intoArray(surface, i);
        }
    }
}
