package rasterlab.tests.bench.pipeline;

import java.util.Arrays;
import java.util.Locale;

/**
 * Times of several ways to do one thing, taken in turn, so that what slows the machine for a while
 * slows them all.
 *
 * <p>A turn is {@value #RUNS} runs on end, as one way draws an animation: most of them find in the
 * caches what the way itself left there, not another one.
 */
final class InterleavedTimes {
    private static final int RUNS = 8;

    private final double[][] millis;

    /**
     * How long a measurement is.
     *
     * @param turns how many turns each way has
     * @param warmUpSeconds how long each way runs before: of 6, on a quiet machine, the compiler
     *     has done with what is run most; of 12 where it shares the only core
     */
    record Length(int turns, double warmUpSeconds) {
        static Length of(boolean quick) {
            int times = Runtime.getRuntime().availableProcessors() == 1 ? 2 : 1;
            return quick ? new Length(3, 2 * times) : new Length(10, 6 * times);
        }

        /** A length of as many times the turns after the same warm-up. */
        Length times(int factor) {
            return new Length(factor * turns, warmUpSeconds);
        }
    }

    InterleavedTimes(Length length, Runnable... ways) {
        millis = new double[ways.length][length.turns * RUNS];
        warmUp(length.warmUpSeconds, ways);
        for (int turn = 0; turn < length.turns; turn++)
            for (int way = 0; way < ways.length; way++)
                for (int run = 0; run < RUNS; run++)
                    millis[way][turn * RUNS + run] = millis(ways[way]);
        for (double[] each : millis) Arrays.sort(each);
    }

    private static void warmUp(double seconds, Runnable[] ways) {
        double[] spent = new double[ways.length];
        while (Arrays.stream(spent).min().orElseThrow() < seconds * 1e3)
            for (int way = 0; way < ways.length; way++)
                if (spent[way] < seconds * 1e3)
                    for (int run = 0; run < RUNS; run++) spent[way] += millis(ways[way]);
    }

    private static double millis(Runnable way) {
        long start = System.nanoTime();
        way.run();
        return (System.nanoTime() - start) / 1e6;
    }

    double median(int way) {
        return millis[way][millis[way].length / 2];
    }

    /** How many times as long as way {@code base} another takes. */
    double ratio(int other, int base) {
        return median(other) / median(base);
    }

    /** The median and both quartiles in milliseconds. */
    String text(int way) {
        int n = millis[way].length;
        return String.format(
                Locale.ROOT,
                "%.2f (%.2f–%.2f)",
                median(way),
                millis[way][n / 4],
                millis[way][3 * n / 4]);
    }
}
