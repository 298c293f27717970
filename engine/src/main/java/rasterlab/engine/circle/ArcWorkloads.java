package rasterlab.engine.circle;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.IntFunction;
import rasterlab.engine.study.Workload;

/** Circles and ellipses to measure: of one size each, the same in every run. */
final class ArcWorkloads {
    private static final long SEED = 1977;
    private static final int PIXELS_PER_WORKLOAD = 8_192;
    private static final int FEWEST_CURVES = 4;
    private static final List<Integer> RADII = List.of(4, 16, 64, 256, 1024);

    private ArcWorkloads() {}

    static List<Workload<Circle>> circles() {
        var random = new Random(SEED);
        return workloads(r -> new Circle(random.nextInt(1000), random.nextInt(1000), r));
    }

    /** The larger half-axis is the size; the smaller one is anything from 0 up. */
    static List<Workload<Ellipse>> ellipses() {
        var random = new Random(SEED);
        return workloads(
                r -> {
                    int other = random.nextInt(r + 1);
                    int x = random.nextInt(1000);
                    int y = random.nextInt(1000);
                    return random.nextBoolean()
                            ? new Ellipse(x, y, r, other)
                            : new Ellipse(x, y, other, r);
                });
    }

    private static <I> List<Workload<I>> workloads(IntFunction<I> ofSize) {
        var workloads = new ArrayList<Workload<I>>();
        for (int r : RADII) {
            var inputs = new ArrayList<I>();
            int count = Math.max(FEWEST_CURVES, PIXELS_PER_WORKLOAD / (6 * r));
            for (int i = 0; i < count; i++) inputs.add(ofSize.apply(r));
            workloads.add(new Workload<>("radius-" + r, r, inputs));
        }
        return workloads;
    }
}
