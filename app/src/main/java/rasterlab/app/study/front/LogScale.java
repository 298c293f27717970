package rasterlab.app.study.front;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * A logarithmic axis on a picture.
 *
 * @param low least value, above 0
 * @param high greatest value, above {@code low}
 * @param from where {@code low} is, in pixels
 * @param to where {@code high} is
 */
record LogScale(double low, double high, double from, double to) {
    private static final int MOST_TICKS = 9;

    /** The ratio below which all values are about one, which gets an axis around it. */
    private static final double FLAT = 1.02;

    LogScale {
        if (!(0 < low && low < high))
            throw new IllegalArgumentException(
                    "axis needs 0 < low < high, got " + low + ", " + high);
    }

    /** The axis on which all these have a place, with a margin at both ends. */
    static LogScale over(List<Double> values, double from, double to) {
        double least = values.stream().mapToDouble(one -> one).min().orElse(1);
        double most = values.stream().mapToDouble(one -> one).max().orElse(10);
        double margin = most / least < FLAT ? 2 : Math.max(1.15, Math.pow(most / least, 0.06));
        return new LogScale(least / margin, most * margin, from, to);
    }

    /** Where a value is; outside the axis at its nearer end. */
    double at(double value) {
        double kept = Math.max(low, Math.min(high, value));
        return from + (to - from) * Math.log(kept / low) / Math.log(high / low);
    }

    /**
     * The values that have a number: powers of ten, where these are few also 2 and 5 times them,
     * and still more where there are less than two.
     */
    List<Double> ticks() {
        int first = (int) Math.floor(Math.log10(low));
        int last = (int) Math.ceil(Math.log10(high));
        List<Double> ticks = ticks(last - first <= 3 ? List.of(1.0, 2.0, 5.0) : List.of(1.0));
        for (int parts = 1; ticks.size() < 2 && parts <= 10; parts *= 10) {
            int all = parts;
            ticks =
                    ticks(
                            IntStream.range(parts, 10 * parts)
                                    .mapToObj(part -> part / (double) all)
                                    .toList());
        }
        return ticks;
    }

    private List<Double> ticks(List<Double> factors) {
        int first = (int) Math.floor(Math.log10(low));
        int last = (int) Math.ceil(Math.log10(high));
        int step = Math.max(1, (last - first) / MOST_TICKS);
        var ticks = new ArrayList<Double>();
        for (int power = first; power <= last; power++)
            for (double factor : factors) {
                double tick = factor * Math.pow(10, power);
                if (low <= tick && tick <= high && (power - first) % step == 0) ticks.add(tick);
            }
        return ticks;
    }
}
