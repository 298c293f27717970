package rasterlab.engine.light.face;

import java.math.BigDecimal;
import java.math.MathContext;

/**
 * The sign of n·l for a mixed normal n, to as many digits as it takes.
 *
 * <p>The sum t of three terms q/√s, the largest m, is 0 or at least 10⁻⁹⁰⁰⁰·m in size: the product
 * N of t and of its three companions with other signs of the terms is a fraction over the squares
 * of all s, of numbers whose last bit is at least 2⁻²⁵⁷⁷⁶, the coordinates are at most 10⁷⁵, and t
 * is at least N/(3·m)³.
 */
final class ExactSide {
    private static final int[] DIGITS = {60, 600, 10_000};

    /** Digits that the roundings of the terms may take. */
    private static final int LOST = 3;

    private ExactSide() {}

    /**
     * The sign of the sum of wₖ·(nₖ·l)/|nₖ|.
     *
     * @param weights three of each point, those of this one from {@code at} on
     */
    static int signum(double[] normals, double[] weights, int at, BigDecimal[] toLight) {
        var along = new BigDecimal[3];
        var square = new BigDecimal[3];
        for (int k = 0; k < 3; k++) {
            along[k] = BigDecimal.ZERO;
            square[k] = BigDecimal.ZERO;
            for (int c = 0; c < 3; c++) {
                var n = new BigDecimal(normals[3 * k + c]);
                along[k] = along[k].add(n.multiply(toLight[c]));
                square[k] = square[k].add(n.pow(2));
            }
            along[k] = along[k].multiply(new BigDecimal(weights[at + k]));
        }
        for (int digits : DIGITS) {
            BigDecimal sum = BigDecimal.ZERO;
            BigDecimal most = BigDecimal.ZERO;
            for (int k = 0; k < 3; k++) {
                if (along[k].signum() == 0) continue;
                var by = new MathContext(digits);
                BigDecimal term = along[k].divide(square[k].sqrt(by), by);
                sum = sum.add(term);
                most = most.max(term.abs());
            }
            if (sum.abs().compareTo(most.scaleByPowerOfTen(LOST - digits)) > 0) return sum.signum();
        }
        return 0;
    }
}
