package rasterlab.engine.polygon.inside;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.Map;
import java.util.Random;
import java.util.stream.Stream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.PointInPolygon;
import rasterlab.engine.polygon.ExactMembership;
import rasterlab.engine.polygon.NearSides;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.polygon.ShapeAndPoints;
import rasterlab.engine.polygon.StarPolygon;
import rasterlab.engine.study.Method;

class PointInPolygonTest {
    private static final PointInPolygonTopic TOPIC = new PointInPolygonTopic();
    private static final PointInPolygon ROBUST = new RobustRay();
    private static final long SEED = 2001;
    private static final int ROUNDS = Boolean.getBoolean("rasterlab.full") ? 10_000 : 50;
    private static final int NEAR_POINTS = 1_000;

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void robustJudges(boolean inside, Points corners, double x, double y) {
        for (Points way : new Points[] {corners, corners.reversed()})
            assertEquals(inside, contains(ROBUST, way, x, y), way.toString());
    }

    static Stream<Arguments> mistakes() {
        Points diamond = Points.of(0, -4, 4, 0, 0, 4, -4, 0);
        Points step = Points.of(0, 0, 8, 0, 8, 3, 4, 3, 4, 6, 0, 6);
        Points star = Points.of(0, 10, 6, -8, -10, 3, 10, 3, -6, -8);
        Points line = Points.of(0, 0, 6, 3, 2, 1);
        return Stream.of(
                argumentSet("both edges at a corner count", true, diamond, -1, 0),
                argumentSet("corner that is only touched counts once", false, diamond, -6, 4),
                argumentSet("lower corner that is touched counts once", false, diamond, -6, -4),
                argumentSet("horizontal edge counts", false, step, -1, 3),
                argumentSet("horizontal edge hides the next", true, step, 1, 3),
                argumentSet("lower end of an edge is outside", true, step, 0, 0),
                argumentSet("horizontal edge is outside", true, step, 6, 3),
                argumentSet("right edge is outside", true, step, 8, 1),
                argumentSet("line of an edge is the edge", false, step, 9, 3),
                argumentSet("what is covered twice is inside", false, star, 0, 0),
                argumentSet("tip of a star is outside", true, star, 0, 8),
                argumentSet("polygon without area has no points", true, line, 4, 2),
                argumentSet("polygon without area has others", false, line, 4, 2.5));
    }

    @Test
    void noPointWithinTwoUlpsOfAnEdgeIsMisjudged() {
        var random = new Random(SEED);
        for (int round = 0; round < ROUNDS; round++) {
            Points corners = StarPolygon.of(3 + random.nextInt(8), 100, random);
            Points near = NearSides.of(corners, NEAR_POINTS, 2, random);
            var input = new ShapeAndPoints(corners, near);
            var exact = TOPIC.exact(input, NEAR_POINTS);
            var actual = TOPIC.record(ROBUST, input, NEAR_POINTS);
            String first = TOPIC.compare(input, exact, actual).first();
            assertEquals("", first, "seed " + SEED + ", round " + round + ", " + corners);
        }
    }

    /** Everything special at once: crossings, repeated corners, edges on edges, boundary points. */
    @Property(tries = 3_000)
    void robustIsRightOnSmallGrids(@ForAll long seed) {
        var random = new Random(seed);
        int corners = random.nextInt(3, 9);
        Points polygon = Points.of(random.ints(2L * corners, 0, 5).asDoubleStream().toArray());
        var exact = new ExactMembership(polygon);
        for (double y = -0.5; y <= 4.5; y += 0.5)
            for (double x = -0.5; x <= 4.5; x += 0.5)
                assertEquals(
                        exact.contains(x, y),
                        contains(ROBUST, polygon, x, y),
                        polygon + " (" + x + ", " + y + ")");
    }

