package rasterlab.app.study.chart;

import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Locale;
import rasterlab.engine.study.Measurement;

/**
 * A logarithmic cost axis whose numbers have room: 1, 2 and 5 of each decade, of many decades only
 * the powers of ten.
 *
 * @param left lower end, a number the axis shows
 * @param right upper end, a number the axis shows
 */
record CostAxis(double left, double right) {
    private static final List<Integer> FEW = List.of(1, 2, 5);

    /** Decades from which on only powers of ten have a number. */
    private static final double MANY_DECADES = 3.5;

    /** The number of decades beyond which not even each power of ten has a mark. */
    private static final double MOST_DECADES = 12;

    CostAxis {
        if (!(0 < left && left < right))
            throw new IllegalArgumentException(
                    "axis needs 0 < left < right, got " + left + ", " + right);
    }

    /** The axis on which all these have a place. */
    static CostAxis over(List<Measurement> points) {
        DoubleSummaryStatistics costs =
                points.stream()
                        .mapToDouble(point -> point.cost().medianNanos())
                        .summaryStatistics();
        if (costs.getCount() == 0) return new CostAxis(1, 10);
        return new CostAxis(below(costs.getMin() * 0.95), above(costs.getMax() * 1.05));
    }

    private static double below(double cost) {
        double power = Math.pow(10, Math.floor(Math.log10(cost)));
        double below = power;
        for (int factor : FEW) if (factor * power <= cost) below = factor * power;
        return below;
    }

    private static double above(double cost) {
        double power = Math.pow(10, Math.floor(Math.log10(cost)));
        for (int factor : FEW) if (factor * power >= cost) return factor * power;
        return 10 * power;
    }

    private double decades() {
        return Math.log10(right / left);
    }

    /** The values that have a number, from the left. */
    List<Double> ticks() {
        boolean many = decades() > MANY_DECADES;
        int step = (int) Math.ceil(decades() / MOST_DECADES);
        var ticks = new ArrayList<Double>();
        int lowest = (int) Math.floor(Math.log10(left) + 1e-9);
        for (int power = lowest; power <= Math.ceil(Math.log10(right) - 1e-9); power++)
            for (int factor : many ? List.of(1) : FEW) {
                double tick = factor * Math.pow(10, power);
                if ((power - lowest) % step == 0 && isShown(tick)) ticks.add(tick);
            }
        return ticks;
    }

    private boolean isShown(double value) {
        return left * 0.999 < value && value < right * 1.001;
    }

    /** The label of a multiple of a power of ten; empty where it has none. */
    String label(double value, Locale locale) {
        return ticks().stream().anyMatch(tick -> LogTicks.same(value, tick))
                ? LogTicks.label(value, locale)
                : "";
    }
}
