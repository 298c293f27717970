package rasterlab.engine.plan;

import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.function.BooleanSupplier;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.transform.SphericalView;

/**
 * A plan held against the full pipeline: both are drawn in turns, and timed.
 *
 * @param plan that was drawn
 * @param full its picture
 * @param least its picture
 * @param error how far they are apart
 * @param fullMilliseconds median wall time of the full picture
 * @param milliseconds median wall time of the least one
 * @param fullProcessor least processor time of the full picture, all threads together, milliseconds
 * @param processor the same of the least one
 * @param steppedBack how often a plan failed before this one, and was made with half the tolerance
 */
public record PlanTrial(
        Plan plan,
        Raster full,
        Raster least,
        ToleratedDifference error,
        double fullMilliseconds,
        double milliseconds,
        double fullProcessor,
        double processor,
        int steppedBack) {
    private static final int TRIES = 4;

    /**
     * Makes a plan, draws it, and where measuring finds it outside the tolerance, which no proof
     * should allow, makes a stricter one; the last one leaves nothing out.
     *
     * @param rounds of drawing both, at least 1
     */
    public static PlanTrial of(
            Planner planner,
            RenderRequest asked,
            Tolerance tolerance,
            int rounds,
            BooleanSupplier cancelled) {
        Tolerance strict = tolerance;
        for (int tried = 0; ; tried++) {
            Plan plan =
                    tried < TRIES
                            ? planner.plan(asked, strict)
                            : planner.nothingLeftOut(asked, tolerance);
            PlanTrial trial = of(plan, asked.camera(), tolerance, rounds, tried, cancelled);
            if (trial.error.within(tolerance) || tried == TRIES) return trial;
            strict = new Tolerance(strict.pixels() / 2, strict.levels() / 2, strict.share());
        }
    }

    /**
     * Holds a plan against the full pipeline from a camera, whatever comes of it.
     *
     * @param camera that the plan holds for
     * @param rounds of drawing both, at least 1
     */
    public static PlanTrial held(
            Plan plan, SphericalView camera, int rounds, BooleanSupplier cancelled) {
        return of(plan, camera, plan.tolerance(), rounds, 0, cancelled);
    }

    private static PlanTrial of(
            Plan plan,
            SphericalView camera,
            Tolerance tolerance,
            int rounds,
            int tried,
            BooleanSupplier cancelled) {
        RenderRequest whole = plan.full().from(camera);
        RenderRequest little = plan.from(camera);
        var full = new Raster(whole.width(), whole.height());
        var least = new Raster(full.width(), full.height());
        var times = new double[4][rounds];
        try (var renderer = new Renderer();
                var alone = Renderer.onOneThread()) {
            renderer.render(whole, full, cancelled);
            renderer.render(little, least, cancelled);
            for (int k = 0; k < rounds; k++) {
                times[0][k] = wall(renderer, whole, full, cancelled);
                times[1][k] = wall(renderer, little, least, cancelled);
                times[2][k] = processor(alone, whole, full, cancelled);
                times[3][k] = processor(alone, little, least, cancelled);
            }
        }
        return new PlanTrial(
                plan,
                full,
                least,
                ToleratedDifference.of(full, least, tolerance),
                middle(times[0]),
                middle(times[1]),
                Arrays.stream(times[2]).min().orElseThrow(),
                Arrays.stream(times[3]).min().orElseThrow(),
                tried);
    }

    private static double wall(
            Renderer renderer, RenderRequest request, Raster out, BooleanSupplier cancelled) {
        long start = System.nanoTime();
        renderer.render(request, out, cancelled);
        return (System.nanoTime() - start) / 1e6;
    }

    /**
     * Processor time of a picture, in milliseconds.
     *
     * @param alone works on the caller's thread
     */
    static double processor(
            Renderer alone, RenderRequest request, Raster out, BooleanSupplier cancelled) {
        long before = processorNanos();
        alone.render(request, out, cancelled);
        return (processorNanos() - before) / 1e6;
    }

    /** Processor time of the caller's thread so far. */
    static long processorNanos() {
        return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
    }

    private static double middle(double[] times) {
        double[] sorted = times.clone();
        Arrays.sort(sorted);
        return (sorted[sorted.length / 2] + sorted[(sorted.length - 1) / 2]) / 2;
    }
}