    @Property(tries = 500)
    void pointsOffTheHeightsOfCornersAreJudgedAlike(@ForAll long seed) {
        var random = new Random(seed);
        Points polygon = StarPolygon.of(random.nextInt(3, 30), 100, random);
        double x = 100 * random.nextGaussian();
        double y = 100 * random.nextGaussian();
        boolean inside = contains(ROBUST, polygon, x, y);
        for (Method<PointInPolygon> method : TOPIC.methods())
            assertEquals(
                    inside,
                    contains(method.implementation(), polygon, x, y),
                    method.name() + " " + polygon + " (" + x + ", " + y + ")");
    }

    /** The course: of a corner the ray passes through, the upper end of each edge counts. */
    @Test
    void upperEndCountsAndLowerDoesNot() {
        Points diamond = Points.of(0, -4, 4, 0, 0, 4, -4, 0);
        assertTrue(contains(new RayCrossing(), diamond, -1, 0));
        assertFalse(contains(new RayNaive(), diamond, -1, 0));
        assertEquals(2, count(new RayCrossing(), diamond, -6, 4), "both edges at the upper corner");
        assertEquals(0, count(new RayCrossing(), diamond, -6, -4), "none at the lower corner");
    }

    private static int count(SteppedPolygonTest method, Points polygon, double x, double y) {
        EdgeWalk walk = method.walk(polygon.xs(), polygon.ys(), x, y);
        while (walk.advance())
            ;
        return walk.count();
    }

    @Test
    void operationsAreCountedAsTheWalkGoes() {
        var input = new ShapeAndPoints(Points.of(0, -4, 4, 0, 0, 4, -4, 0), Points.of(-1, 0.5));
        assertEquals(
                Map.of("edges", 4L, "crossings", 1L), TOPIC.operations(new RayCrossing(), input));
    }

    @Test
    void boundaryEndsTheRobustWalk() {
        var walk = new RobustRay().walk(of(0, 4, 4, 0), of(0, 0, 4, 4), 2, 0);
        assertTrue(walk.advance());
        assertFalse(walk.advance());
        assertTrue(walk.inside());
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("badInput")
    void everyMethodRefuses(double[] polygonX, double[] polygonY, double x, String message) {
        for (Method<PointInPolygon> method : TOPIC.methods()) {
            var refusal =
                    assertThrows(
                            IllegalArgumentException.class,
                            () -> method.implementation().contains(polygonX, polygonY, x, 0));
            assertEquals(message, refusal.getMessage(), method.name());
        }
    }

    static Stream<Arguments> badInput() {
        double nan = Double.NaN;
        double inf = Double.NEGATIVE_INFINITY;
        return Stream.of(
                argumentSet(
                        "no corner has an inside",
                        of(),
                        of(),
                        0,
                        "at least 3 corners are needed, got 0"),
                argumentSet(
                        "one corner has an inside",
                        of(1),
                        of(1),
                        0,
                        "at least 3 corners are needed, got 1"),
                argumentSet(
                        "corner that is no number",
                        of(0, nan, 1),
                        of(0, 1, 1),
                        0,
                        "corner 1 must be finite, got (NaN, 1.0)"),
                argumentSet(
                        "point that is no number",
                        of(0, 1, 1),
                        of(0, 1, 0),
                        inf,
                        "point coordinate 0 must be finite, got -Infinity"),
                argumentSet(
                        "missing coordinate",
                        of(0, 1, 1),
                        of(0, 1),
                        0,
                        "corners have 3 x but 2 y; give as many"));
    }

    @Test
    void aMillionCornersAreJudged() {
        Points polygon = StarPolygon.of(1_000_000, 100, new Random(SEED));
        assertTrue(contains(ROBUST, polygon, 0, 0));
        assertFalse(contains(ROBUST, polygon, 101, 0));
    }

    private static boolean contains(PointInPolygon method, Points p, double x, double y) {
        return method.contains(p.xs(), p.ys(), x, y);
    }

    private static double[] of(double... values) {
        return values;
    }
}
