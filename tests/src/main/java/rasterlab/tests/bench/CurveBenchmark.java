package rasterlab.tests.bench;

import java.awt.geom.CubicCurve2D;
import java.awt.geom.FlatteningPathIterator;
import java.awt.geom.PathIterator;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import rasterlab.contract.Curve;
import rasterlab.engine.spline.curve.AdaptiveCurve;
import rasterlab.engine.spline.curve.UniformCurve;

/** Random cubic Bézier curves to polylines 0.25 pixels off at most, whose corners are added up. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
public class CurveBenchmark {
    static final List<Goal> GOALS =
            List.of(
                    goal("adaptive", 60, 1.6),
                    goal("adaptive", 500, 1.6),
                    goal("uniform", 60, 5),
                    goal("uniform", 500, 12));

    private static final double FLATNESS = 0.25;
    private static final int CURVES = 256;

    /** Control points lie in a square of this size. */
    @Param({"60", "500"})
    public int pixels;

    private final Curve[] curves = new Curve[CURVES];
    private final CubicCurve2D[] peers = new CubicCurve2D[CURVES];
    private final AdaptiveCurve adaptive = new AdaptiveCurve();
    private final UniformCurve uniform = new UniformCurve();
    private double sum;

    private static Goal goal(String ours, int pixels, double ratio) {
        return new Goal(
                "Bézier curves of " + pixels + " px, " + ours,
                CurveBenchmark.class,
                ours,
                "flatteningPathIterator",
                Map.of("pixels", String.valueOf(pixels)),
                ratio);
    }

    @Setup
    public void prepare() {
        var random = new Random(1959);
        for (int i = 0; i < CURVES; i++) {
            double[] x = random.doubles(4, 0, pixels).toArray();
            double[] y = random.doubles(4, 0, pixels).toArray();
            curves[i] = new Curve(Curve.Kind.BEZIER, x, y);
            peers[i] = new CubicCurve2D.Double(x[0], y[0], x[1], y[1], x[2], y[2], x[3], y[3]);
        }
    }

    @Benchmark
    @OperationsPerInvocation(CURVES)
    public double adaptive() {
        for (Curve curve : curves) adaptive.flatten(curve, FLATNESS, (x, y) -> sum += x + y);
        return sum;
    }

    @Benchmark
    @OperationsPerInvocation(CURVES)
    public double uniform() {
        for (Curve curve : curves) uniform.flatten(curve, FLATNESS, (x, y) -> sum += x + y);
        return sum;
    }

    @Benchmark
    @OperationsPerInvocation(CURVES)
    public double flatteningPathIterator() {
        var corner = new double[6];
        for (CubicCurve2D peer : peers) {
            PathIterator path = new FlatteningPathIterator(peer.getPathIterator(null), FLATNESS);
            for (; !path.isDone(); path.next()) {
                path.currentSegment(corner);
                sum += corner[0] + corner[1];
            }
        }
        return sum;
    }
}
