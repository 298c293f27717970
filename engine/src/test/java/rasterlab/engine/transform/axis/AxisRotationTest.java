package rasterlab.engine.transform.axis;

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
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.AxisRotation;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Method;
import rasterlab.engine.transform.CountingArithmetic;
import rasterlab.engine.transform.Images;

class AxisRotationTest {
    private static final AxisTopic TOPIC = new AxisTopic();

    /** 10,000 with {@code -Drasterlab.full=true}. */
    private static final int LINES = Boolean.getBoolean("rasterlab.full") ? 10_000 : 300;

    private static final double[] ORIGIN = {0, 0, 0};
    private static final double[] AXIS = {1 / 3.0, 2 / 3.0, 2 / 3.0};

    static Stream<Method<AxisRotation>> methods() {
        return TOPIC.methods().stream();
    }

    static Stream<Method<AxisRotation>> right() {
        return methods().filter(method -> !method.faulty());
    }

    @Test
    void lectureSevenStepsMoveTheAxisItself() {
        double[] point = AXIS.clone();
        new SevenStepsTextbook().rotate(ORIGIN, AXIS, 37, point);
        assertArrayEquals(new double[] {0.159, 0.897, 0.413}, point, 5e-4);
    }

    @Test
    void lectureStepsTwoAndThreeDoNotBringTheAxisOntoZ() {
        AxisWalk walk = new SevenStepsTextbook().walk(ORIGIN, AXIS, 37, AXIS.clone());
        for (int step = 1; step <= 3; step++) assertTrue(walk.advance());
        assertArrayEquals(new double[] {0.111, 0.596, 0.795}, walk.points(), 5e-4);
    }

    /**
     * The turned step gives R_z = [l/d −m/d; m/d l/d], and R_y, which is as printed, ends on the
     * wrong axis.
     */
    @Test
    void lectureStepTwoTurnedRoundBringsTheAxisOntoX() {
        List<AxisStep> steps = new SevenStepsTextbook().steps(ORIGIN, AXIS, 37);
        var about = (AxisStep.Turn) steps.get(1);
        double[] axis = AXIS.clone();
        about.back("step 2 turned round").apply(axis, 0);
        steps.get(2).apply(axis, 0);
        assertArrayEquals(new double[] {1, 0, 0}, axis, 1e-15);
    }

    @Test
    void rightStepsBringTheAxisOntoZ() {
        AxisWalk walk = new SevenSteps().walk(ORIGIN, AXIS, 37, AXIS.clone());
        for (int step = 1; step <= 3; step++) assertTrue(walk.advance());
        assertArrayEquals(new double[] {0, 0, 1}, walk.points(), 1e-15);
        assertEquals("turn about y by −φ: the axis onto z", walk.text());
        for (int step = 4; step <= 7; step++) assertTrue(walk.advance());
        assertArrayEquals(AXIS, walk.points(), 1e-15);
        assertFalse(walk.advance());
    }

    @ParameterizedTest
    @MethodSource("right")
    void takesEachAxisToTheNextOneAboutTheDiagonal(Method<AxisRotation> method) {
        double[] points = {1, 0, 0, 0, 1, 0, 0, 0, 1};
        method.implementation().rotate(ORIGIN, new double[] {5, 5, 5}, 120, points);
        assertArrayEquals(new double[] {0, 1, 0, 0, 0, 1, 1, 0, 0}, points, 1e-15);
    }

    @ParameterizedTest
    @MethodSource("right")
    void turnsAboutALineThatMissesTheOrigin(Method<AxisRotation> method) {
        double[] points = {3, 4, 5};
        method.implementation()
                .rotate(new double[] {2, 4, -77}, new double[] {0, 0, 1}, 90, points);
        assertArrayEquals(new double[] {2, 5, 5}, points, 1e-13);
    }

    @ParameterizedTest
    @MethodSource("right")
    void isExactOnRandomLines(Method<AxisRotation> method) {
        long seed = 1840;
        var random = new Random(seed);
        double worst = 0;
        for (int i = 0; i < LINES; i++) {
            var turn =
                    new AxisTurn(
                            numbers(random),
                            numbers(random),
                            random.nextDouble(-1e4, 1e4),
                            numbers(random));
            Images exact = TOPIC.exact(turn, 1);
            Images actual = TOPIC.record(method.implementation(), turn, 1);
            Deviation deviation = TOPIC.compare(turn, exact, actual);
            worst = Math.max(worst, deviation.worst());
            assertTrue(TOPIC.correct(deviation), () -> "seed " + seed + " " + deviation);
        }
        assertTrue(worst > 0, "rounding must be seen, else nothing was compared");
    }

