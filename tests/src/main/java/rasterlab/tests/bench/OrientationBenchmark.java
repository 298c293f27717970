package rasterlab.tests.bench;

import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.locationtech.jts.algorithm.CGAlgorithmsDD;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import rasterlab.engine.geometry.Orientation;

/**
 * Times on which side of a line a point lies: exactly here, in 106 bits in JTS (which is what its
 * {@code Orientation.index} asks). {@code near} points are within two steps of their doubles from
 * the line.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
public class OrientationBenchmark {
    static final List<Goal> GOALS = List.of(goal("anywhere"), goal("near"));

    private static final int POINTS = 1 << 12;

    @Param({"anywhere", "near"})
    public String points;

    private final double[] xy = new double[6 * POINTS];

    private static Goal goal(String points) {
        return new Goal(
                "orientation, points " + points,
                OrientationBenchmark.class,
                "rasterlab",
                "jts",
                Map.of("points", points),
                1);
    }

    @Setup
    public void prepare() {
        var random = new Random(1997);
        for (int i = 0; i < xy.length; i += 6) {
            for (int k = 0; k < 6; k++) xy[i + k] = random.nextDouble();
            if (points.equals("anywhere")) continue;
            double mu = random.nextDouble();
            xy[i + 4] = near(xy[i] + mu * (xy[i + 2] - xy[i]), random);
            xy[i + 5] = near(xy[i + 1] + mu * (xy[i + 3] - xy[i + 1]), random);
        }
    }

    private static double near(double value, Random random) {
        return value + (random.nextInt(5) - 2) * Math.ulp(value);
    }

    @Benchmark
    @OperationsPerInvocation(POINTS)
    public int rasterlab() {
        int sum = 0;
        for (int i = 0; i < xy.length; i += 6)
            sum += Orientation.of(xy[i], xy[i + 1], xy[i + 2], xy[i + 3], xy[i + 4], xy[i + 5]);
        return sum;
    }

    @Benchmark
    @OperationsPerInvocation(POINTS)
    public int jts() {
        int sum = 0;
        for (int i = 0; i < xy.length; i += 6)
            sum +=
                    CGAlgorithmsDD.orientationIndex(
                            xy[i], xy[i + 1], xy[i + 2], xy[i + 3], xy[i + 4], xy[i + 5]);
        return sum;
    }
}
