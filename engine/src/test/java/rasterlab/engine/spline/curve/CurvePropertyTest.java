package rasterlab.engine.spline.curve;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import rasterlab.contract.Curve;
import rasterlab.contract.Curve.Kind;
import rasterlab.contract.CurveTracer;
import rasterlab.engine.spline.exact.CurveTask;
import rasterlab.engine.spline.exact.Polyline;
import rasterlab.engine.study.Deviation;

class CurvePropertyTest {
    private static final CurveTopic TOPIC = new CurveTopic();
    private static final List<String> RIGHT =
            List.of(
                    "matrix",
                    "horner",
                    "de-casteljau",
                    "forward-differences",
                    "uniform",
                    "adaptive");

    @Property(tries = 100)
    void weightsOfPointsAddUpToOne(
            @ForAll @IntRange(min = 1, max = 11) int points,
            @ForAll @DoubleRange(min = 0, max = 1) double t) {
        var same = new double[points];
        Arrays.fill(same, 1000);
        for (CurveTracer method : List.of(new MatrixCurve(), new DeCasteljauCurve()))
            assertEquals(1000, point(method, new Curve(Kind.BEZIER, same, same), t).x(0), 1e-6);
    }

    @Property(tries = 100)
    void bezierCurvesStayInTheHullOfTheirPoints(
            @ForAll @IntRange(min = 1, max = 101) int points,
            @ForAll @DoubleRange(min = 0, max = 1) double t,
            @ForAll long seed) {
        Curve curve = CurveWorkloads.random(points, 500, new Random(seed));
        Polyline at = point(new DeCasteljauCurve(), curve, t);
        for (int k = 0; k < 24; k++) {
            double towardsX = Math.cos(k * Math.PI / 12);
            double towardsY = Math.sin(k * Math.PI / 12);
            double farthest = Double.NEGATIVE_INFINITY;
            for (int i = 0; i < points; i++)
                farthest = Math.max(farthest, towardsX * curve.x()[i] + towardsY * curve.y()[i]);
            assertTrue(towardsX * at.x(0) + towardsY * at.y(0) <= farthest + 1e-9, "side " + k);
        }
    }

    @Property(tries = 100)
    void allMethodsFindTheSamePoints(
            @ForAll Kind kind, @ForAll @IntRange(min = 4, max = 9) int points, @ForAll long seed) {
        CurveTask task = CurveTask.at(curve(kind, points, seed), 0, 0.25, 0.5, 0.75, 1);
        Polyline exact = TOPIC.exact(task, 9);
        for (String name : RIGHT) assertCorrect(name, task, exact);
    }

    @Property(tries = 100)
    void allMethodsStayWithinTheFlatness(
            @ForAll Kind kind,
            @ForAll @IntRange(min = 4, max = 9) int points,
            @ForAll @IntRange(min = -5, max = 5) int power,
            @ForAll long seed) {
        CurveTask task = CurveTask.flat(curve(kind, points, seed), Math.scalb(1.0, power));
        Polyline exact = TOPIC.exact(task, 20_000);
        for (String name : RIGHT) assertCorrect(name, task, exact);
    }

    @Property(tries = 30)
    void curvesOfHighDegreeStayWithinTheFlatness(
            @ForAll @IntRange(min = 10, max = 101) int points, @ForAll long seed) {
        Curve curve = CurveWorkloads.random(points, 500, new Random(seed));
        CurveTask task = CurveTask.flat(curve, 1);
        Polyline exact = TOPIC.exact(task, 20_000);
        for (String name : List.of("de-casteljau", "uniform", "adaptive"))
            assertCorrect(name, task, exact);
    }

    @Property(tries = 100)
    void walksStopAtThePointsThatAreSent(
            @ForAll Kind kind, @ForAll @IntRange(min = 4, max = 9) int points, @ForAll long seed) {
        Curve curve = curve(kind, points, seed);
        for (var method : TOPIC.methods()) {
            if (method.faulty() && kind != Kind.HERMITE) continue;
            var sent = new Polyline(100_000);
            method.implementation().flatten(curve, 0.25, sent);
            CurveWalk walk = ((SteppedCurve) method.implementation()).walk(curve, 0.25);
            double before = -1;
            for (int i = 0; i < sent.size(); i++) {
                assertTrue(walk.advance(), method.name());
                assertEquals(sent.x(i), walk.x(), method.name());
                assertEquals(sent.y(i), walk.y(), method.name());
                assertTrue(walk.t() > before, method.name() + " at " + i);
                before = walk.t();
            }
            assertEquals(1, before, 1e-12, method.name());
            assertTrue(!walk.advance() && !walk.advance(), method.name());
        }
    }

    private static void assertCorrect(String name, CurveTask task, Polyline exact) {
        CurveTracer method = TOPIC.method(name).implementation();
        Deviation deviation = TOPIC.compare(task, exact, TOPIC.record(method, task, 1_000_000));
        assertTrue(TOPIC.correct(deviation), name + " " + task + " " + deviation);
    }

    private static Polyline point(CurveTracer method, Curve curve, double t) {
        var points = new Polyline(1);
        method.at(curve, new double[] {t}, points);
        return points;
    }

    private static Curve curve(Kind kind, int points, long seed) {
        Curve bezier =
                CurveWorkloads.random(kind == Kind.HERMITE ? 4 : points, 500, new Random(seed));
        return new Curve(kind, bezier.x(), bezier.y());
    }
}
