package rasterlab.engine.clip;

import java.math.BigDecimal;

/**
 * On which side of the line a→b a point c lies: the sign of (bx − ax)·(cy − ay) − (by − ay)·(cx −
 * ax), above 0 to the left, exactly.
 *
 * <p>In doubles each product errs by a share of 3·u at most (u = 2⁻⁵³), the difference by another
 * u; a result beyond {@value #ROUNDING} times the sum of the products' sizes has the right sign.
 * Otherwise, and where products might underflow, it is computed without rounding.
 */
final class Turn {
    private static final double ROUNDING = 5 * 0x1p-53;
    private static final double SMALLEST = 0x1p-960;

    private Turn() {}

    static int of(double ax, double ay, double bx, double by, double cx, double cy) {
        double left = (bx - ax) * (cy - ay);
        double right = (by - ay) * (cx - ax);
        double difference = left - right;
        double sizes = Math.abs(left) + Math.abs(right);
        if (Math.abs(difference) > ROUNDING * sizes
                && sizes > SMALLEST
                && sizes <= Double.MAX_VALUE) return difference > 0 ? 1 : -1;
        return exactly(ax, ay, bx, by, cx, cy).signum();
    }

    /** Twice the area of the triangle, above 0 where it turns left. */
    static BigDecimal exactly(double ax, double ay, double bx, double by, double cx, double cy) {
        return difference(bx, ax)
                .multiply(difference(cy, ay))
                .subtract(difference(by, ay).multiply(difference(cx, ax)));
    }

    private static BigDecimal difference(double a, double b) {
        return UnroundedInterval.difference(a, b);
    }
}
