package rasterlab.engine.polygon.triangle;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.stream.Stream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.PointInTriangle;
import rasterlab.engine.polygon.NearSides;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.polygon.ShapeAndPoints;
import rasterlab.engine.study.Method;

class PointInTriangleTest {
    private static final PointInTriangleTopic TOPIC = new PointInTriangleTopic();
    private static final PointInTriangle ROBUST = new RobustTriangle();
    private static final long SEED = 2005;
    private static final int ROUNDS = Boolean.getBoolean("rasterlab.full") ? 10_000 : 100;
    private static final int NEAR_POINTS = 1_000;

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void robustJudges(boolean inside, Points corners, double x, double y) {
        for (Points way : new Points[] {corners, corners.reversed()})
            assertEquals(inside, contains(ROBUST, way, x, y), way.toString());
    }

    static Stream<Arguments> mistakes() {
        Points triangle = Points.of(0, 0, 8, 0, 0, 8);
        Points flat = Points.of(0, 0, 4, 4, 2, 2);
        Points dot = Points.of(3, 3, 3, 3, 3, 3);
        Points large = Points.of(1.5e154, 0, 1.5e154, 1.2e154, 1.4e154, 1.1e154);
        return Stream.of(
                argumentSet("inside is outside", true, triangle, 1, 1),
                argumentSet("outside is inside", false, triangle, 5, 5),
                argumentSet("corner is outside", true, triangle, 8, 0),
                argumentSet("side is outside", true, triangle, 4, 4),
                argumentSet("line of a side is the side", false, triangle, 9, 0),
                argumentSet("triangle without area has no points", true, flat, 3, 3),
                argumentSet("its whole line is inside", false, flat, 5, 5),
                argumentSet("beside its line is inside", false, flat, 3, 2),
                argumentSet("triangle of one point has none", true, dot, 3, 3),
                argumentSet("triangle of one point has all", false, dot, 3, 4),
                argumentSet("overflowed product has a sign", false, large, 1.52e154, 0.6e154));
    }

    @Test
    void noPointWithinTwoUlpsOfASideIsMisjudged() {
        var random = new Random(SEED);
        for (int round = 0; round < ROUNDS; round++) {
            double size = Math.scalb(1.0, random.nextInt(60) - 30);
            Points corners = Points.of(random.doubles(6).map(v -> size * v).toArray());
            Points near = NearSides.of(corners, NEAR_POINTS, 2, random);
            var input = new ShapeAndPoints(corners, near);
            var exact = TOPIC.exact(input, NEAR_POINTS);
            var actual = TOPIC.record(ROBUST, input, NEAR_POINTS);
            String first = TOPIC.compare(input, exact, actual).first();
            assertEquals("", first, "seed " + SEED + ", round " + round + ", " + corners);
        }
    }

    @Test
    @DisplayName("the steps of the right method end in another answer than the method")
    void robustWalkEndsWithTheAnswer() {
        var stepped = (SteppedTriangleTest) ROBUST;
        var random = new Random(SEED);
        for (int round = 0; round < 10 * ROUNDS; round++) {
            Points t = Points.of(random.ints(6, -4, 5).asDoubleStream().toArray());
            double x = random.nextInt(-5, 6);
            double y = random.nextInt(-5, 6);
            String said = t + " (" + x + ", " + y + "), seed " + SEED;
            assertEquals(contains(ROBUST, t, x, y), walked(stepped, t, x, y), said);
        }
    }

    private static boolean walked(SteppedTriangleTest method, Points t, double x, double y) {
        SideWalk walk = method.walk(t.x(0), t.y(0), t.x(1), t.y(1), t.x(2), t.y(2), x, y);
        while (walk.advance())
            ;
        return walk.inside();
    }

    /** Whole numbers up to ±2¹⁴ overflow nothing, so the classics are right off the boundary. */
    @Property(tries = 2_000)
    void wholeNumbersOffTheBoundaryAreJudgedAlike(@ForAll long seed) {
        var random = new Random(seed);
        Points corners = Points.of(random.ints(6, -16384, 16384).asDoubleStream().toArray());
        double x = random.nextInt(-16384, 16384);
        double y = random.nextInt(-16384, 16384);
        boolean inside = contains(ROBUST, corners, x, y);
        for (Method<PointInTriangle> method : TOPIC.methods())
            assertEquals(
                    inside,
                    contains(method.implementation(), corners, x, y),
                    method.name() + " " + corners + " (" + x + ", " + y + ")");
    }

    /** The course: 4 multiplications and 10 subtractions at best, 6 and 15 at worst. */
    @Test
    void signMethodCostsFourToSixMultiplications() {
        Points corners = Points.of(0, 0, 8, 0, 0, 8);
        var inside = new ShapeAndPoints(corners, Points.of(1, 1));
        var outside = new ShapeAndPoints(corners, Points.of(-1, -1));
        assertEquals(
                Map.of("sides asked", 3L, "multiplications", 6L, "additions", 15L),
                TOPIC.operations(new SignDouble(), inside));
        assertEquals(
                Map.of("sides asked", 2L, "multiplications", 4L, "additions", 10L),
                TOPIC.operations(new SignDouble(), outside));
    }

