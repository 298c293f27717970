package rasterlab.app.study.chart;

import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.stream.IntStream;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.ParetoFront;

/**
 * A logarithmic error axis with a place for zero: a band below the decade of the smallest error.
 *
 * <p>An error e that does not count as exact stands at e. Exact results stand in lanes between
 * {@link #bottom} and {@link #border}, one lane for each method, since they would hide each other
 * on one line. The band is no part of the scale: it has no numbers, and its height depends only on
 * how many lanes it has.
 *
 * @param low exponent of the axis' lowest decade of real errors
 * @param high exponent of its upper end
 * @param lanes the methods with exact results, from the top lane down
 * @param endless whether an error without a number stands at its upper end
 */
record ErrorAxis(int low, int high, List<String> lanes, boolean endless) {
    /** The gap between the least number and the band of zero, in shares of the scale. */
    private static final double GAP = 0.04;

    /** Numbers beside each other are at least this share of the axis apart. */
    private static final double LEAST_GAP = 0.045;

    ErrorAxis {
        if (low >= high)
            throw new IllegalArgumentException("axis needs low < high, got " + low + ", " + high);
        lanes = List.copyOf(lanes);
    }

    /** The axis on which all these have a place. */
    static ErrorAxis over(List<Measurement> points) {
        List<String> lanes =
                points.stream()
                        .filter(point -> ParetoFront.error(point) == 0)
                        .map(Measurement::method)
                        .distinct()
                        .toList();
        DoubleSummaryStatistics real =
                points.stream()
                        .mapToDouble(ParetoFront::error)
                        .filter(error -> error > 0 && Double.isFinite(error))
                        .summaryStatistics();
        boolean endless =
                points.stream().anyMatch(point -> Double.isInfinite(ParetoFront.error(point)));
        if (real.getCount() == 0) return new ErrorAxis(-1, 0, lanes, endless);
        int low = (int) Math.floor(Math.log10(real.getMin()));
        int high = Math.max(low + 1, (int) Math.ceil(Math.log10(real.getMax() * 1.2)));
        return new ErrorAxis(low, high, lanes, endless);
    }

    /** Where a point stands, as a value of the axis; an infinite error at its upper end. */
    double position(Measurement point) {
        double error = ParetoFront.error(point);
        if (error != 0) return Double.isFinite(error) ? error : top();
        double lane = lanes.indexOf(point.method()) + 1.0;
        return border() * Math.pow(10, -band() * lane / (lanes.size() + 1));
    }

    /** Height of the band of zero, in decades of the axis: a tenth to three fifths of the rest. */
    private double band() {
        return (high - low) * Math.min(0.6, 0.06 + 0.04 * lanes.size());
    }

    double bottom() {
        return border() * Math.pow(10, -band());
    }

    double top() {
        return Math.pow(10, high);
    }

    /** Upper edge of the band of zero, a little below the least number. */
    double border() {
        return Math.pow(10, low - GAP * (high - low));
    }

    /** The powers of ten that have a number, from the lowest up. */
    List<Double> ticks() {
        int step = (int) Math.ceil((high - low + band()) * LEAST_GAP);
        return IntStream.rangeClosed(low, high)
                .filter(power -> (power - low) % step == 0)
                .mapToObj(power -> Math.pow(10, power))
                .toList();
    }

    /**
     * The label of a multiple of a power of ten; empty where it has none. That of the band of zero
     * stands at the multiple next to its middle.
     */
    String label(double value, StudyWords words) {
        if (value < border() * 0.999)
            return LogTicks.same(value, middleOfZero()) ? words.exact() : "";
        if (endless && LogTicks.same(value, top())) return words.notRightShort();
        return ticks().stream().anyMatch(tick -> LogTicks.same(value, tick))
                ? LogTicks.label(value, words.locale())
                : "";
    }

    private double middleOfZero() {
        return LogTicks.nearestMultiple(border() * Math.pow(10, -band() / 2));
    }
}
