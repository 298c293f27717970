package rasterlab.engine.pipeline.triangle;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.LongVector;
import jdk.incubator.vector.VectorSpecies;

/**
 * What {@link TriangleScan#scan} finds, and what rows begin with, four rows at a time. One per
 * thread.
 *
 * <p>The edge functions are whole numbers below 2⁵², so doubles hold them, and a half more,
 * exactly.
 */
final class VectorRows {
    private static final VectorSpecies<Double> FOUR = DoubleVector.SPECIES_256;
    private static final DoubleVector NUMBERS =
            DoubleVector.fromArray(FOUR, new double[] {0, 1, 2, 3}, 0);

    /** Added and taken away again it rounds to the nearest whole number. */
    private static final double ROUND = 0x1.8p52;

    /** Above every number of pixels. */
    private static final double NO_END = 0x1p20;

    /** For each row: the first pixel counted from the box's left, the number of pixels. */
    private final double[] from = new double[TriangleScan.ROWS];

    private final double[] count = new double[TriangleScan.ROWS];

    /** Depth and colours at each row's first pixel; of a colour the lower half is its number. */
    final double[] z = new double[TriangleScan.ROWS];

    final long[] red = new long[TriangleScan.ROWS];
    final long[] green = new long[TriangleScan.ROWS];
    final long[] blue = new long[TriangleScan.ROWS];

    void scan(TriangleScan s) {
        double perA = -1.0 / s.stepA;
        double perB = -1.0 / s.stepB;
        double perC = -1.0 / s.stepC;
        // 1 and 0 where the pixels begin at the edge, 0 and far away where they end there.
        double beginA = s.stepA < 0 ? 0 : 1;
        double beginB = s.stepB < 0 ? 0 : 1;
        double beginC = s.stepC < 0 ? 0 : 1;
        double endA = beginA * NO_END;
        double endB = beginB * NO_END;
        double endC = beginC * NO_END;
        double stepB = s.stepB;
        double stepC = s.stepC;
        double width = s.boxRight - s.boxLeft;
        DoubleVector eA = NUMBERS.mul(s.downA).add(s.rowA + 0.5);
        DoubleVector eB = NUMBERS.mul(s.downB).add(s.rowB + 0.5);
        DoubleVector eC = NUMBERS.mul(s.downC).add(s.rowC + 0.5);
        for (int row = 0; row < s.rows; row += FOUR.length()) {
            DoubleVector kA = ceil(eA.mul(perA), width);
            DoubleVector kB = ceil(eB.mul(perB), width);
            DoubleVector kC = ceil(eC.mul(perC), width);
            DoubleVector first = kA.mul(beginA).max(kB.mul(beginB)).max(kC.mul(beginC));
            DoubleVector last = kA.add(endA).min(kB.add(endB)).min(kC.add(endC)).min(width);
            first.intoArray(from, row);
            last.sub(first).max(0).intoArray(count, row);
            first.mul(stepB).add(eB.sub(s.ownB + 0.5)).intoArray(s.edgeB, row);
            first.mul(stepC).add(eC.sub(s.ownC + 0.5)).intoArray(s.edgeC, row);
            eA = eA.add(4.0 * s.downA);
            eB = eB.add(4.0 * s.downB);
            eC = eC.add(4.0 * s.downC);
        }
        for (int row = 0; row < s.rows; row++) {
            s.left[row] = s.boxLeft + (int) from[row];
            s.count[row] = (int) count[row];
        }
    }

    /** Finds what {@link LinearColors#at} finds, for all rows. */
    void start(TriangleScan s, LinearColors c) {
        double inverse = s.inverseArea;
        for (int row = 0; row < s.rows; row += FOUR.length()) {
            DoubleVector weightB = DoubleVector.fromArray(FOUR, s.edgeB, row).mul(inverse);
            DoubleVector weightC = DoubleVector.fromArray(FOUR, s.edgeC, row).mul(inverse);
            weightB.mul(c.zb).add(c.za).add(weightC.mul(c.zc)).intoArray(z, row);
            whole(weightB.mul(c.rb).add(c.ra).add(weightC.mul(c.rc))).intoArray(red, row);
            whole(weightB.mul(c.gb).add(c.ga).add(weightC.mul(c.gc))).intoArray(green, row);
            whole(weightB.mul(c.bb).add(c.ba).add(weightC.mul(c.bc))).intoArray(blue, row);
        }
    }

    private static LongVector whole(DoubleVector value) {
        return value.add(LinearColors.ROUND).reinterpretAsLongs();
    }

    /** The least whole number above k, which is none, cut to 0 to {@code width}. */
    private static DoubleVector ceil(DoubleVector k, double width) {
        return k.max(-0.25).min(width - 0.25).add(0.5).add(ROUND).sub(ROUND);
    }
}
