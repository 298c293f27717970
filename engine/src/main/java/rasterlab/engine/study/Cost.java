package rasterlab.engine.study;

import java.util.Map;

/**
 * What one item cost.
 *
 * @param medianNanos nanoseconds per item, the median of the rounds; 0 where nothing was timed
 * @param lowNanos first quartile of the rounds
 * @param highNanos third quartile of the rounds
 * @param counts what was counted instead of timed, free of noise: name to the total of one pass
 *     over the workload
 */
public record Cost(
        double medianNanos, double lowNanos, double highNanos, Map<String, Long> counts) {
    /** The cost of a method that could not be timed. */
    public static final Cost NONE = new Cost(0, 0, 0, Map.of());

    public Cost {
        if (!(0 <= lowNanos && lowNanos <= medianNanos && medianNanos <= highNanos))
            throw new IllegalArgumentException(
                    "nanoseconds must be 0 ≤ low ≤ median ≤ high, got "
                            + (lowNanos + ", " + medianNanos + ", " + highNanos));
        counts = Map.copyOf(counts);
    }

    /** Whether there is a time at all. */
    public boolean timed() {
        return medianNanos > 0;
    }
}
