package rasterlab.engine.spline.plan;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import rasterlab.contract.CurveTracer;
import rasterlab.engine.spline.curve.CurveTopic;
import rasterlab.engine.spline.exact.CurveTask;
import rasterlab.engine.spline.exact.Polyline;
import rasterlab.engine.study.Deviation;

/**
 * The ways to draw curves as polylines within a tolerance, and the cheapest of them.
 *
 * <p>A polyline is made once and drawn as often as the curve is: fewer segments pay where it is
 * drawn often, a method that makes them sooner where it is drawn once.
 *
 * @param ways each within the tolerance, in teaching order
 * @param times that the polylines are drawn, at least 1
 */
public record CurvePlan(List<MethodPolylines> ways, long times) {
    /**
     * One method's polylines.
     *
     * @param method its name in the topic
     * @param segments of all curves
     * @param errorPixels how far they are off, measured
     * @param makingNanos of processor time, by the prices
     * @param drawingNanos of drawing them once
     */
    public record MethodPolylines(
            String method,
            long segments,
            double errorPixels,
            double makingNanos,
            double drawingNanos) {
        /** The cost of making them once and drawing them so often. */
        public double nanos(long times) {
            return makingNanos + times * drawingNanos;
        }
    }

    public CurvePlan {
        ways = List.copyOf(ways);
        if (ways.isEmpty()) throw new IllegalArgumentException("no way is within the tolerance");
        if (times < 1)
            throw new IllegalArgumentException("a curve is drawn at least once, got " + times);
    }

    /**
     * Flattens curves by each method; one that is measured beyond the flatness is left out.
     *
     * @param tasks the curves with the tolerance as their flatness
     * @param exact the topic's exact polyline of each
     * @param limit the most points of a curve
     * @throws IllegalArgumentException if no method can do it
     */
    public static CurvePlan of(
            List<CurveTask> tasks,
            List<Polyline> exact,
            long times,
            int limit,
            CurvePrices prices,
            BooleanSupplier cancelled) {
        var topic = new CurveTopic();
        var ways = new ArrayList<MethodPolylines>();
        for (String method : CurvePrices.METHODS) {
            CurveTracer tracer = topic.method(method).implementation();
            long segments = 0;
            double error = 0;
            boolean right = true;
            for (int i = 0; i < tasks.size() && right; i++) {
                requireUse(cancelled);
                var polyline = new Polyline(limit);
                tracer.flatten(tasks.get(i).curve(), tasks.get(i).flatness(), polyline::point);
                Deviation deviation = topic.compare(tasks.get(i), exact.get(i), polyline);
                segments += polyline.size() - 1;
                error = Math.max(error, deviation.worst() * tasks.get(i).allowed());
                right = topic.correct(deviation);
            }
            if (right)
                ways.add(
                        new MethodPolylines(
                                method,
                                segments,
                                error,
                                prices.flattening(method, tasks.size(), segments),
                                prices.drawing(segments)));
        }
        return new CurvePlan(ways, times);
    }

    private static void requireUse(BooleanSupplier cancelled) {
        if (cancelled.getAsBoolean()) throw new CancellationException("a newer plan is asked for");
    }

    /** The cheapest way for so many times. */
    public MethodPolylines chosen() {
        return ways.stream().min(Comparator.comparingDouble(way -> way.nanos(times))).orElseThrow();
    }

    /** The dearest way for so many times: what a wrong choice would cost. */
    public MethodPolylines dearest() {
        return ways.stream().max(Comparator.comparingDouble(way -> way.nanos(times))).orElseThrow();
    }
}
