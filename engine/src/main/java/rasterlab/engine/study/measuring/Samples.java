package rasterlab.engine.study.measuring;

import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;

/** The times of one load, round by round; none is left out for being unlike the others. */
public final class Samples {
    private double[] nanos = new double[16];
    private int count;

    /** Makes samples of those times, in that order. */
    public static Samples of(List<Double> nanos) {
        var samples = new Samples();
        nanos.forEach(samples::add);
        return samples;
    }

    /**
     * Adds the time of one more round.
     *
     * @param more nanoseconds per item, above 0
     */
    public void add(double more) {
        if (!(more > 0 && Double.isFinite(more)))
            throw new IllegalArgumentException("a time must be above 0 and finite, got " + more);
        if (count == nanos.length) nanos = Arrays.copyOf(nanos, 2 * count);
        nanos[count++] = more;
    }

    public int count() {
        return count;
    }

    public boolean isEmpty() {
        return count == 0;
    }

    /** The median and how far it can be believed. */
    public MedianInterval interval() {
        return MedianInterval.ofMedian(values());
    }

    /**
     * The ratios of these times to others in the same rounds: what slows the machine for a round
     * slows both.
     *
     * @throws IllegalArgumentException if there are more or fewer of the others
     */
    public Samples over(Samples others) {
        if (others.count != count)
            throw new IllegalArgumentException(
                    "ratios need as many times of both, got " + count + " and " + others.count);
        var ratios = new Samples();
        for (int i = 0; i < count; i++) ratios.add(nanos[i] / others.nanos[i]);
        return ratios;
    }

    /** Round by round. */
    public List<Double> all() {
        return DoubleStream.of(values()).boxed().toList();
    }

    private double[] values() {
        return Arrays.copyOf(nanos, count);
    }
}
