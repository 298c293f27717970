package rasterlab.tests.bench.pipeline;

import java.util.Arrays;
import java.util.Locale;

/**
 * Times of several ways to do one thing, taken in turn, so that what slows the machine for a while
 * slows them all.
 */
final class Turns {
    private final Runnable[] ways;
    private final double[][] millis;

    /**
     * @param rounds how often each is timed, after a quarter as many rounds to warm up
     */
    Turns(int rounds, Runnable... ways) {
        this.ways = ways.clone();
        millis = new double[ways.length][rounds];
        for (int round = -Math.max(5, rounds / 4); round < rounds; round++)
            for (int way = 0; way < ways.length; way++) time(way, round);
        for (double[] each : millis) Arrays.sort(each);
    }

    private void time(int way, int round) {
        long start = System.nanoTime();
        ways[way].run();
        if (round >= 0) millis[way][round] = (System.nanoTime() - start) / 1e6;
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
