package rasterlab.engine.spline.curve;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import rasterlab.contract.Curve;
import rasterlab.contract.Curve.Kind;
import rasterlab.contract.CurveTracer;
import rasterlab.engine.spline.exact.CurveTask;
import rasterlab.engine.spline.exact.Polyline;
import rasterlab.engine.study.Deviation;

/**
 * Many random cubics, among them such with cusps, loops and control points on one line; a million
 * where {@code rasterlab.full} is set.
 */
class CurveFlatnessTest {
    private static final CurveTopic TOPIC = new CurveTopic();
    private static final int CURVES = Boolean.getBoolean("rasterlab.full") ? 1_000_000 : 2_000;
    private static final long SEED = 1984;

    @Test
    void noCurveIsFartherFromItsPolylineThanAsked() {
        var random = new Random(SEED);
        double worst = 0;
        for (int i = 0; i < CURVES; i++) {
            CurveTask task = task(random);
            Polyline exact = TOPIC.exact(task, 20_000);
            for (String name : List.of("uniform", "adaptive")) {
                CurveTracer method = TOPIC.method(name).implementation();
                Deviation deviation =
                        TOPIC.compare(task, exact, TOPIC.record(method, task, 20_000));
                String where = name + " " + deviation + ", seed " + SEED + ", curve " + i;
                assertTrue(TOPIC.correct(deviation), where);
                worst = Math.max(worst, deviation.worst());
            }
        }
        assertTrue(worst > 0.5, "flatter than asked by far: " + worst);
        if (Boolean.getBoolean("rasterlab.full"))
            System.out.println(CURVES + " curves, worst " + worst + " times the flatness");
    }

    /** Makes any three points those of (0, 0), (1, 1), (0, 1), (1, 0) in some slanted frame. */
    private static double cuspEnd(double[] p) {
        return p[0] + p[1] - p[2];
    }

    @Test
    void curvesWithCuspsStopAtTheirMiddle() {
        double[] p = {10, 310, 40, 0};
        p[3] = cuspEnd(p);
        double fourThirds = (p[1] - p[0]) + 2 * (p[2] - p[1]) + (p[3] - p[2]);
        assertEquals(0, fourThirds, "speed at t = 1/2, times 4/3");
    }

    private static CurveTask task(Random random) {
        double size = Math.scalb(1.0, random.nextInt(2, 10));
        double[] x = random.doubles(4, 0, size).toArray();
        double[] y = random.doubles(4, 0, size).toArray();
        int shape = random.nextInt(8);
        if (shape == 0) for (int i = 0; i < 4; i++) y[i] = 0.5 * x[i];
        if (shape == 1) {
            x[3] = x[0];
            y[3] = y[0];
        }
        if (shape == 2) {
            x[1] = x[0];
            y[1] = y[0];
        }
        if (shape == 3) {
            x[3] = cuspEnd(x);
            y[3] = cuspEnd(y);
        }
        return CurveTask.flat(new Curve(Kind.BEZIER, x, y), Math.scalb(1.0, random.nextInt(-4, 2)));
    }
}
