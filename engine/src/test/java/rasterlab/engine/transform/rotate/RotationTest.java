package rasterlab.engine.transform.rotate;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.contract.PlaneRotation;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Method;

class RotationTest {
    private static final RotateTopic TOPIC = new RotateTopic();
    private static final List<String> RIGHT =
            List.of("direct", "buneman", "orthonormal", "quaternion", "total-angle");

    /** 100,000 with {@code -Drasterlab.full=true}. */
    private static final int ANGLES = Boolean.getBoolean("rasterlab.full") ? 100_000 : 500;

    static Stream<Method<PlaneRotation>> methods() {
        return TOPIC.methods().stream();
    }

    @ParameterizedTest
    @MethodSource("methods")
    void lectureTriangleTurnedBy90Degrees(Method<PlaneRotation> method) {
        double[] triangle = {3, -1, 4, 1, 2, 1};
        method.implementation().rotate(90, 1, triangle);
        assertArrayEquals(new double[] {1, 3, -1, 4, -1, 2}, triangle, 1e-15);
    }

    @ParameterizedTest
    @MethodSource("methods")
    void noTurnLeavesEveryPoint(Method<PlaneRotation> method) {
        double[] points = {3, -1, 0.5, 7};
        method.implementation().rotate(12.34, 0, points);
        assertArrayEquals(new double[] {3, -1, 0.5, 7}, points);
    }

    @ParameterizedTest(name = "{0} loses digits at some angle")
    @ValueSource(strings = {"direct", "buneman", "orthonormal", "quaternion", "total-angle"})
    @Tag("slow")
    void oneTurnIsExactForEveryAngle(String name) {
        long seed = 1986;
        var random = new Random(seed);
        for (int i = 0; i < ANGLES; i++) {
            double degrees = Math.scalb(random.nextDouble(-1, 1), random.nextInt(-10, 40));
            double[] point = random.doubles(2, -1, 1).toArray();
            assertExact(name, new Turns(degrees, 1, point), "seed " + seed);
        }
    }

    @ParameterizedTest(name = "{0} is lost about {0}°")
    @ValueSource(doubles = {90, 180, 270, 360, 540, -180, -90})
    void everyRightMethodSurvivesTheNeighbourhoodOfQuarters(double degrees) {
        for (String name : RIGHT)
            for (double by : new double[] {0, 1e-13, -1e-13, 1e-6, -1e-6, 0.5})
                assertExact(name, new Turns(degrees + by, 1, new double[] {3, 4}), "");
    }

    @ParameterizedTest(name = "{0} half turns are taken for one")
    @ValueSource(ints = {1, 2, 3, 4})
    void bunemanCountsItsHalfTurns(int times) {
        double[] point = {3, 4};
        TOPIC.method("buneman").implementation().rotate(180, times, point);
        int sign = times % 2 == 0 ? 1 : -1;
        assertArrayEquals(new double[] {3 * sign, 4 * sign}, point);
    }

    @Test
    void totalAngleIsExactAfterAnyNumberOfTurns() {
        long seed = 1971;
        var random = new Random(seed);
        for (int i = 0; i < ANGLES; i++)
            assertExact(
                    "total-angle",
                    new Turns(
                            random.nextDouble(-1e6, 1e6),
                            random.nextInt(PlaneRotation.MOST_TIMES + 1),
                            random.doubles(2, -1, 1).toArray()),
                    "seed " + seed);
    }

    private static void assertExact(String name, Turns turns, String seed) {
        var method = TOPIC.method(name).implementation();
        Deviation deviation =
                TOPIC.compare(turns, TOPIC.exact(turns, 9), TOPIC.record(method, turns, 9));
        assertTrue(
                TOPIC.correct(deviation),
                () -> name + " by " + turns.degrees() + "° " + seed + ": " + deviation);
    }

    @ParameterizedTest(name = "{0} drifts more than its contract allows")
    @ValueSource(strings = {"direct", "buneman", "orthonormal", "quaternion", "total-angle"})
    void roundingDriftsNoFartherThanTheContractSays(String name) {
        long seed = 2005;
        var random = new Random(seed);
        for (int i = 0; i < ANGLES; i++) {
            int times = 1 << random.nextInt(14);
            double[] point = random.doubles(2, -1, 1).toArray();
            var turns = new Turns(random.nextDouble(-720, 720), times, point);
            assertDrifts(true, name, turns, "seed " + seed);
        }
        assertDrifts(true, name, new Turns(33.3, 1_000_000, new double[] {60, 80}), "");
    }

    @ParameterizedTest(name = "{0} passes for a rotation in doubles")
    @ValueSource(strings = {"float", "table"})
    void whatIsLessExactDriftsFarther(String name) {
        assertDrifts(false, name, new Turns(12.3, 1_000, new double[] {60, 80}), "");
    }

    private static void assertDrifts(boolean within, String name, Turns turns, String seed) {
        var method = TOPIC.method(name).implementation();
        Deviation deviation =
                TOPIC.compare(turns, TOPIC.exact(turns, 9), TOPIC.record(method, turns, 9));
        double allowed = (turns.times() + 4) * PlaneRotation.DRIFT;
        assertEquals(
                within,
                deviation.worst() <= allowed,
                () ->
                        "%s by %s° × %d %s: %s"
                                .formatted(name, turns.degrees(), turns.times(), seed, deviation));
    }

    @Test
    void accumulatedOrientationsKeepTheRadius() {
        for (String name : List.of("orthonormal", "quaternion")) {
            double[] point = {60, 80};
            TOPIC.method(name).implementation().rotate(33.3, 1_000_000, point);
            assertEquals(100, Math.hypot(point[0], point[1]), 1e-13, name);
        }
    }

