package rasterlab.exercises.drawing;

import java.util.stream.DoubleStream;

/**
 * The interval [low, high] of an axis that a picture shows. Both are finite and low &lt; high;
 * their difference may be beyond the doubles.
 */
record AxisRange(double low, double high) {
    /** The width of a double's last place beyond which a range of 2 around it shows nothing. */
    private static final double COARSE = 1e-3;

    AxisRange {
        if (!(low < high) || Double.isInfinite(low) || Double.isInfinite(high))
            throw new IllegalArgumentException("no range: " + low + " to " + high);
    }

    /**
     * The smallest and the largest of some finite numbers, which may be equal; infinite for none.
     */
    static double[] limits(DoubleStream values) {
        double[] limits = {Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY};
        values.forEach(
                value -> {
                    limits[0] = Math.min(limits[0], value);
                    limits[1] = Math.max(limits[1], value);
                });
        return limits;
    }

    /** The range that reaches so far on both sides of the middle of two numbers, or farther. */
    static AxisRange around(double low, double high, double reach) {
        double middle = low / 2 + high / 2;
        double least = 8 * Math.ulp(middle);
        double half = Math.max(reach, least);
        return new AxisRange(
                Math.max(-Double.MAX_VALUE, Math.min(low, middle - half)),
                Math.min(Double.MAX_VALUE, Math.max(high, middle + half)));
    }

    /** How far a range should reach around one number alone. */
    static double reachAround(double value) {
        return Math.ulp(value) < COARSE ? 1 : Math.abs(value) / 2;
    }

    /** Half of high − low, which is always finite. */
    double half() {
        return high / 2 - low / 2;
    }

    boolean contains(double value) {
        return low <= value && value <= high;
    }

    /** Where a number lies: 0 at low, 1 at high; it may be infinite far outside. */
    double share(double value) {
        int scale = -2 - Math.max(Math.getExponent(low), Math.getExponent(high));
        double start = Math.scalb(low, scale);
        return (Math.scalb(value, scale) - start) / (Math.scalb(high, scale) - start);
    }
}