    private static double[] numbers(Random random) {
        double size = Math.scalb(1, random.nextInt(-30, 31));
        return random.doubles(3, -size, size).toArray();
    }

    @ParameterizedTest
    @MethodSource("methods")
    void acceptsNoPoints(Method<AxisRotation> method) {
        method.implementation().rotate(ORIGIN, AXIS, 37, new double[0]);
    }

    @ParameterizedTest
    @MethodSource("right")
    void turnsAMillionPoints(Method<AxisRotation> method) {
        double[] points = new Random(1).doubles(3_000_000, -1, 1).toArray();
        double[] before = points.clone();
        method.implementation().rotate(ORIGIN, new double[] {1, 1, 1}, 120, points);
        for (int at = 0; at < points.length; at += 3) {
            assertEquals(before[at], points[at + 1], 1e-14);
            assertEquals(before[at + 1], points[at + 2], 1e-14);
            assertEquals(before[at + 2], points[at], 1e-14);
        }
    }

    @ParameterizedTest
    @MethodSource("right")
    void staysFiniteAtTheLimit(Method<AxisRotation> method) {
        double far = 0x1p1000;
        double[] points = {far, -far, far};
        method.implementation().rotate(new double[] {-far, far, -far}, AXIS, 37, points);
        for (double coordinate : points) assertTrue(Double.isFinite(coordinate));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void refuses(
            double[] through, double[] direction, double degrees, double[] points, String message) {
        for (Method<AxisRotation> method : TOPIC.methods()) {
            var refusal =
                    assertThrows(
                            IllegalArgumentException.class,
                            () ->
                                    method.implementation()
                                            .rotate(through, direction, degrees, points),
                            method.name());
            assertEquals(message, refusal.getMessage());
        }
    }

    static Stream<Arguments> mistakes() {
        double[] none = {};
        String range =
                " must be a finite number from -1.0715086071862673E301 to 1.0715086071862673E301, got ";
        return Stream.of(
                argumentSet(
                        "no axis is accepted",
                        ORIGIN,
                        ORIGIN,
                        1.0,
                        none,
                        "direction must not be zero, got (0, 0, 0)"),
                argumentSet(
                        "a NaN point is turned",
                        ORIGIN,
                        AXIS,
                        1.0,
                        new double[] {1, 2, 3, 4, Double.NaN, 6},
                        "points[1].y" + range + "NaN"),
                argumentSet(
                        "the sum overflows",
                        ORIGIN,
                        AXIS,
                        1.0,
                        new double[] {1e302, 2, 3},
                        "points[0].x" + range + "1.0E302"),
                argumentSet(
                        "half a point is read",
                        ORIGIN,
                        AXIS,
                        1.0,
                        new double[] {1, 2},
                        "points must have 3 numbers each, got 2 numbers in all"),
                argumentSet(
                        "an infinite line is accepted",
                        new double[] {0, 0, 1 / 0.0},
                        AXIS,
                        1.0,
                        none,
                        "through.z" + range + "Infinity"),
                argumentSet(
                        "a NaN angle is accepted",
                        ORIGIN,
                        AXIS,
                        Double.NaN,
                        none,
                        "the angle must be a finite number of degrees, got NaN"));
    }

    @Test
    void operationsAreCountedAsTheyRun() {
        AxisTurn one = AxisTurn.about(1, 2, 2, 37, 1, 2, 3);
        for (String steps : List.of("seven-steps", "seven-steps-textbook"))
            assertEquals(Map.of("additions", 16L, "multiplications", 20L), count(steps, one));
        assertEquals(Map.of("additions", 17L, "multiplications", 19L), count("rodrigues", one));
        assertEquals(Map.of("additions", 18L, "multiplications", 18L), count("quaternion", one));
    }

    @ParameterizedTest(name = "{0} counts other work than it does")
    @MethodSource("methods")
    void countingTwinGivesTheSamePoints(Method<AxisRotation> method) {
        var random = new Random(17);
        var rotation = (CheckedAxisRotation) method.implementation();
        for (int i = 0; i < 100; i++) {
            double[] points = random.doubles(6, -9, 9).toArray();
            double[] counted = points.clone();
            double[] through = random.doubles(3, -9, 9).toArray();
            double[] direction = random.doubles(3, -9, 9).toArray();
            double degrees = random.nextDouble(-400, 400);
            rotation.rotate(through, direction, degrees, points);
            rotation.count(new CountingArithmetic(), through, direction, degrees, counted);
            assertArrayEquals(points, counted);
        }
    }

    private static Map<String, Long> count(String method, AxisTurn turn) {
        return TOPIC.operations(TOPIC.method(method).implementation(), turn);
    }
}
