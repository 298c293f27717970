package rasterlab.engine.spline.curve;

/**
 * The differences Δ⁰ … Δⁿ of a polynomial at u for steps of h.
 *
 * <p>Around u the polynomial is Σ c[j]·s^j, and Δᵏ s^j at s = 0 is a(j, k)·h^j with whole numbers
 * a(j, k) = k·(a(j − 1, k) + a(j − 1, k − 1)): no values are subtracted, which would leave few
 * digits of the higher differences.
 */
final class ForwardDifferences {
    private ForwardDifferences() {}

    /**
     * @param falling coefficients of falling powers
     */
    static double[] of(double[] falling, double u, double h) {
        double[] c = around(falling, u);
        int n = c.length - 1;
        var differences = new double[n + 1];
        var whole = new double[n + 1];
        whole[0] = 1;
        differences[0] = c[0];
        double power = 1;
        for (int j = 1; j <= n; j++) {
            power *= h;
            for (int k = j; k > 0; k--) whole[k] = k * (whole[k] + whole[k - 1]);
            whole[0] = 0;
            for (int k = 1; k <= j; k++) differences[k] += whole[k] * power * c[j];
        }
        return differences;
    }

    /** Coefficients of rising powers of s = x − u, by Horner's scheme again and again. */
    private static double[] around(double[] falling, double u) {
        int n = falling.length - 1;
        double[] rest = falling.clone();
        var rising = new double[n + 1];
        for (int j = 0; j <= n; j++) {
            for (int i = 1; i <= n - j; i++) rest[i] += u * rest[i - 1];
            rising[j] = rest[n - j];
        }
        return rising;
    }
}
