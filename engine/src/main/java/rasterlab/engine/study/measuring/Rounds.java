package rasterlab.engine.study.measuring;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.function.LongSupplier;
import java.util.stream.IntStream;

/**
 * Loads that are measured in turns: whoever runs them asks for each round's order and hands in the
 * times, until another round would tell no more.
 *
 * <p>Turns let what slows the machine for a while slow all loads; their order is drawn anew for
 * each round, so that nothing that comes back in step with the rounds meets the same load each
 * time. Between the loads a fixed one is measured too, and its {@link #noise} is the machine's.
 */
public final class Rounds {
    private final RoundPlan plan;
    private final LongSupplier clock;
    private final Random random;
    private final long start;
    private final List<Samples> loads = new ArrayList<>();
    private final Set<Integer> lost = new HashSet<>();
    private final Samples fixed = new Samples();
    private int begun;

    /**
     * @param count of the loads, numbered from 0
     * @param clock tells nanoseconds, as {@link System#nanoTime} does
     */
    public Rounds(int count, RoundPlan plan, LongSupplier clock) {
        this.plan = plan;
        this.clock = clock;
        random = new Random(plan.seed());
        start = clock.getAsLong();
        for (int i = 0; i < count; i++) loads.add(new Samples());
    }

    /** Whether another round is worth its time. */
    public boolean more() {
        if (lost.size() == loads.size()) return false;
        int asked = Math.min(plan.rounds(), RoundPlan.LEAST);
        if (begun < asked) return true;
        if (clock.getAsLong() - start >= plan.budget().toNanos())
            return plan.budget().isZero() && begun < plan.rounds();
        return begun < plan.rounds() || begun < plan.most() && !isSettled();
    }

    /** Begins a round: the loads that can be run, in the order of their turns. */
    public List<Integer> order() {
        begun++;
        var order = new ArrayList<Integer>();
        IntStream.range(0, loads.size()).filter(load -> !lost.contains(load)).forEach(order::add);
        Collections.shuffle(order, random);
        return order;
    }

    /** Takes the time per item of a load in this round. */
    public void add(int load, double nanos) {
        samples(load).add(nanos);
    }

    /** Leaves a load out from now on: it can be run no longer. */
    public void lose(int load) {
        lost.add(load);
    }

    /** Takes the time per step of the fixed load in this round. */
    public void addFixed(double nanos) {
        fixed.add(nanos);
    }

    public Samples samples(int load) {
        return loads.get(load);
    }

    /** The fixed load, round by round. */
    public Samples fixed() {
        return fixed;
    }

    /** How many times the fixed load's median may be off; 1 where there is no such load. */
    public double noise() {
        return noise(fixed);
    }

    /** How many times the median of a fixed load with those times may be off. */
    public static double noise(Samples fixed) {
        return fixed.isEmpty() ? 1 : fixed.interval().factor();
    }

    /** Whether each pair of loads is told apart, or is alike. */
    private boolean isSettled() {
        double noise = noise();
        List<Samples> measured =
                IntStream.range(0, loads.size())
                        .filter(load -> !lost.contains(load) && !samples(load).isEmpty())
                        .mapToObj(this::samples)
                        .toList();
        for (int i = 0; i < measured.size(); i++)
            for (int j = 0; j < i; j++)
                if (!PaceComparison.of(measured.get(i), measured.get(j), noise).order().isSettled())
                    return false;
        return true;
    }
}