    @ParameterizedTest
    @MethodSource("methods")
    @Tag("slow")
    void turnsAMillionPoints(Method<PlaneRotation> method) {
        double[] points = new Random(1).doubles(2_000_000, -1, 1).toArray();
        double[] before = points.clone();
        method.implementation().rotate(90, 1, points);
        for (int at = 0; at < points.length; at += 2) {
            assertEquals(-before[at + 1], points[at], 1e-7);
            assertEquals(before[at], points[at + 1], 1e-7);
        }
    }

    @ParameterizedTest
    @MethodSource("methods")
    void acceptsNoPoints(Method<PlaneRotation> method) {
        method.implementation().rotate(1, 1, new double[0]);
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void refuses(double degrees, int times, double[] points, String message) {
        for (Method<PlaneRotation> method : TOPIC.methods()) {
            var refusal =
                    assertThrows(
                            IllegalArgumentException.class,
                            () -> method.implementation().rotate(degrees, times, points),
                            method.name());
            String said = refusal.getMessage().replaceAll("from -.* to .*E(301|36),", "in range,");
            assertEquals(message, said, method.name());
        }
    }

    static Stream<Arguments> mistakes() {
        double[] none = {};
        return Stream.of(
                argumentSet(
                        "a NaN angle is turned by",
                        Double.NaN,
                        1,
                        none,
                        "degrees must be a finite number, got NaN"),
                argumentSet(
                        "an infinite angle is turned by",
                        1 / 0.0,
                        1,
                        none,
                        "degrees must be a finite number, got Infinity"),
                argumentSet(
                        "turns are counted backwards",
                        1.0,
                        -1,
                        none,
                        "times must be from 0 to 10000000, got -1"),
                argumentSet(
                        "a method runs for hours",
                        1.0,
                        2_000_000_000,
                        none,
                        "times must be from 0 to 10000000, got 2000000000"),
                argumentSet(
                        "half a point is read",
                        1.0,
                        1,
                        new double[] {1},
                        "points must have 2 numbers each, got 1 numbers in all"),
                argumentSet(
                        "a NaN point is turned",
                        1.0,
                        1,
                        new double[] {1, 2, Double.NaN, 4},
                        "points[1].x must be a finite number in range, got NaN"),
                argumentSet(
                        "the sum overflows",
                        1.0,
                        1,
                        new double[] {0, -1e308},
                        "points[0].y must be a finite number in range, got -1.0E308"));
    }

    @Test
    void floatRefusesWhatItWouldTakeForZero() {
        PlaneRotation method = TOPIC.method("float").implementation();
        var refusal =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> method.rotate(1, 1, new double[] {1, 1e-40}));
        assertEquals(
                "points[0].y must be 0 or at least 7.888609052210118E-31 in magnitude for a float,"
                        + " got 1.0E-40",
                refusal.getMessage());
    }

    @Test
    void chapter3BunemanSavesOneMultiplicationPerTurn() {
        var turns = new Turns(37, 1_000, new double[] {3, 4});
        assertEquals(
                Map.of("additions", 2_000L, "multiplications", 4_000L), count("direct", turns));
        assertEquals(
                Map.of("additions", 3_000L, "multiplications", 3_000L), count("buneman", turns));
        assertEquals(count("direct", turns), count("float", turns));
        assertEquals(Map.of("additions", 2L, "multiplications", 4L), count("total-angle", turns));
    }

    @ParameterizedTest(name = "{0} steps to another point")
    @ValueSource(strings = {"direct", "table", "buneman-textbook", "buneman"})
    void stepsLeadToThePointThatTheMethodComputes(String name) {
        var rotation = (SteppedRotation) TOPIC.method(name).implementation();
        for (double degrees : new double[] {37, -100, 179.5, 180, 540})
            for (int times = 0; times < 5; times++) {
                double[] point = {3, 4};
                TurnWalk walk = rotation.walk(degrees, times, 3, 4);
                while (walk.advance()) {}
                rotation.rotate(degrees, times, point);
                String where = times + " turns by " + degrees;
                assertArrayEquals(point, new double[] {walk.x(), walk.y()}, where);
                assertEquals(times, walk.turn());
            }
    }

    @Test
    void bunemanStepsThroughTAndTheTwoCoordinates() {
        var buneman = (SteppedRotation) TOPIC.method("buneman").implementation();
        TurnWalk walk = buneman.walk(90, 1, 3, 4);
        assertStep(walk, "T = y + x·t", 7);
        assertStep(walk, "x' = x − T·sin θ", -4);
        assertStep(walk, "y' = x'·t + T", 3);
        assertFalse(walk.advance());
    }

    private static void assertStep(TurnWalk walk, String text, double value) {
        assertTrue(walk.advance());
        assertEquals(text, walk.text());
        assertEquals(value, walk.value(), 1e-15);
    }

    @ParameterizedTest(name = "{0} counts other work than it does")
    @MethodSource("methods")
    void countingTwinGivesTheSamePoints(Method<PlaneRotation> method) {
        var random = new Random(17);
        var rotation = (CountedRotation) method.implementation();
        for (int times = 0; times < 100; times++) {
            double[] points = random.doubles(4, -9, 9).toArray();
            double[] counted = points.clone();
            double degrees = random.nextDouble(-400, 400);
            rotation.rotate(degrees, times, points);
            rotation.rotate(new CountingTurnLoops(), degrees, times, counted);
            assertArrayEquals(points, counted);
        }
    }

    private static Map<String, Long> count(String method, Turns turns) {
        return TOPIC.operations(TOPIC.method(method).implementation(), turns);
    }
}
