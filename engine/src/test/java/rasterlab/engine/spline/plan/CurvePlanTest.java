package rasterlab.engine.spline.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.contract.Curve;
import rasterlab.engine.spline.curve.CurveTopic;
import rasterlab.engine.spline.exact.CurveTask;
import rasterlab.engine.spline.exact.Polyline;

class CurvePlanTest {
    private static final int LIMIT = 20_000;

    private static final Curve ARCH =
            new Curve(
                    Curve.Kind.BEZIER,
                    new double[] {100, 250, 500, 700},
                    new double[] {400, 50, 40, 420});

    /** A curve that bends at one end alone, so that equal steps waste segments. */
    private static final Curve BENT =
            new Curve(
                    Curve.Kind.BEZIER,
                    new double[] {0, 10, 20, 1000},
                    new double[] {0, 5, 0, 1000});

    private static CurvePlan plan(List<Curve> curves, double flatness, long times) {
        return plan(curves, flatness, times, () -> false);
    }

    private static CurvePlan plan(
            List<Curve> curves, double flatness, long times, BooleanSupplier cancelled) {
        var topic = new CurveTopic();
        List<CurveTask> tasks = curves.stream().map(c -> CurveTask.flat(c, flatness)).toList();
        List<Polyline> exact = tasks.stream().map(task -> topic.exact(task, LIMIT)).toList();
        return CurvePlan.of(tasks, exact, times, LIMIT, CurvePrices.measured(), cancelled);
    }

    @ParameterizedTest(name = "a curve that is drawn {0} times is not drawn by {1}")
    @CsvSource({"1, uniform, false", "30, adaptive, true", "10000, fewest, true"})
    void methodFollowsFromHowOftenTheCurveIsDrawn(long times, String method, boolean bent) {
        assertEquals(method, plan(List.of(bent ? BENT : ARCH), 0.25, times).chosen().method());
    }

    @Test
    @DisplayName("a way leaves the tolerance, or another is cheaper")
    void chosenWayIsTheCheapestWithinTheTolerance() {
        var random = new Random(32);
        for (int k = 0; k < 60; k++) {
            var curves = new ArrayList<Curve>();
            for (int i = 0; i <= k % 3; i++) curves.add(cubic(random, 20 + 10 * k));
            double flatness = 0.1 * Math.pow(50, random.nextDouble());
            long times = 1 + random.nextInt(300);
            CurvePlan plan = plan(curves, flatness, times);
            assertEquals(3, plan.ways().size());
            for (CurvePlan.MethodPolylines way : plan.ways()) {
                assertTrue(way.errorPixels() <= flatness * (1 + 1e-9), way + " to " + flatness);
                assertTrue(plan.chosen().nanos(times) <= way.nanos(times), way.toString());
                assertTrue(plan.dearest().nanos(times) >= way.nanos(times), way.toString());
            }
        }
    }

    @Test
    @DisplayName("a plan that nobody needs any more goes on")
    void planIsCancelled() {
        assertThrows(CancellationException.class, () -> plan(List.of(BENT), 1, 1, () -> true));
    }

    private static Curve cubic(Random random, double box) {
        double[] x = new double[4];
        double[] y = new double[4];
        for (int i = 0; i < 4; i++) {
            x[i] = box * random.nextDouble();
            y[i] = box * random.nextDouble();
        }
        return new Curve(Curve.Kind.BEZIER, x, y);
    }
}
