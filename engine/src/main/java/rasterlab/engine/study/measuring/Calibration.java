package rasterlab.engine.study.measuring;

import java.time.Duration;

/**
 * A fixed load: it does the same each time, so that what its times differ by is the machine's
 * doing. It walks through an array that fits the first cache and mixes its numbers, as the methods
 * do with theirs.
 */
public final class Calibration {
    private static final int STEPS = 2_048;

    /** The numbers, mixed by a xorshift generator: G. Marsaglia, Xorshift RNGs, JSS 8(14), 2003. */
    private final int[] numbers = new int[STEPS];

    private int mixed = 1;

    /** Nanoseconds per step, over a round of at least that time. */
    public double sample(Duration round) {
        long start = System.nanoTime();
        long steps = 0;
        long elapsed;
        do {
            pass();
            steps += STEPS;
            elapsed = System.nanoTime() - start;
        } while (elapsed < round.toNanos());
        return Math.max(1, elapsed) / (double) steps;
    }

    private void pass() {
        int x = mixed;
        for (int i = 0; i < STEPS; i++) {
            x ^= x << 13;
            x ^= x >>> 17;
            x ^= x << 5;
            numbers[i] += x;
            x += numbers[x & STEPS - 1] | 1;
            if (x == 0) x = 1;
        }
        mixed = x;
    }
}
