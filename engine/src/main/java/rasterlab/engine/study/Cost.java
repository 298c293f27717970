package rasterlab.engine.study;

import java.util.List;
import java.util.Map;
import rasterlab.engine.study.measuring.MedianInterval;
import rasterlab.engine.study.measuring.Samples;

/**
 * The cost of one item.
 *
 * @param medianNanos nanoseconds per item, the median of the rounds; 0 where nothing was timed
 * @param lowNanos first quartile of the rounds
 * @param highNanos third quartile of the rounds
 * @param counts what was counted instead of timed, free of noise: name to the total of one pass
 *     over the workload
 * @param rounds nanoseconds per item, round by round; none where only the median is known
 */
public record Cost(
        double medianNanos,
        double lowNanos,
        double highNanos,
        Map<String, Long> counts,
        List<Double> rounds) {
    /** The cost of a method that could not be timed. */
    public static final Cost NONE = new Cost(0, 0, 0, Map.of());

    public Cost {
        if (!(0 <= lowNanos && lowNanos <= medianNanos && medianNanos <= highNanos))
            throw new IllegalArgumentException(
                    "nanoseconds must be 0 ≤ low ≤ median ≤ high, got "
                            + (lowNanos + ", " + medianNanos + ", " + highNanos));
        counts = Map.copyOf(counts);
        rounds = List.copyOf(rounds);
    }

    /** A cost of which no single rounds are known. */
    public Cost(double medianNanos, double lowNanos, double highNanos, Map<String, Long> counts) {
        this(medianNanos, lowNanos, highNanos, counts, List.of());
    }

    /** The cost that those rounds had; {@link #NONE} but for the counts where there are none. */
    public static Cost of(List<Double> rounds, Map<String, Long> counts) {
        if (rounds.isEmpty()) return new Cost(0, 0, 0, counts);
        double[] sorted = rounds.stream().mapToDouble(Double::doubleValue).sorted().toArray();
        return new Cost(
                MedianInterval.quantile(sorted, 0.5),
                MedianInterval.quantile(sorted, 0.25),
                MedianInterval.quantile(sorted, 0.75),
                counts,
                rounds);
    }

    /** Whether there is a time at all. */
    public boolean timed() {
        return medianNanos > 0;
    }

    /** The rounds, or the median alone where they are not known. */
    public Samples samples() {
        return Samples.of(rounds.isEmpty() ? List.of(medianNanos) : rounds);
    }

    /**
     * How far the median can be believed.
     *
     * @param noise how many times a fixed load's median was off beside it, at least 1
     */
    public MedianInterval interval(double noise) {
        return samples().interval().widened(noise);
    }
}
