package rasterlab.tests.bench;

import java.awt.geom.Path2D;
import java.util.Arrays;
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

/**
 * Several triangles and many points of the surroundings of each, about a third of them inside, each
 * judged and the answer kept. There are more points than a processor can learn the answers to.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
public class PointInTriangleBenchmark {
    static final List<Goal> GOALS =
            List.of(
                    new Goal(
                            "points in a triangle",
                            PointInTriangleBenchmark.class,
                            "robust",
                            "path2d",
                            Map.of(),
                            12));

    private static final int TRIANGLES = 16;
    private static final int POINTS = 1 << 12;
    private static final double SIZE = 100;

    private final double[][] corners = new double[TRIANGLES][6];
    private final double[][] x = new double[TRIANGLES][POINTS];
    private final double[][] y = new double[TRIANGLES][POINTS];
    private final boolean[][] inside = new boolean[TRIANGLES][POINTS];
    private final RobustTriangle robust = new RobustTriangle();
    private final Path2D[] paths = new Path2D[TRIANGLES];

    /**
     * Places triangles of some size and their points.
     *
     * @throws AssertionError if two ways judge a point differently
     */
    @Setup
    public void prepare() {
        var random = new Random(2005);
        for (int t = 0; t < TRIANGLES; t++) {
            double middle = SIZE / 2;
            for (int k = 0; k < 3; k++) {
                double angle = 2 * Math.PI * (k + 0.5 * random.nextDouble()) / 3;
                corners[t][2 * k] = middle + middle * StrictMath.cos(angle);
                corners[t][2 * k + 1] = middle + middle * StrictMath.sin(angle);
            }
            for (int i = 0; i < POINTS; i++) {
                x[t][i] = SIZE * random.nextDouble();
                y[t][i] = SIZE * random.nextDouble();
            }
            double[] c = corners[t];
            paths[t] = path(c);
        }
        String expected = Arrays.deepToString(path2d());
        if (!Arrays.deepToString(robust()).equals(expected))
            throw new AssertionError("robust and path2d judge differently");
    }

    private static Path2D path(double[] corners) {
        var path = new Path2D.Double();
        path.moveTo(corners[0], corners[1]);
        path.lineTo(corners[2], corners[3]);
        path.lineTo(corners[4], corners[5]);
        path.closePath();
        return path;
    }

    @Benchmark
    @OperationsPerInvocation(TRIANGLES * POINTS)
    public boolean[][] robust() {
        for (int t = 0; t < TRIANGLES; t++) {
            double[] c = corners[t];
            for (int i = 0; i < POINTS; i++)
                inside[t][i] =
                        robust.contains(c[0], c[1], c[2], c[3], c[4], c[5], x[t][i], y[t][i]);
        }
        return inside;
    }

    @Benchmark
    @OperationsPerInvocation(TRIANGLES * POINTS)
    public boolean[][] path2d() {
        for (int t = 0; t < TRIANGLES; t++)
            for (int i = 0; i < POINTS; i++) inside[t][i] = paths[t].contains(x[t][i], y[t][i]);
        return inside;
    }
}
