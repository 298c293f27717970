package rasterlab.engine.pipeline.fast;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * The small triangles of a {@link TinyBlock}, eight at a time, each as {@link TinyScan#load} and
 * {@link TinyScan#look} find it. One per thread.
 *
 * <p>Several loops, as {@link VectorLoops} explains. Of a triangle that is not small numbers may
 * overflow, and only {@link TinyBlock#code} is read: what that depends on does not, since corners
 * are below 2²⁴.
 */
final class VectorTinies {
    private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_256;
    private static final VectorSpecies<Integer> INTS = IntVector.SPECIES_256;
    private static final int LANES = INTS.length();
    private static final int SIGN = Integer.SIZE - 1;

    /** −1 where a side of the box is too long for a small triangle, else 0. */
    private final int[] tooWide = new int[TinyBlock.SIZE];

    private final int[] tooHigh = new int[TinyBlock.SIZE];

    /** Where the pixel that is asked lies in its box, and its eB and eC. */
    private final int[] right = new int[TinyBlock.SIZE];

    private final int[] down = new int[TinyBlock.SIZE];
    private final int[] edgeB = new int[TinyBlock.SIZE];
    private final int[] edgeC = new int[TinyBlock.SIZE];

    void find(TinyBlock t, Band band) {
        int n = t.count;
        int bottom = band.bottom();
        sidesInLanes(n, t.ax, t.bx, t.cx, 0, band.width, t.left, t.columns, tooWide);
        sidesInLanes(n, t.ay, t.by, t.cy, band.top, bottom, t.top, t.rows, tooHigh);
        boxesInLanes(n, t, band.width);
        turnInLanes(n, t);
        numbersInLanes(n, t);
        stepsInLanes(n, t);
        edgesInLanes(n, t);
        for (int k = 0; k < TinyScan.FEW; k++) {
            pixelsInLanes(n, t, k, band.width);
            ownedInLanes(n, t, k);
            weightsInLanes(n, t, k * TinyBlock.SIZE);
        }
    }

    private static IntVector ints(int[] numbers, int i) {
        return IntVector.fromArray(INTS, numbers, i);
    }

    /** −1 where a number is negative, else 0. */
    private static IntVector negative(IntVector number) {
        return number.lanewise(VectorOperators.ASHR, SIGN);
    }

    /**
     * The box's first column and how many it has, from the corners' x; or its rows, from their y.
     *
     * @param least the picture's first column, or the band's first row
     * @param end the one after its last
     */
    private static void sidesInLanes(
            int n,
            int[] a,
            int[] b,
            int[] c,
            int least,
            int end,
            int[] first,
            int[] count,
            int[] tooLong) {
        for (int i = 0; i < n; i += LANES) {
            IntVector low = ints(a, i).min(ints(b, i)).min(ints(c, i));
            IntVector high = ints(a, i).max(ints(b, i)).max(ints(c, i));
            negative(low.sub(high).add(TinyScan.WIDEST)).intoArray(tooLong, i);
            IntVector from =
                    low.add(Subpixels.ONE - 1)
                            .lanewise(VectorOperators.ASHR, Subpixels.BITS)
                            .max(least);
            from.intoArray(first, i);
            high.lanewise(VectorOperators.ASHR, Subpixels.BITS)
                    .add(1)
                    .min(end)
                    .sub(from)
                    .intoArray(count, i);
        }
    }

    private void boxesInLanes(int n, TinyBlock t, int width) {
        for (int i = 0; i < n; i += LANES) {
            ints(t.top, i).mul(width).add(ints(t.left, i)).intoArray(t.at, i);
            IntVector few = negative(ints(t.columns, i).mul(ints(t.rows, i)).sub(TinyScan.FEW + 1));
            few.not()
                    .and(TinyBlock.CODE_OF_BOX)
                    .or(ints(tooWide, i).or(ints(tooHigh, i)).and(TinyBlock.CODE_OF_LARGE))
                    .intoArray(t.code, i);
        }
    }

    /** Sees b and c from a, and exchanges them where the area is negative. */
    private static void turnInLanes(int n, TinyBlock t) {
        for (int i = 0; i < n; i += LANES) {
            IntVector ax = ints(t.ax, i);
            IntVector ay = ints(t.ay, i);
            IntVector bx = ints(t.bx, i).sub(ax);
            IntVector by = ints(t.by, i).sub(ay);
            IntVector cx = ints(t.cx, i).sub(ax);
            IntVector cy = ints(t.cy, i).sub(ay);
            IntVector area = bx.mul(cy).sub(by.mul(cx));
            IntVector turned = negative(area);
            turned.not().intoArray(t.fromBehind, i);
            IntVector x = bx.lanewise(VectorOperators.XOR, cx).and(turned);
            IntVector y = by.lanewise(VectorOperators.XOR, cy).and(turned);
            bx.lanewise(VectorOperators.XOR, x).intoArray(t.bx, i);
            by.lanewise(VectorOperators.XOR, y).intoArray(t.by, i);
            cx.lanewise(VectorOperators.XOR, x).intoArray(t.cx, i);
            cy.lanewise(VectorOperators.XOR, y).intoArray(t.cy, i);
            FloatVector size = floats(area.lanewise(VectorOperators.XOR, turned).sub(turned));
            FloatVector.broadcast(FLOATS, 1).div(size).intoArray(t.inverseArea, i);
        }
    }

    private static void numbersInLanes(int n, TinyBlock t) {
        for (int i = 0; i < n; i += LANES) {
            IntVector b = ints(t.b, i);
            IntVector c = ints(t.c, i);
            IntVector turned = ints(t.fromBehind, i).not();
            IntVector other = b.lanewise(VectorOperators.XOR, c).and(turned);
            b.lanewise(VectorOperators.XOR, other).intoArray(t.b, i);
            c.lanewise(VectorOperators.XOR, other).intoArray(t.c, i);
        }
    }

    private static void stepsInLanes(int n, TinyBlock t) {
        for (int i = 0; i < n; i += LANES) {
            IntVector bx = ints(t.bx, i);
            IntVector by = ints(t.by, i);
            IntVector cx = ints(t.cx, i);
            IntVector cy = ints(t.cy, i);
            timesPixel(by.sub(cy)).intoArray(t.stepA, i);
            timesPixel(cy).intoArray(t.stepB, i);
            timesPixel(by).neg().intoArray(t.stepC, i);
            timesPixel(cx.sub(bx)).intoArray(t.downA, i);
            timesPixel(cx).neg().intoArray(t.downB, i);
            timesPixel(bx).intoArray(t.downC, i);
            owned(cx.neg(), cy.neg()).intoArray(t.ownB, i);
            owned(bx, by).intoArray(t.ownC, i);
        }
    }

    /** A number times the steps of a pixel. */
    private static IntVector timesPixel(IntVector number) {
        return number.lanewise(VectorOperators.LSHL, Subpixels.BITS);
    }

    /** The owned pixels as {@link TriangleScan#owned} has them. */
    private static IntVector owned(IntVector dx, IntVector dy) {
        IntVector leftward = dx.neg().lanewise(VectorOperators.LSHR, SIGN);
        return negative(dy.add(dy).sub(leftward)).not();
    }

    /** The edge functions at the box's first pixel. */
    private static void edgesInLanes(int n, TinyBlock t) {
        for (int i = 0; i < n; i += LANES) {
            IntVector bx = ints(t.bx, i);
            IntVector by = ints(t.by, i);
            IntVector cx = ints(t.cx, i);
            IntVector cy = ints(t.cy, i);
            IntVector px = timesPixel(ints(t.left, i)).sub(ints(t.ax, i));
            IntVector py = timesPixel(ints(t.top, i)).sub(ints(t.ay, i));
            IntVector dx = cx.sub(bx);
            IntVector dy = cy.sub(by);
            dx.mul(py.sub(by)).sub(dy.mul(px.sub(bx))).add(owned(dx, dy)).intoArray(t.rowA, i);
            cy.mul(px.sub(cx)).sub(cx.mul(py.sub(cy))).intoArray(t.rowB, i);
            bx.mul(py).sub(by.mul(px)).intoArray(t.rowC, i);
        }
    }

    /**
     * Finds where pixel k is, row by row: in one column k rows down; in two k/2 down and k%2 to the
     * right; in more, which have one row, k to the right.
     */
    private void pixelsInLanes(int n, TinyBlock t, int k, int width) {
        for (int i = 0; i < n; i += LANES) {
            IntVector one = negative(ints(t.columns, i).sub(2));
            IntVector two = negative(ints(t.columns, i).sub(3));
            IntVector dx = two.and(k % 2 - k).add(one.and(-(k % 2))).add(k);
            IntVector dy = two.and(k / 2).add(one.and(k - k / 2));
            dx.intoArray(right, i);
            dy.intoArray(down, i);
            dy.mul(width).add(dx).add(ints(t.at, i)).intoArray(t.cell, k * TinyBlock.SIZE + i);
        }
    }

    /** Sets bit k where pixel k is in a box with few and the triangle owns it. */
    private void ownedInLanes(int n, TinyBlock t, int k) {
        for (int i = 0; i < n; i += LANES) {
            IntVector dx = ints(right, i);
            IntVector dy = ints(down, i);
            IntVector eA = at(dx, dy, t.rowA, t.stepA, t.downA, i);
            IntVector eB = at(dx, dy, t.rowB, t.stepB, t.downB, i);
            IntVector eC = at(dx, dy, t.rowC, t.stepC, t.downC, i);
            eB.intoArray(edgeB, i);
            eC.intoArray(edgeC, i);
            IntVector code = ints(t.code, i);
            IntVector inBox = ints(t.columns, i).mul(ints(t.rows, i)).sub(k + 1);
            eA.or(eB.add(ints(t.ownB, i)))
                    .or(eC.add(ints(t.ownC, i)))
                    .or(inBox)
                    .not()
                    .and(code.sub(TinyBlock.CODE_OF_BOX))
                    .lanewise(VectorOperators.LSHR, SIGN)
                    .lanewise(VectorOperators.LSHL, k)
                    .or(code)
                    .intoArray(t.code, i);
        }
    }

    private static IntVector at(
            IntVector dx, IntVector dy, int[] row, int[] step, int[] down, int i) {
        return dx.mul(ints(step, i)).add(dy.mul(ints(down, i))).add(ints(row, i));
    }

    private void weightsInLanes(int n, TinyBlock t, int pixel) {
        for (int i = 0; i < n; i += LANES) {
            FloatVector inverse = FloatVector.fromArray(FLOATS, t.inverseArea, i);
            floats(ints(edgeB, i)).mul(inverse).intoArray(t.weightB, pixel + i);
            floats(ints(edgeC, i)).mul(inverse).intoArray(t.weightC, pixel + i);
        }
    }

    /** Numbers from 0 to 2²³ − 1. */
    private static FloatVector floats(IntVector numbers) {
        return numbers.or(VectorPlaces.ROUND_BITS).reinterpretAsFloats().sub(SmoothFill.ROUND);
    }
}
