package rasterlab.tests.bench;

import java.awt.geom.Path2D;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import rasterlab.engine.polygon.triangle.RobustTriangle;
import rasterlab.engine.polygon.triangle.TriangleBatch;

/**
 * One triangle and many points of its surroundings, about two fifths of them inside, each judged
 * and the answer kept. There are more points than a processor can learn the answers to.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
public class PointInTriangleBenchmark {
    static final List<Goal> GOALS =
            List.of(goal("one by one", "robust", 12), goal("in batches", "batch", 90));

    private static final int POINTS = 1 << 16;
    private static final double SIZE = 100;

    private final double[] x = new double[POINTS];
    private final double[] y = new double[POINTS];
    private final boolean[] inside = new boolean[POINTS];
    private final double[] depth = new double[POINTS];
    private final RobustTriangle robust = new RobustTriangle();
    private final TriangleBatch batch = new TriangleBatch(10, 5, 95, 30, 40, 90);
    private final Path2D path = new Path2D.Double();

    private static Goal goal(String how, String ours, double ratio) {
        return new Goal(
                "points in a triangle, " + how,
                PointInTriangleBenchmark.class,
                ours,
                "path2d",
                Map.of(),
                ratio);
    }

    @Setup
    public void prepare() {
        var random = new Random(2005);
        for (int i = 0; i < POINTS; i++) {
            x[i] = SIZE * random.nextDouble();
            y[i] = SIZE * random.nextDouble();
        }
        path.moveTo(10, 5);
        path.lineTo(95, 30);
        path.lineTo(40, 90);
        path.closePath();
    }

    @Benchmark
    @OperationsPerInvocation(POINTS)
    public boolean[] robust() {
        for (int i = 0; i < POINTS; i++)
            inside[i] = robust.contains(10, 5, 95, 30, 40, 90, x[i], y[i]);
        return inside;
    }

    /** The answer is the sign of each number written. */
    @Benchmark
    @OperationsPerInvocation(POINTS)
    public double[] batch() {
        batch.judge(x, y, depth);
        return depth;
    }

    @Benchmark
    @OperationsPerInvocation(POINTS)
    public boolean[] path2d() {
        for (int i = 0; i < POINTS; i++) inside[i] = path.contains(x[i], y[i]);
        return inside;
    }
}
