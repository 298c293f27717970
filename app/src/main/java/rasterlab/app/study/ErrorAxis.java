package rasterlab.app.study;

import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Locale;
import rasterlab.engine.study.Measurement;

/**
 * A logarithmic error axis with a place for zero: the decade below the smallest error shown.
 *
 * <p>An error e &gt; 0 stands at e. Exact results stand in lanes between 10^(low − 1) and 10^low,
 * one lane for each method, since they would hide each other on one line.
 *
 * @param low exponent of the axis' lowest decade of real errors
 * @param high exponent of its upper end
 * @param lanes the methods with exact results, from the top lane down
 */
record ErrorAxis(int low, int high, List<String> lanes) {
    ErrorAxis {
        if (low >= high)
            throw new IllegalArgumentException("axis needs low < high, got " + low + ", " + high);
        lanes = List.copyOf(lanes);
    }

    /** The axis on which all these have a place. */
    static ErrorAxis over(List<Measurement> points) {
        List<String> lanes =
                points.stream()
                        .filter(point -> point.error().worst() == 0)
                        .map(Measurement::method)
                        .distinct()
                        .toList();
        DoubleSummaryStatistics real =
                points.stream()
                        .mapToDouble(point -> point.error().worst())
                        .filter(error -> error > 0)
                        .summaryStatistics();
        if (real.getCount() == 0) return new ErrorAxis(-1, 0, lanes);
        int low = (int) Math.floor(Math.log10(real.getMin()));
        int high = Math.max(low + 1, (int) Math.ceil(Math.log10(real.getMax() * 1.2)));
        return new ErrorAxis(low, high, lanes);
    }

    /** Where a point stands, as a value of the logarithmic axis. */
    double position(Measurement point) {
        double error = point.error().worst();
        if (error > 0) return error;
        double lane = lanes.indexOf(point.method()) + 1.0;
        return Math.pow(10, low - lane / (lanes.size() + 1));
    }

    /** A little above that place, for a label: 3.2 % of the axis. */
    double above(double position) {
        return position * Math.pow(10, 0.032 * (high - low + 1));
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

    /**
     * The label of a tick at that value.
     *
     * @param exact the label at the bottom, which stands for exact
     */
    String label(double value, String exact) {
        if (value < border() * 0.999) return exact;
        return value >= 0.001 && value < 1e6
                ? trimmed(String.format(Locale.ROOT, "%.3f", value))
                : String.format(Locale.ROOT, "1e%d", Math.round(Math.log10(value)));
    }

    private static String trimmed(String decimal) {
        return decimal.replaceFirst("\\.?0+$", "");
    }
}