    @Test
    void simplexCostsItsDivisionsAndStopsEarly() {
        assertCosts("{additions=8, divisions=1, multiplications=4, sides asked=1}", -1, 1);
        assertCosts("{additions=9, divisions=2, multiplications=6, sides asked=2}", 1, -1);
        assertCosts("{additions=10, divisions=2, multiplications=6, sides asked=3}", 1, 1);
    }

    private static void assertCosts(String costs, double x, double y) {
        var input = new ShapeAndPoints(Points.of(8, 0, 0, 8, 0, 0), Points.of(x, y));
        assertEquals(costs, new TreeMap<>(TOPIC.operations(new Simplex(), input)).toString());
    }

    @Test
    void rotationCostsAnAngleForEachCorner() {
        var input = new ShapeAndPoints(Points.of(0, 0, 8, 1, 3, 7), Points.of(3, 3));
        var counts = TOPIC.operations(new Rotation(), input);
        for (String angle : List.of("arc tangents", "sines", "cosines", "sides asked"))
            assertEquals(3, counts.get(angle), angle);
        assertEquals(18, counts.get("multiplications"));
        assertEquals(27, counts.get("additions"));
    }

    @Test
    void onlySidesAskedExactlyCountAsExact() {
        Points corners = Points.of(0, 0, 8, 0, 0, 8);
        var input = new ShapeAndPoints(corners, Points.of(1, 1, 9, 9, 4, 4));
        var counts = TOPIC.operations(ROBUST, input);
        assertEquals(3, counts.get("sides asked exactly"), "of (4, 4) alone");
        assertEquals(3 * 14, counts.get("multiplications"));
        assertEquals(3 * 25, counts.get("additions"));
    }

    @Test
    void stepsAreTheSidesUpToTheOneThatSettlesTheAnswer() {
        var walk = new SignInt().walk(0, 0, 8, 0, 0, 8, -1, 1);
        var steps = new ArrayList<String>();
        while (walk.advance()) steps.add(walk.side() + ": " + walk.value());
        assertEquals(List.of("0: 8.0", "1: -64.0"), steps);
        assertFalse(walk.inside());
    }

    /** Erratum: the text says that the way round does not matter. */
    @Test
    void forTheSignMethodTheBoundaryDependsOnTheWayRound() {
        Points corners = Points.of(0, 0, 0, 8, 8, 0);
        assertTrue(contains(new SignInt(), corners, 4, 4));
        assertFalse(contains(new SignInt(), corners.reversed(), 4, 4));
    }

    @Test
    void intOverflowsPastTwoToTheFifteenth() {
        Points corners = Points.of(-1, -1, 1, -1, 0, 1);
        assertTrue(contains(new SignInt(), corners.scaled(10_000), 0, 0));
        assertFalse(contains(new SignInt(), corners.scaled(40_000), 0, 0));
    }

    @Test
    void minusZeroPutsACornerOutside() {
        Points corners = Points.of(4, 0, 0, 0, 0, 4);
        assertTrue(contains(new SignInt(), corners, 4, 0));
        assertFalse(contains(new SignDouble(), corners, 4, 0));
        assertFalse(contains(new SignFloat(), corners, 4, 0));
    }

    @Test
    void everyMethodRefusesWhatIsNoNumber() {
        for (Method<PointInTriangle> method : TOPIC.methods())
            for (double bad : new double[] {Double.NaN, Double.NEGATIVE_INFINITY})
                for (int place = 0; place < 8; place++) {
                    var v = new double[] {0, 0, 8, 0, 0, 8, 1, 1};
                    v[place] = bad;
                    var refusal =
                            assertThrows(
                                    IllegalArgumentException.class,
                                    () ->
                                            method.implementation()
                                                    .contains(
                                                            v[0], v[1], v[2], v[3], v[4], v[5],
                                                            v[6], v[7]),
                                    method.name() + ", place " + place);
                    assertTrue(refusal.getMessage().contains("" + bad), refusal.getMessage());
                }
    }

    @Test
    void intRefusesFractionsAndWhatIsBeyondIntegers() {
        for (double bad : new double[] {0.5, 3e9}) {
            var refusal =
                    assertThrows(
                            IllegalArgumentException.class,
                            () -> new SignInt().contains(0, 0, 8, 0, 0, bad, 1, 1));
            assertEquals(
                    "coordinates must be whole numbers from -2147483648 to 2147483647, got " + bad,
                    refusal.getMessage());
        }
    }

    private static boolean contains(PointInTriangle method, Points t, double x, double y) {
        return method.contains(t.x(0), t.y(0), t.x(1), t.y(1), t.x(2), t.y(2), x, y);
    }
}
