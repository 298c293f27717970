package rasterlab.engine.spline.curve;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.geom.CubicCurve2D;
import java.awt.geom.FlatteningPathIterator;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.contract.Curve;
import rasterlab.engine.spline.exact.CurveTask;
import rasterlab.engine.spline.exact.Polyline;
import rasterlab.engine.study.Deviation;

/** Counts the segments of adaptive polylines beside those of Java2D at the same flatness. */
class AdaptiveSegmentsTest {
    private static final double FLATNESS = 0.25;
    private static final int CURVES = 200;
    private static final long SEED = 28;

    @ParameterizedTest(name = "in boxes of {0} pixels")
    @ValueSource(ints = {20, 200, 1000})
    void takesFewerSegmentsThanJava2DAndStaysFlat(int box) {
        var random = new Random(SEED);
        int ours = 0;
        int theirs = 0;
        for (int i = 0; i < CURVES; i++) {
            double[] x = random.doubles(4, 0, box).toArray();
            double[] y = random.doubles(4, 0, box).toArray();
            int mine = segments(new Curve(Curve.Kind.BEZIER, x, y));
            int those = segmentsOfJava2D(x, y);
            assertTrue(mine <= those, () -> "curve " + Arrays.toString(x) + Arrays.toString(y));
            ours += mine;
            theirs += those;
        }
        String counts =
                "seed %d: %.1f segments a curve, Java2D %.1f"
                        .formatted(SEED, ours / (double) CURVES, theirs / (double) CURVES);
        System.out.println(box + " pixels, " + counts);
        assertTrue(ours < theirs, counts);
    }

    private static int segments(Curve curve) {
        var topic = new CurveTopic();
        var task = CurveTask.flat(curve, FLATNESS);
        Polyline exact = topic.exact(task, Integer.MAX_VALUE);
        Polyline actual = topic.record(new AdaptiveCurve(), task, Integer.MAX_VALUE);
        Deviation deviation = topic.compare(task, exact, actual);
        assertTrue(topic.correct(deviation), deviation.first());
        return actual.size() - 1;
    }

    private static int segmentsOfJava2D(double[] x, double[] y) {
        var curve = new CubicCurve2D.Double(x[0], y[0], x[1], y[1], x[2], y[2], x[3], y[3]);
        var path = new FlatteningPathIterator(curve.getPathIterator(null), FLATNESS, 20);
        int points = 0;
        for (; !path.isDone(); path.next()) points++;
        return points - 1;
    }
}
