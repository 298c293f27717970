package rasterlab.engine.geometry.meeting;

import java.math.BigDecimal;
import java.math.MathContext;

/** The reference: μ in decimal numbers of any length, divided to 40 digits. */
final class ExactMeeting {
    private static final MathContext DIGITS = new MathContext(40);

    private ExactMeeting() {}

    /** The μ nearest to the right one; NaN where there is none, or it is beyond doubles. */
    static double mu(double[] normal, double c, double[] from, double[] through) {
        BigDecimal atStart = dot(normal, from);
        BigDecimal slope = dot(normal, through).subtract(atStart);
        if (slope.signum() == 0) return Double.NaN;
        double mu = new BigDecimal(c).subtract(atStart).divide(slope, DIGITS).doubleValue();
        return Double.isFinite(mu) ? mu : Double.NaN;
    }

    private static BigDecimal dot(double[] a, double[] b) {
        BigDecimal sum = BigDecimal.ZERO;
        for (int axis = 0; axis < 3; axis++)
            sum = sum.add(new BigDecimal(a[axis]).multiply(new BigDecimal(b[axis])));
        return sum;
    }
}
