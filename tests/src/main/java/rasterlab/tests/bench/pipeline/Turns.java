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
final class Turns {
    /** For each way: by then, on a quiet machine, the compiler has done with what is run most. */
    private static final double WARM_UP_SECONDS = 6;

    private static final int RUNS = 8;

    private final double[][] millis;

    /** How many turns make a measurement. */
    static int count(boolean quick) {
        return quick ? 3 : 10;
    }

    /**
     * @param turns how many turns each has, after it has warmed up
     */
    Turns(int turns, Runnable... ways) {
        millis = new double[ways.length][turns * RUNS];
        warmUp(ways);
        for (int turn = 0; turn < turns; turn++)
            for (int way = 0; way < ways.length; way++)
                for (int run = 0; run < RUNS; run++)
                    millis[way][turn * RUNS + run] = millis(ways[way]);
        for (double[] each : millis) Arrays.sort(each);
    }

    private static void warmUp(Runnable[] ways) {
        double[] spent = new double[ways.length];
        while (Arrays.stream(spent).min().orElseThrow() < WARM_UP_SECONDS * 1e3)
            for (int way = 0; way < ways.length; way++)
                if (spent[way] < WARM_UP_SECONDS * 1e3)
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
