package rasterlab.engine.study.measuring;

import java.util.OptionalInt;

/**
 * The order of two loads that their times, measured in turns, allow.
 *
 * <p>One is faster only where the intervals of both medians part, each taken at least as wide as
 * the machine's noise: that of a load which never changes, measured in the same rounds. Medians
 * nearer than {@link #LEAST_GAP} are never put in an order, however narrow their intervals: where
 * code and data happen to lie makes as much difference from one start of the program to the next.
 * Source: T. Kalibera and R. Jones, Rigorous Benchmarking in Reasonable Time, ISMM 2013; T.
 * Mytkowicz and others, Producing Wrong Data Without Doing Anything Obviously Wrong, ASPLOS 2009.
 *
 * @param order of the first beside the second
 * @param ratio of the first's median to the second's
 * @param low the least that it can be
 * @param high the most that it can be
 * @param more about how many further rounds would settle it; empty where it is settled, or where no
 *     reasonable number would
 */
public record PaceComparison(Order order, double ratio, double low, double high, OptionalInt more) {
    /** The ratio of two medians up to which they are not put in an order. */
    public static final double LEAST_GAP = 1.08;

    /** The most further rounds that are worth naming. */
    private static final int MOST_ROUNDS = 1_000;

    /** How two loads stand to each other. */
    public enum Order {
        FASTER,
        SLOWER,
        /** The medians are the same, but for what is never told apart. */
        ALIKE,
        /** The order is not told on this machine now. */
        OPEN;

        /** Whether further rounds could say no more. */
        public boolean isSettled() {
            return this != OPEN;
        }
    }

    /**
     * The first load beside the second.
     *
     * @param noise how many times the median of a fixed load was off in the same rounds, at least 1
     */
    public static PaceComparison of(Samples first, Samples second, double noise) {
        MedianInterval a = first.interval().widened(noise);
        MedianInterval b = second.interval().widened(noise);
        double ratio = a.median() / b.median();
        double low = a.low() / b.high();
        double high = a.high() / b.low();
        Order order = order(ratio, low, high);
        int rounds = Math.min(first.count(), second.count());
        return new PaceComparison(order, ratio, low, high, more(order, ratio, low, high, rounds));
    }

    private static Order order(double ratio, double low, double high) {
        if (high < 1 && ratio < 1 / LEAST_GAP) return Order.FASTER;
        if (low > 1 && ratio > LEAST_GAP) return Order.SLOWER;
        return high <= LEAST_GAP && low >= 1 / LEAST_GAP ? Order.ALIKE : Order.OPEN;
    }

    /**
     * The width of an interval goes with the square root of the number of rounds: it has to shrink
     * to the distance from the ratio to 1, or to the border of what is alike.
     */
    private static OptionalInt more(
            Order order, double ratio, double low, double high, int rounds) {
        if (order.isSettled()) return OptionalInt.empty();
        double gap = Math.abs(Math.log(ratio));
        double width = Math.max(Math.log(high / ratio), Math.log(ratio / low));
        double border = Math.log(LEAST_GAP);
        double distance = gap > border ? gap : border - gap;
        double times = Math.pow(width / distance, 2);
        double more = Math.ceil(rounds * (times - 1));
        if (!(more <= MOST_ROUNDS)) return OptionalInt.empty();
        return OptionalInt.of((int) Math.max(1, more));
    }
}
