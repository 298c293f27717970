package rasterlab.engine.spline.curve;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import rasterlab.contract.Curve;
import rasterlab.contract.CurveTracer;
import rasterlab.engine.spline.exact.CurveTask;
import rasterlab.engine.spline.exact.Polyline;
import rasterlab.engine.study.Deviation;

/** Holds the flatness where estimates fail. */
class FewestCurveTest {
    private static final double FLATNESS = 0.25;
    private static final int ADVERSARIAL = 240;
    private static final long SEED = 33;

    @Test
    void flatnessHoldsAtCuspsLoopsTurnsAndCoincidentPoints() {
        var random = new Random(SEED);
        for (int i = 0; i < ADVERSARIAL; i++) {
            Curve curve = adversarial(random, i % 8);
            for (CurveTracer method : List.of(new FewestCurve(), new AdaptiveCurve()))
                requireFlat(method, curve);
        }
    }

    private static void requireFlat(CurveTracer method, Curve curve) {
        var topic = new CurveTopic();
        var task = CurveTask.flat(curve, FLATNESS);
        Polyline exact = topic.exact(task, Integer.MAX_VALUE);
        Polyline actual = topic.record(method, task, Integer.MAX_VALUE);
        Deviation deviation = topic.compare(task, exact, actual);
        assertTrue(
                topic.correct(deviation),
                () ->
                        deviation.first()
                                + " "
                                + Arrays.toString(curve.x())
                                + Arrays.toString(curve.y()));
    }

    private static Curve adversarial(Random random, int kind) {
        double box = new double[] {5, 20, 200, 1000}[random.nextInt(4)];
        double[] x = random.doubles(4, 0, box).toArray();
        double[] y = random.doubles(4, 0, box).toArray();
        switch (kind) {
            case 0 -> Arrays.setAll(y, i -> 2 * x[i]);
            case 1 -> same(x, y, 0, 3);
            case 2 -> same(x, y, 0, 1);
            case 3 -> same(x, y, 1, 2);
            case 4 -> {
                System.arraycopy(new double[] {0, box, random.nextInt(3) * 1e-6, box}, 0, x, 0, 4);
                System.arraycopy(new double[] {0, box, box, 0}, 0, y, 0, 4);
            }
            case 5 -> {
                for (int i = 0; i < 4; i++) x[i] = Math.rint(x[i] / 5) * 5;
                for (int i = 0; i < 4; i++) y[i] = Math.rint(y[i] / 5) * 5;
            }
            case 6 -> {
                same(x, y, 0, 3);
                same(x, y, 1, 2);
            }
            default -> {}
        }
        return new Curve(Curve.Kind.BEZIER, x, y);
    }

    private static void same(double[] x, double[] y, int one, int other) {
        x[other] = x[one];
        y[other] = y[one];
    }
}
