package rasterlab.engine.clip.polygon;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import rasterlab.engine.clip.exact.ProperInput;
import rasterlab.engine.study.Deviation;

/** Polygons for tests, and what the methods must make of each. */
final class PolygonCases {
    static final PolygonClipTopic TOPIC = new PolygonClipTopic();

    private PolygonCases() {}

    static List<double[]> clip(String method, double[] window, double... subject) {
        var input = new PolygonInWindow(window, subject);
        return TOPIC.record(TOPIC.method(method).implementation(), input, 1_000_000);
    }

    /** Fails unless the pieces of both methods are as exact as they are known to be. */
    static void assertRight(double[] window, double... subject) {
        var input = new PolygonInWindow(window, subject);
        List<double[]> exact = TOPIC.exact(input, 1_000_000);
        String where = " of " + Arrays.toString(subject) + " in " + Arrays.toString(window);
        List<double[]> pieces = clip("weiler-atherton", window, subject);
        Deviation separate = TOPIC.compare(input, exact, pieces);
        assertTrue(TOPIC.correct(separate), () -> "weiler-atherton: " + separate + where);
        int down = PolygonArea.exponent(window, 0, 1);
        for (double[] piece : pieces)
            assertTrue(PolygonArea.of(PolygonArea.scaled(piece, -down, -down)) >= 0, where);
        Deviation bridged =
                TOPIC.compare(input, exact, clip("sutherland-hodgman", window, subject));
        assertTrue(
                bridged.worst() <= PolygonClipTopic.RIGHT_SHARE,
                () -> "sutherland-hodgman: " + bridged + where);
    }

    /** Whether the subject can be clipped at all; both ways to find out must agree. */
    static boolean proper(double[] window, double[] subject) {
        boolean proper = ProperInput.is(window, subject);
        boolean accepted;
        try {
            ConvexWindow.of(window);
            Ring.simple(subject);
            accepted = true;
        } catch (IllegalArgumentException refusal) {
            accepted = false;
        }
        assertEquals(
                proper,
                accepted,
                () -> Arrays.toString(subject) + " in " + Arrays.toString(window));
        return proper;
    }

    /** A few corners on a small grid: most meet the window's sides and corners. */
    static double[] onGrid(Random random, int corners) {
        return random.ints(2L * corners, 0, 7).asDoubleStream().toArray();
    }

    /** Convex: points on an ellipse in order. */
    static double[] convexWindow(Random random) {
        var angles = new ArrayList<Double>();
        int corners = 3 + random.nextInt(6);
        for (int i = 0; i < corners; i++)
            angles.add(2 * Math.PI * (i + 0.8 * random.nextDouble()) / corners);
        double[] window = new double[2 * corners];
        for (int i = 0; i < corners; i++) {
            window[2 * i] = 50 + 50 * Math.cos(angles.get(i));
            window[2 * i + 1] = 50 + 30 * Math.sin(angles.get(i));
        }
        return window;
    }
}
