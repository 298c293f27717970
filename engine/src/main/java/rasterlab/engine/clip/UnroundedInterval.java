package rasterlab.engine.clip;

import java.math.BigDecimal;

/**
 * The t of what is left of a segment, as fractions without rounding: what methods hand over to
 * where doubles cannot decide.
 *
 * <p>Every double is a finite decimal, and so are sums and products of them. A border is given by
 * the signed distances of both ends from it, in any unit, at least 0 within; between them the
 * distance is linear in t, so t = d0/(d0 − d1) at the border. Fractions are compared by multiplying
 * across.
 */
public final class UnroundedInterval {
    private Fraction enter = Fraction.ZERO;
    private Fraction leave = Fraction.ONE;

    /**
     * Cuts at one border.
     *
     * @param d0 signed distance of the first end, {@code d1} of the second
     * @return whether something is left
     */
    public boolean cut(BigDecimal d0, BigDecimal d1) {
        boolean out0 = d0.signum() < 0;
        boolean out1 = d1.signum() < 0;
        if (out0 && out1) return false;
        if (out0) {
            var t = new Fraction(d0.negate(), d1.subtract(d0));
            if (t.compareTo(enter) > 0) enter = t;
        } else if (out1) {
            var t = new Fraction(d0, d0.subtract(d1));
            if (t.compareTo(leave) < 0) leave = t;
        }
        return enter.compareTo(leave) <= 0;
    }

    /** Cuts at the border coordinate = {@code least}, the larger coordinates being within. */
    public boolean cutBelow(double c0, double c1, double least) {
        return cut(difference(c0, least), difference(c1, least));
    }

    /** Cuts at the border coordinate = {@code most}, the smaller coordinates being within. */
    public boolean cutAbove(double c0, double c1, double most) {
        return cut(difference(most, c0), difference(most, c1));
    }

    /** a − b, exactly. */
    public static BigDecimal difference(double a, double b) {
        return new BigDecimal(a).subtract(new BigDecimal(b));
    }

    /** The coordinate that is {@code c0} at t = 0 and {@code c1} at t = 1, where it enters. */
    public double atEnter(double c0, double c1) {
        return enter.over().signum() == 0 ? c0 : enter.between(c0, c1);
    }

    /** The coordinate where it leaves. */
    public double atLeave(double c0, double c1) {
        return leave.equals(Fraction.ONE) ? c1 : leave.between(c0, c1);
    }
}
