package rasterlab.engine.visibility.depth;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import rasterlab.contract.DepthRange;

/** Stored numbers and where the next ones begin, in decimals of 80 digits. */
final class ExactCode {
    private static final MathContext DIGITS = new MathContext(80);

    private ExactCode() {}

    /** (1/near − 1/z)/(1/near − 1/far). */
    static BigDecimal window(DepthRange range, double z) {
        return inverse(range.near()).subtract(inverse(z)).divide(nearnesses(range), DIGITS);
    }

    /** (z − near)/(far − near). */
    static BigDecimal linear(DepthRange range, double z) {
        BigDecimal near = new BigDecimal(range.near());
        return new BigDecimal(z)
                .subtract(near)
                .divide(new BigDecimal(range.far()).subtract(near), DIGITS);
    }

    /** The depth of a window depth. */
    static BigDecimal depth(DepthRange range, BigDecimal window) {
        BigDecimal nearness =
                inverse(range.near()).subtract(window.multiply(nearnesses(range), DIGITS));
        return BigDecimal.ONE.divide(nearness, DIGITS);
    }

    /** A share of 2ⁿ − 1, not rounded. */
    static BigDecimal number(BigDecimal share, int bits) {
        return share.multiply(BigDecimal.valueOf(2).pow(bits).subtract(BigDecimal.ONE));
    }

    /** Half a step above the number that this one is rounded to, as a share. */
    static BigDecimal nextBegins(BigDecimal share, int bits) {
        BigDecimal half = new BigDecimal("0.5");
        BigDecimal stored = number(share, bits).add(half).setScale(0, RoundingMode.FLOOR);
        return stored.add(half)
                .divide(BigDecimal.valueOf(2).pow(bits).subtract(BigDecimal.ONE), DIGITS);
    }

    private static BigDecimal nearnesses(DepthRange range) {
        BigDecimal far = range.far() < 1 / 0.0 ? inverse(range.far()) : BigDecimal.ZERO;
        return inverse(range.near()).subtract(far);
    }

    private static BigDecimal inverse(double value) {
        return BigDecimal.ONE.divide(new BigDecimal(value), DIGITS);
    }
}
