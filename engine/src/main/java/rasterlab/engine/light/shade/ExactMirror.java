package rasterlab.engine.light.shade;

import java.math.BigDecimal;
import java.math.MathContext;
import rasterlab.contract.LitPoint;

/**
 * The cosine r·v of Phong's specular term without rounding before its last step: where it is next
 * to 0, an exponent below 1 makes much of the last digits, and of its sign.
 */
final class ExactMirror {
    private static final MathContext DIGITS = MathContext.DECIMAL64;

    private ExactMirror() {}

    /**
     * The cosine r·v to a power; 0 where it is negative. Its power of ten goes apart, as it can be
     * far below the smallest double.
     *
     * @param exponent above 0, below 1
     */
    static double power(LitPoint point, double exponent) {
        BigDecimal scaled = scaled(point);
        if (scaled.signum() <= 0) return 0;
        double[] n = point.normal();
        BigDecimal lengths =
                dot(point.toLight(), point.toLight())
                        .multiply(dot(point.toEye(), point.toEye()))
                        .sqrt(DIGITS)
                        .multiply(dot(n, n));
        BigDecimal cosine = scaled.divide(lengths, DIGITS);
        int ten = cosine.precision() - cosine.scale();
        double digits = cosine.scaleByPowerOfTen(-ten).doubleValue();
        return Math.pow(digits, exponent) * Math.pow(10, ten * exponent);
    }

    /** 2·(n·l)·(n·v) − (l·v)·(n·n), which is r·v times |n|²·|l|·|v|. */
    private static BigDecimal scaled(LitPoint point) {
        double[] n = point.normal();
        double[] l = point.toLight();
        double[] v = point.toEye();
        return dot(n, l)
                .multiply(dot(n, v))
                .multiply(BigDecimal.valueOf(2))
                .subtract(dot(l, v).multiply(dot(n, n)));
    }

    private static BigDecimal dot(double[] a, double[] b) {
        BigDecimal sum = BigDecimal.ZERO;
        for (int i = 0; i < 3; i++)
            sum = sum.add(new BigDecimal(a[i]).multiply(new BigDecimal(b[i])));
        return sum;
    }
}
