package rasterlab.engine.geometry.meeting;

import java.math.BigDecimal;
import java.math.MathContext;
import rasterlab.contract.LinePlane;

/**
 * The reference: μ in decimal numbers of any length, divided to 40 digits. It answers with the μ
 * nearest to the right one; NaN where there is none, or it is beyond doubles.
 */
final class ExactMeeting implements LinePlane {
    private static final MathContext DIGITS = new MathContext(40);

    @Override
    public double meets(double[] normal, double c, double[] from, double[] through) {
        return mu(normal, new BigDecimal(c), from, through);
    }

    @Override
    public double meetsThrough(double[] normal, double[] point, double[] from, double[] through) {
        return mu(normal, dot(normal, point), from, through);
    }

    private static double mu(double[] normal, BigDecimal c, double[] from, double[] through) {
        BigDecimal atStart = dot(normal, from);
        BigDecimal slope = dot(normal, through).subtract(atStart);
        if (slope.signum() == 0) return Double.NaN;
        double mu = c.subtract(atStart).divide(slope, DIGITS).doubleValue();
        return Double.isFinite(mu) ? mu : Double.NaN;
    }

    private static BigDecimal dot(double[] a, double[] b) {
        BigDecimal sum = BigDecimal.ZERO;
        for (int axis = 0; axis < 3; axis++)
            sum = sum.add(new BigDecimal(a[axis]).multiply(new BigDecimal(b[axis])));
        return sum;
    }
}
