package rasterlab.app.spline.curve;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import rasterlab.contract.Curve;
import rasterlab.engine.spline.exact.CurveTask;

/**
 * Which points of a curve are wanted: a polyline flat enough, or points at given t.
 *
 * @param flatness pixels; 0 where points at given t are wanted
 * @param at rising from 0 to 1; empty where a polyline is wanted
 */
public record Sampling(double flatness, List<Double> at) {
    public static final double FINEST = 0.0625;
    public static final double COARSEST = 64;
    public static final int MOST_STEPS = 128;

    public Sampling {
        at = List.copyOf(at);
    }

    public static Sampling flat(double flatness) {
        return new Sampling(flatness, List.of());
    }

    /** Points at t = 0, 1/n, …, 1. */
    public static Sampling equal(int steps) {
        return new Sampling(
                0, IntStream.rangeClosed(0, steps).mapToObj(i -> (double) i / steps).toList());
    }

    public static Sampling of(CurveTask task) {
        List<Double> at = Arrays.stream(task.at()).boxed().toList();
        return new Sampling(task.flatness(), at);
    }

    public boolean isFlat() {
        return at.isEmpty();
    }

    /** Number of steps between the points at given t; 0 for a polyline. */
    public int steps() {
        return Math.max(0, at.size() - 1);
    }

    public CurveTask task(Curve curve) {
        return new CurveTask(curve, at.stream().mapToDouble(t -> t).toArray(), flatness);
    }
}
