package rasterlab.engine.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;

/** The course's first chapter: lines and planes of space. */
class SpaceTest {
    private static final Vector O = new Vector(0, 0, 0);
    private static final Plane PLANE = Plane.through(at(1, 0, 0), at(0, 2, 0), at(0, 0, 3));

    private static Vector at(double x, double y, double z) {
        return new Vector(x, y, z);
    }

    @Test
    void unitVectorsTurnRightHanded() {
        assertEquals(at(0, 0, 1), at(1, 0, 0).cross(at(0, 1, 0)));
        assertEquals(at(1, 0, 0), at(0, 1, 0).cross(at(0, 0, 1)));
        assertEquals(at(0, 1, 0), at(0, 0, 1).cross(at(1, 0, 0)));
    }

    @Test
    void muNamesThePartsOfALine() {
        var line = new Line(at(1, 2, 3), at(3, 2, 7));
        assertEquals(at(1, 2, 3), line.at(0));
        assertEquals(at(2, 2, 5), line.at(0.5));
        assertEquals(at(3, 2, 7), line.at(1));
        assertEquals(at(5, 2, 11), line.at(2));
        assertEquals(Line.PositionOnLine.BEHIND, Line.part(-0.1));
        assertEquals(Line.PositionOnLine.BETWEEN, Line.part(0));
        assertEquals(Line.PositionOnLine.BETWEEN, Line.part(1));
        assertEquals(Line.PositionOnLine.BEYOND, Line.part(1.1));
    }

    @Test
    void planeThroughThreePointsHoldsAllThree() {
        for (Vector point : new Vector[] {at(1, 0, 0), at(0, 2, 0), at(0, 0, 3)})
            assertEquals(0, PLANE.side(point), point.toString());
    }

    @Test
    void sideHasOneSignOnEachSide() {
        double origin = PLANE.side(O);
        assertTrue(origin * PLANE.side(at(0.1, 0.1, 0.1)) > 0);
        assertTrue(origin * PLANE.side(at(2, 2, 2)) < 0);
    }

    @Test
    void distanceFromTheOriginIsThatOfTheNearestPoint() {
        // x/1 + y/2 + z/3 = 1, so the distance is 1/√(1 + 1/4 + 1/9) = 6/7.
        assertEquals(6.0 / 7, PLANE.distanceFromOrigin(), 1e-15);
        assertEquals(6.0 / 7, PLANE.nearestToOrigin().length(), 1e-15);
        assertEquals(0, PLANE.side(PLANE.nearestToOrigin()), 1e-14);
    }

    @Test
    void lineMeetsPlane() {
        var plane = new Plane(at(0, 0, 2), 8);
        var line = new Line(at(1, 1, 0), at(2, 1, 1));
        assertEquals(4, plane.meets(line));
        assertEquals(at(5, 1, 4), line.at(plane.meets(line)));
    }

    @Test
    void parallelLineIsRefused() {
        var plane = new Plane(at(0, 0, 2), 8);
        for (double height : new double[] {0, 4}) {
            var line = new Line(at(0, 0, height), at(1, 1, height));
            var refusal = assertThrows(IllegalArgumentException.class, () -> plane.meets(line));
            assertEquals(
                    "line must not be parallel to the plane, but n·p* is 0.0",
                    refusal.getMessage());
        }
    }

    @Test
    void tinyAndHugeNumbersAreNoParallels() {
        for (double size : new double[] {1e-200, 1, 1e200}) {
            var plane = new Plane(at(0, 0, 2 * size), 8 * size);
            assertEquals(4, plane.meets(new Line(at(1, 1, 0), at(2, 1, 1))), "normal of " + size);
            var shrunk = Plane.through(at(size, 0, 0), at(0, 2 * size, 0), at(0, 0, 3 * size));
            var line = new Line(O, at(size, 2 * size, 3 * size));
            assertEquals(1.0 / 3, shrunk.meets(line), 1e-15, "points of " + size);
        }
    }

    @Test
    void aMuBeyondDoublesIsNotCalledParallel() {
        var line = new Line(at(0, 0, 0), at(1, 0, 1e-200));
        var refusal =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> new Plane(at(0, 0, 1), 1e200).meets(line));
        assertEquals(
                "line must meet the plane at a μ within doubles, got Infinity",
                refusal.getMessage());
    }

    @Test
    void whatIsNotFiniteIsNamedWithoutAPlace() {
        assertRefused("c must be finite, got NaN", () -> new Plane(at(0, 0, 1), Double.NaN));
        assertRefused("mu must be finite, got Infinity", () -> Line.part(1 / 0.0));
        assertRefused(
                "a line's points must be less than 1.8E308 apart, got "
                        + at(-1e308, 0, 0)
                        + " and "
                        + at(1e308, 0, 0),
                () -> new Line(at(-1e308, 0, 0), at(1e308, 0, 0)));
    }

    private static void assertRefused(String message, Executable what) {
        assertEquals(message, assertThrows(IllegalArgumentException.class, what).getMessage());
    }

    @Test
    void projectionIsNegativeForAnObtuseAngle() {
        assertEquals(3, at(3, 4, 5).projectedOn(at(7, 0, 0)));
        assertEquals(-3, at(3, 4, 5).projectedOn(at(-0.1, 0, 0)));
    }

    @Test
    void directionCosinesOfAKnownVector() {
        Vector cosines = at(2, 3, 6).unit();
        assertEquals(2.0 / 7, cosines.x(), 1e-15);
        assertEquals(3.0 / 7, cosines.y(), 1e-15);
        assertEquals(6.0 / 7, cosines.z(), 1e-15);
    }

    @Property(tries = 500)
    void squaresOfDirectionCosinesAddUpToOne(@ForAll long seed) {
        var random = new Random(seed);
        double size = Math.scalb(1.0, random.nextInt(2000) - 1000);
        Vector p =
                at(
                        size * random.nextGaussian(),
                        size * random.nextGaussian(),
                        size * random.nextGaussian());
        assertEquals(1, p.unit().dot(p.unit()), 1e-15, p.toString());
    }

    @Test
    void whatHasNoDirectionIsRefused() {
        assertThrows(IllegalArgumentException.class, O::unit);
        assertThrows(IllegalArgumentException.class, () -> at(1, 2, 3).projectedOn(O));
        assertThrows(IllegalArgumentException.class, () -> new Line(O, at(0, -0.0, 0)));
        assertThrows(IllegalArgumentException.class, () -> new Plane(O, 1));
        assertThrows(
                IllegalArgumentException.class,
                () -> Plane.through(at(1, 1, 1), at(2, 2, 2), at(5, 5, 5)));
        assertThrows(IllegalArgumentException.class, () -> at(0, Double.NaN, 0));
    }
}
