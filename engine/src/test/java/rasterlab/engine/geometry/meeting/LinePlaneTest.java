package rasterlab.engine.geometry.meeting;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.Random;
import java.util.stream.Stream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.LinePlane;
import rasterlab.engine.geometry.Line;

class LinePlaneTest {
    private static final LinePlaneTopic TOPIC = new LinePlaneTopic();
    private static final double CORRECT = 8 * 0x1p-53;

    /** Small integers and steps of them, so that lines are often nearly or quite parallel. */
    @Property(tries = 3_000)
    void unroundedIsRightHoweverNearlyParallel(@ForAll long seed) {
        var random = new Random(seed);
        double[] normal = {near(random), near(random), 1 + random.nextInt(3)};
        double c = near(random);
        double[] from = {near(random), near(random), near(random)};
        double[] through = {near(random), near(random), 9};
        double exact = new ExactMeeting().meets(normal, c, from, through);
        LinePlane unrounded = TOPIC.method("unrounded").implementation();
        if (Double.isNaN(exact))
            assertThrows(
                    IllegalArgumentException.class,
                    () -> unrounded.meets(normal, c, from, through));
        else
            assertEquals(
                    exact,
                    unrounded.meets(normal, c, from, through),
                    CORRECT * Math.max(1, Math.abs(exact)));
    }

    private static double near(Random random) {
        double whole = random.nextInt(7) - 3;
        return whole + (random.nextInt(3) - 1) * 0x1p-51;
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("tiny")
    void formulaKeepsTheSignOfATinyMu(
            double expected, double[] normal, double c, double[] from, double[] direction) {
        LinePlane formula = TOPIC.method("formula").implementation();
        for (int sign : new int[] {1, -1}) {
            double[] start = sum(sign, from, 0, direction);
            double[] through = sum(sign, from, 1, direction);
            double mu = formula.meets(normal, sign * c, start, through);
            assertEquals(expected, sign * mu, CORRECT * expected);
            assertEquals(
                    sign < 0 ? Line.PositionOnLine.BEHIND : Line.PositionOnLine.BETWEEN,
                    Line.part(mu));
        }
    }

    private static double[] sum(int ofA, double[] a, int ofB, double[] b) {
        return of(ofA * a[0] + ofB * b[0], ofA * a[1] + ofB * b[1], ofA * a[2] + ofB * b[2]);
    }

    static Stream<Arguments> tiny() {
        return Stream.of(
                argumentSet(
                        "c over the normal is below doubles",
                        1e-307,
                        of(1e100, 0, 0),
                        1e-300,
                        of(0, 0, 0),
                        of(1e-93, 0, 0)),
                argumentSet(
                        "a coordinate of the normal is below doubles beside another",
                        1e-300,
                        of(1e300, 1e-300, 0),
                        0,
                        of(0, -1, 0),
                        of(1e-300, 0, 0)),
                argumentSet(
                        "the answer itself is below doubles",
                        Double.MIN_VALUE,
                        of(1, 0, 0),
                        1e-200,
                        of(0, 0, 0),
                        of(1e200, 0, 0)));
    }

    /** The course gives the formula and says nothing of n·p* = 0. */
    @Test
    void theTextbooksFormulaAnswersForAParallelLine() {
        LinePlane textbook = TOPIC.method("formula-textbook").implementation();
        double[] normal = {0, 0, 2};
        assertEquals(1 / 0.0, textbook.meets(normal, 8, of(0, 0, 1), of(1, 1, 1)));
        assertTrue(Double.isNaN(textbook.meets(normal, 8, of(0, 0, 4), of(1, 1, 4))));
    }

    @Test
    void whatIsNoNumberOrTooFarApartIsRefused() {
        for (String name : new String[] {"formula", "unrounded"}) {
            LinePlane method = TOPIC.method(name).implementation();
            for (double bad : new double[] {Double.NaN, Double.NEGATIVE_INFINITY}) {
                assertRefused(() -> method.meets(of(0, bad, 1), 1, of(0, 0, 0), of(0, 0, 1)));
                assertRefused(() -> method.meets(of(0, 0, 1), bad, of(0, 0, 0), of(0, 0, 1)));
                assertRefused(() -> method.meets(of(0, 0, 1), 1, of(bad, 0, 0), of(0, 0, 1)));
                assertRefused(() -> method.meets(of(0, 0, 1), 1, of(0, 0, 0), of(0, bad, 1)));
            }
            assertRefused(() -> method.meets(of(0, 0, 0), 1, of(0, 0, 0), of(0, 0, 1)));
        }
        var unrounded = new UnroundedMeeting();
        assertRefused(() -> unrounded.meets(of(1, 1e-200, 0), 1, of(0, 0, 0), of(1, 0, 1)));
        assertRefused(() -> unrounded.meets(of(1, 0, 0), 1e-300, of(0, 0, 0), of(1, 0, 1)));
    }

    private static void assertRefused(Runnable call) {
        assertThrows(IllegalArgumentException.class, call::run);
    }

    private static double[] of(double x, double y, double z) {
        return new double[] {x, y, z};
    }
}
