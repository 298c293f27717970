package rasterlab.tests.bench.pipeline;

import java.util.Arrays;
import java.util.Locale;

/**
 * Times of several ways to do one thing, taken in turn, so that what slows the machine for a while
 * slows them all.
 */
final class Turns {
    /** For each way: by then, on a quiet machine, the compiler has done with what is run most. */
    private static final double WARM_UP_SECONDS = 3;

    private static final int WARM_UP_ROUNDS = 5;

    private final Runnable[] ways;
    private final double[][] millis;

    /**
     * @param rounds how often each is timed, after some rounds to warm up
     */
    Turns(int rounds, Runnable... ways) {
        this.ways = ways.clone();
        millis = new double[ways.length][rounds];
        for (Runnable way : ways) warmUp(way);
        for (int round = 0; round < rounds; round++)
            for (int way = 0; way < ways.length; way++) millis[way][round] = millis(ways[way]);
        for (double[] each : millis) Arrays.sort(each);
    }

    private static void warmUp(Runnable way) {
        double spent = 0;
        for (int round = 0; round < WARM_UP_ROUNDS || spent < WARM_UP_SECONDS * 1e3; round++)
            spent += millis(way);
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
