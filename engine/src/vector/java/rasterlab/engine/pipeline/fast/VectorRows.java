package rasterlab.engine.pipeline.fast;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.LongVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * What {@link TriangleScan#scan} finds, and what rows begin with, four rows at a time. One per
 * thread.
 *
 * <p>The edge functions are whole numbers below 2⁵², so doubles hold them, and a half more,
 * exactly. Several loops, as {@link VectorLoops} explains.
 */
final class VectorRows {
    private static final VectorSpecies<Double> FOUR = DoubleVector.SPECIES_256;
    private static final int LANES = FOUR.length();
    private static final double[] FIRST_NUMBERS = {0, 1, 2, 3};
    private static final DoubleVector NEXT = DoubleVector.broadcast(FOUR, LANES);

    /** A number above every number of pixels. */
    private static final double NO_END = 0x1p20;

    /** The first pixel of each row, counted from the box's left, and the number of pixels. */
    private final double[] from = new double[TriangleScan.ROWS];

    private final double[] count = new double[TriangleScan.ROWS];

    /** Depth and colours at each row's first pixel; of a colour the lower half is its number. */
    final double[] z = new double[TriangleScan.ROWS];

    final long[] red = new long[TriangleScan.ROWS];
    final long[] green = new long[TriangleScan.ROWS];
    final long[] blue = new long[TriangleScan.ROWS];

    void scan(TriangleScan s) {
        // Pixels begin at an edge where its function grows to the right, else they end there.
        boolean beginA = s.stepA >= 0;
        boolean beginB = s.stepB >= 0;
        boolean beginC = s.stepC >= 0;
        double perA = -1.0 / s.stepA;
        double perB = -1.0 / s.stepB;
        double perC = -1.0 / s.stepC;
        double width = s.boxRight - s.boxLeft - 0.25;
        firstsInLanes(s, beginA ? perA : 0, beginB ? perB : 0, beginC ? perC : 0, width);
        countsInLanes(s, beginA ? 0 : perA, beginB ? 0 : perB, beginC ? 0 : perC, width);
        edgesInLanes(s);
        for (int row = 0; row < s.rows; row++) {
            s.left[row] = s.boxLeft + (int) from[row];
            s.count[row] = Math.max(0, (int) count[row]);
        }
    }

    private void firstsInLanes(
            TriangleScan s, double perA, double perB, double perC, double width) {
        double[] to = from;
        int rows = s.rows;
        double downA = s.downA;
        double downB = s.downB;
        double downC = s.downC;
        double rowA = s.rowA + 0.5;
        double rowB = s.rowB + 0.5;
        double rowC = s.rowC + 0.5;
        DoubleVector down = DoubleVector.fromArray(FOUR, FIRST_NUMBERS, 0);
        for (int row = 0; row < rows; row += LANES) {
            DoubleVector a = down.mul(downA).add(rowA).mul(perA);
            DoubleVector b = down.mul(downB).add(rowB).mul(perB);
            DoubleVector c = down.mul(downC).add(rowC).mul(perC);
            DoubleVector end = DoubleVector.broadcast(FOUR, width);
            ceil(least(most(most(a, b), c), end)).intoArray(to, row);
            down = down.add(NEXT);
        }
    }

    private void countsInLanes(
            TriangleScan s, double perA, double perB, double perC, double width) {
        double noEndA = perA == 0 ? NO_END : 0;
        double noEndB = perB == 0 ? NO_END : 0;
        double noEndC = perC == 0 ? NO_END : 0;
        double[] first = from;
        double[] to = count;
        int rows = s.rows;
        double downA = s.downA;
        double downB = s.downB;
        double downC = s.downC;
        double rowA = s.rowA + 0.5;
        double rowB = s.rowB + 0.5;
        double rowC = s.rowC + 0.5;
        DoubleVector down = DoubleVector.fromArray(FOUR, FIRST_NUMBERS, 0);
        for (int row = 0; row < rows; row += LANES) {
            DoubleVector a = down.mul(downA).add(rowA).mul(perA).add(noEndA);
            DoubleVector b = down.mul(downB).add(rowB).mul(perB).add(noEndB);
            DoubleVector c = down.mul(downC).add(rowC).mul(perC).add(noEndC);
            DoubleVector end = DoubleVector.broadcast(FOUR, width);
            ceil(least(least(a, b), least(c, end)))
                    .sub(DoubleVector.fromArray(FOUR, first, row))
                    .intoArray(to, row);
            down = down.add(NEXT);
        }
    }

    /** The edge functions at each row's first pixel. */
    private void edgesInLanes(TriangleScan s) {
        double[] first = from;
        double[] edgeB = s.edgeB;
        double[] edgeC = s.edgeC;
        int rows = s.rows;
        double downB = s.downB;
        double downC = s.downC;
        double stepB = s.stepB;
        double stepC = s.stepC;
        double cornerB = s.cornerB();
        double cornerC = s.cornerC();
        DoubleVector down = DoubleVector.fromArray(FOUR, FIRST_NUMBERS, 0);
        for (int row = 0; row < rows; row += LANES) {
            DoubleVector right = DoubleVector.fromArray(FOUR, first, row);
            right.mul(stepB).add(down.mul(downB).add(cornerB)).intoArray(edgeB, row);
            right.mul(stepC).add(down.mul(downC).add(cornerC)).intoArray(edgeC, row);
            down = down.add(NEXT);
        }
    }

    /** Finds what {@link LinearColors#at} finds, for all rows. */
    void startInLanes(TriangleScan s, LinearColors c) {
        double inverse = s.inverseArea;
        RowDepth d = c.depth;
        for (int row = 0; row < s.rows; row += LANES) {
            DoubleVector weightB = DoubleVector.fromArray(FOUR, s.edgeB, row).mul(inverse);
            DoubleVector weightC = DoubleVector.fromArray(FOUR, s.edgeC, row).mul(inverse);
            weightB.mul(d.zb).add(d.za).add(weightC.mul(d.zc)).intoArray(z, row);
            whole(weightB.mul(c.rb).add(c.ra).add(weightC.mul(c.rc))).intoArray(red, row);
            whole(weightB.mul(c.gb).add(c.ga).add(weightC.mul(c.gc))).intoArray(green, row);
            whole(weightB.mul(c.bb).add(c.ba).add(weightC.mul(c.bc))).intoArray(blue, row);
        }
    }

    private static LongVector whole(DoubleVector value) {
        return value.add(WholeNumbers.ROUND).reinterpretAsLongs();
    }

    /** ⌈k⌉ of a k that is 0 or no whole number. */
    private static DoubleVector ceil(DoubleVector k) {
        return k.add(0.5).add(WholeNumbers.ROUND).sub(WholeNumbers.ROUND);
    }

    /**
     * The larger of two as max has it but for what no edge is: −0 and numbers that are none cost it
     * much.
     */
    private static DoubleVector most(DoubleVector a, DoubleVector b) {
        return a.blend(b, a.compare(VectorOperators.LT, b));
    }

    private static DoubleVector least(DoubleVector a, DoubleVector b) {
        return a.blend(b, b.compare(VectorOperators.LT, a));
    }
}
