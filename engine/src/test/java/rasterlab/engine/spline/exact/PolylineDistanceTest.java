package rasterlab.engine.spline.exact;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PolylineDistanceTest {
    private static final double ALLOWED = 0.05;

    /** Some jump back and forth, so that the nearest segment is not the next one. */
    @ParameterizedTest(name = "a point far off is measured to a segment that is not nearest: {0}")
    @ValueSource(doubles = {0.2, 1, 5, 40})
    void largestDistanceIsThatOverAllSegments(double jump) {
        for (int seed = 0; seed < 50; seed++) {
            var random = new Random(seed);
            Polyline to = wandering(random, jump);
            Polyline from = wandering(random, jump);
            var distance = new PolylineDistance(to, ALLOWED);
            double largest = 0;
            for (int i = 0; i < from.size(); i++) {
                largest = Math.max(largest, leastDistance(from.x(i), from.y(i), to));
                double soFar = distance.add(from.x(i), from.y(i));
                if (largest > ALLOWED) assertEquals(largest, soFar, 1e-9, "seed " + seed);
            }
        }
    }

    @Test
    void onePointIsMeasuredTo() {
        var to = new Polyline(1);
        to.point(3, 4);
        assertEquals(5, new PolylineDistance(to, ALLOWED).add(0, 0));
    }

    @Test
    void segmentsThatAreNoNumbersLeaveTheOthers() {
        var to = new Polyline(80);
        for (int i = 0; i < 60; i++) to.point(i >= 12 && i < 24 ? Double.NaN : i, 0);
        assertEquals(2, new PolylineDistance(to, ALLOWED).add(30, 2));
    }

    private static Polyline wandering(Random random, double jump) {
        var line = new Polyline(80);
        for (int i = 0; i < 80; i++)
            line.point(i + jump * random.nextGaussian(), jump * random.nextGaussian());
        return line;
    }

    private static double leastDistance(double x, double y, Polyline to) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i + 1 < to.size(); i++)
            least =
                    Math.min(
                            least,
                            java.awt.geom.Line2D.ptSegDist(
                                    to.x(i), to.y(i), to.x(i + 1), to.y(i + 1), x, y));
        return least;
    }
}
