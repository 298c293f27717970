package rasterlab.engine.light.face;

import java.math.BigDecimal;

/** Sums of square roots, of which only the sign is asked for: found without rounding. */
final class RootSum {
    private static final BigDecimal TWO = BigDecimal.valueOf(2);

    private RootSum() {}

    /**
     * The sign of a + b·√p + c·√q: where the last has another sign than the rest, by squares.
     *
     * @param p above 0, as is q
     */
    static int signum(BigDecimal a, BigDecimal b, BigDecimal p, BigDecimal c, BigDecimal q) {
        int first = signum(a, b, p);
        int last = c.signum();
        if (first * last >= 0) return Integer.signum(first + last);
        BigDecimal rest = a.pow(2).add(b.pow(2).multiply(p)).subtract(c.pow(2).multiply(q));
        return first * signum(rest, TWO.multiply(a).multiply(b), p);
    }

    private static int signum(BigDecimal a, BigDecimal b, BigDecimal p) {
        if (a.signum() * b.signum() >= 0) return Integer.signum(a.signum() + b.signum());
        return a.signum() * a.pow(2).compareTo(b.pow(2).multiply(p));
    }
}
