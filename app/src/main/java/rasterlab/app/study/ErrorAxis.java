package rasterlab.app.study;

import java.util.Collection;
import java.util.Locale;

/**
 * A logarithmic error axis with a place for zero: the decade below the smallest error shown.
 *
 * <p>An error e &gt; 0 stands at e. Exact results stand in lanes between 10^(low − 1) and 10^low,
 * one lane for each method, since they would hide each other on one line.
 *
 * @param low exponent of the axis' lowest decade of real errors
 * @param high exponent of its upper end
 * @param lanes number of lanes for exact results
 */
record ErrorAxis(int low, int high, int lanes) {
    ErrorAxis {
        if (low >= high)
            throw new IllegalArgumentException("axis needs low < high, got " + low + ", " + high);
        if (lanes < 1) throw new IllegalArgumentException("axis needs a lane, got " + lanes);
    }

    /** The axis that shows all these errors, of which those that are 0 are exact. */
    static ErrorAxis over(Collection<Double> errors, int lanes) {
        double least = errors.stream().filter(e -> e > 0).min(Double::compare).orElse(0.1);
        double most = errors.stream().filter(e -> e > 0).max(Double::compare).orElse(1.0);
        int low = (int) Math.floor(Math.log10(least));
        int high = Math.max(low + 1, (int) Math.ceil(Math.log10(most * 1.2)));
        return new ErrorAxis(low, high, lanes);
    }

    /** Where an error stands, as a value of the logarithmic axis. */
    double position(double error, int lane) {
        return error > 0 ? error : Math.pow(10, low - (lane + 1.0) / (lanes + 1));
    }

    double bottom() {
        return Math.pow(10, low - 1);
    }

    double top() {
        return Math.pow(10, high);
    }

    /** The line between exact results and real errors. */
    double border() {
        return Math.pow(10, low);
    }

    /** The label of a tick at that value; "0" at the bottom, which stands for exact. */
    String label(double value) {
        if (value < border() * 0.999) return "0 (exact)";
        return value >= 0.001 && value < 1e6
                ? trimmed(String.format(Locale.ROOT, "%.3f", value))
                : String.format(Locale.ROOT, "1e%d", Math.round(Math.log10(value)));
    }

    private static String trimmed(String decimal) {
        return decimal.replaceFirst("\\.?0+$", "");
    }
}
