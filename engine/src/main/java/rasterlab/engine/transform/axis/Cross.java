package rasterlab.engine.transform.axis;

import rasterlab.engine.transform.CountingArithmetic;

/** One coordinate of the cross product a × b. */
final class Cross {
    private Cross() {}

    static double of(double[] a, double[] b, int i) {
        int j = i == 2 ? 0 : i + 1;
        int k = i == 0 ? 2 : i - 1;
        return a[j] * b[k] - a[k] * b[j];
    }

    /** One component of the cross product, with its operations counted. */
    static double of(CountingArithmetic on, double[] a, double[] b, int i) {
        int j = i == 2 ? 0 : i + 1;
        int k = i == 0 ? 2 : i - 1;
        return on.minus(on.times(a[j], b[k]), on.times(a[k], b[j]));
    }
}
