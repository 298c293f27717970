package rasterlab.engine.study.measuring;

import java.util.Arrays;

/**
 * A median with the interval in which the true one lies, in at least 99 of 100 measurements where
 * there are eight values or more; of fewer it is all that was seen.
 *
 * <p>It asks nothing of how the values are distributed: of n values in order, that of rank j and
 * the one of rank n + 1 − j enclose the true median unless at most j − 1 of n fair coins fall on
 * one side. Source: J.-Y. Le Boudec, Performance Evaluation of Computer and Communication Systems,
 * EPFL Press 2010, theorem 2.1; T. Hoefler and R. Belli, Scientific Benchmarking of Parallel
 * Computing Systems, SC 2015, rules 5 and 6.
 *
 * @param low lower end, at most {@code median}
 * @param median of the values
 * @param high upper end, at least {@code median}
 */
public record MedianInterval(double low, double median, double high) {
    /** The share of measurements in which an interval holds the true median. */
    public static final double CONFIDENCE = 0.99;

    public MedianInterval {
        if (!(low <= median && median <= high))
            throw new IllegalArgumentException(
                    "interval must be low ≤ median ≤ high, got "
                            + (low + ", " + median + ", " + high));
    }

    /** A median that is known without an interval. */
    public static MedianInterval exact(double median) {
        return new MedianInterval(median, median, median);
    }

    /**
     * The interval of these values' median.
     *
     * @throws IllegalArgumentException if there is no value
     */
    public static MedianInterval ofMedian(double[] values) {
        if (values.length == 0) throw new IllegalArgumentException("a median needs a value, got 0");
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        int rank = rank(sorted.length);
        return new MedianInterval(
                sorted[rank - 1], quantile(sorted, 0.5), sorted[sorted.length - rank]);
    }

    /**
     * The largest rank j from below whose interval still holds the true median often enough, at
     * least 1. Terms are kept as logarithms: of more than 1074 values the first is below all
     * doubles.
     */
    static int rank(int n) {
        double logOfTerm = -n * Math.log(2);
        double below = Math.exp(logOfTerm);
        int rank = 1;
        for (int j = 1; j <= n / 2; j++) {
            logOfTerm += Math.log((n - j + 1.0) / j);
            below += Math.exp(logOfTerm);
            if (1 - 2 * below < CONFIDENCE) break;
            rank = j + 1;
        }
        return rank;
    }

    /** The value at {@code share} of the way through the sorted values, between them linearly. */
    public static double quantile(double[] sorted, double share) {
        double place = share * (sorted.length - 1);
        int below = (int) place;
        int above = Math.min(below + 1, sorted.length - 1);
        return sorted[below] + (place - below) * (sorted[above] - sorted[below]);
    }

    /** How many times the median may be off, at least 1. */
    public double factor() {
        return Math.max(high / median, median / low);
    }

    /** This median, off by at least so many times. */
    public MedianInterval widened(double factor) {
        return new MedianInterval(
                Math.min(low, median / factor), median, Math.max(high, median * factor));
    }
}
