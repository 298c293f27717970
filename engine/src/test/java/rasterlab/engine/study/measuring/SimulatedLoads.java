package rasterlab.engine.study.measuring;

import java.util.Random;

/** Loads of known true times on a made-up machine, whose noise is drawn from a seed. */
final class SimulatedLoads {
    private final double[] truth;
    private final Random random;
    private final double busy;

    /**
     * @param busy the share of rounds that something else interrupts
     * @param truth nanoseconds per item of each load
     */
    SimulatedLoads(long seed, double busy, double... truth) {
        this.truth = truth;
        this.busy = busy;
        random = new Random(seed);
    }

    /** Rounds of all of them, with a fixed load beside. */
    Rounds measured(RoundPlan plan) {
        var now = new long[1];
        var rounds = new Rounds(truth.length, plan, () -> now[0]);
        while (rounds.more()) {
            for (int load : rounds.order()) {
                double nanos = noisy(truth[load]);
                rounds.add(load, nanos);
                now[0] += 5_000_000;
            }
            rounds.addFixed(noisy(1));
        }
        return rounds;
    }

    /** A time that is seldom shorter than the true one and now and then many times as long. */
    private double noisy(double nanos) {
        double noise = 1 + 0.01 * Math.abs(random.nextGaussian());
        if (random.nextDouble() < busy) noise *= 1 + 4 * random.nextDouble();
        return nanos * noise;
    }
}
