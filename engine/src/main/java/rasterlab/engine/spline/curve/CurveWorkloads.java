package rasterlab.engine.spline.curve;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.Function;
import java.util.stream.IntStream;
import rasterlab.contract.Curve;
import rasterlab.engine.spline.exact.CurveTask;
import rasterlab.engine.study.Workload;

/**
 * Random cubics of a window of 500 pixels: flattened to ever smaller flatness, and followed in ever
 * more equal steps, which shows the drift of forward differences.
 *
 * <p>The size of a flattening is about the number of points it takes.
 */
final class CurveWorkloads {
    private static final long SEED = 1959;
    private static final int CURVES = 16;

    private CurveWorkloads() {}

    static List<Workload<CurveTask>> all() {
        return List.of(
                flat("flat-4-px", 10, 4),
                steps(16),
                flat("flat-1-px", 20, 1),
                flat("flat-quarter-px", 40, 0.25),
                flat("flat-64th-px", 160, 1.0 / 64),
                steps(256),
                flat("flat-1024th-px", 640, 1.0 / 1024),
                steps(4_096),
                steps(16_384));
    }

    private static Workload<CurveTask> flat(String name, int size, double flatness) {
        return workload(name, size, curve -> CurveTask.flat(curve, flatness));
    }

    private static Workload<CurveTask> steps(int steps) {
        double[] at =
                IntStream.rangeClosed(0, steps).mapToDouble(i -> (double) i / steps).toArray();
        return workload("steps-" + steps, steps, curve -> CurveTask.at(curve, at));
    }

    private static Workload<CurveTask> workload(
            String name, int size, Function<Curve, CurveTask> task) {
        var random = new Random(SEED);
        var tasks = new ArrayList<CurveTask>();
        for (int i = 0; i < CURVES; i++) tasks.add(task.apply(random(4, 500, random)));
        return new Workload<>(name, size, tasks);
    }

    /** A Bézier curve with control points in [0, size)². */
    static Curve random(int points, double size, Random random) {
        double[] x = random.doubles(points, 0, size).toArray();
        double[] y = random.doubles(points, 0, size).toArray();
        return new Curve(Curve.Kind.BEZIER, x, y);
    }
}
