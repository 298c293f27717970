package rasterlab.engine.transform;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;
import rasterlab.contract.AxisRotation;
import rasterlab.contract.PlaneRotation;
import rasterlab.engine.transform.axis.AxisTopic;
import rasterlab.engine.transform.rotate.RotateTopic;

/**
 * Checks properties of every rotation, about the origin of the plane and about any line of space.
 */
class RotationPropertyTest {
    private static final int TRIES = 300;

    @Provide
    Arbitrary<PlaneRotation> plane() {
        var topic = new RotateTopic();
        return Arbitraries.of("direct", "buneman", "orthonormal", "quaternion", "total-angle")
                .map(name -> topic.method(name).implementation());
    }

    @Provide
    Arbitrary<AxisRotation> space() {
        var topic = new AxisTopic();
        return Arbitraries.of("seven-steps", "rodrigues", "quaternion")
                .map(name -> topic.method(name).implementation());
    }

    @Provide
    Arbitrary<double[]> pairs() {
        return numbers(2);
    }

    /** A point of the line and its direction. */
    @Provide
    Arbitrary<double[]> lines() {
        return numbers(6).filter(line -> line[3] != 0 || line[4] != 0 || line[5] != 0);
    }

    private static Arbitrary<double[]> numbers(int count) {
        return Arbitraries.doubles().between(-100, 100).array(double[].class).ofSize(count);
    }

    @Property(tries = TRIES)
    void turningBackBringsThePointHome(
            @ForAll("plane") PlaneRotation method,
            @ForAll @DoubleRange(min = -1e4, max = 1e4) double degrees,
            @ForAll("pairs") double[] point) {
        double[] there = point.clone();
        method.rotate(degrees, 7, there);
        method.rotate(-degrees, 7, there);
        for (int i = 0; i < 2; i++) assertEquals(point[i], there[i], 1e-11);
    }

    @Property(tries = TRIES)
    void radiusStays(
            @ForAll("plane") PlaneRotation method,
            @ForAll @DoubleRange(min = -1e4, max = 1e4) double degrees,
            @ForAll("pairs") double[] point) {
        double[] turned = point.clone();
        method.rotate(degrees, 1, turned);
        assertEquals(Math.hypot(point[0], point[1]), Math.hypot(turned[0], turned[1]), 1e-12);
    }

    @Property(tries = TRIES)
    void pointsOfTheAxisStay(
            @ForAll("space") AxisRotation method,
            @ForAll("lines") double[] line,
            @ForAll @DoubleRange(min = -3, max = 3) double along,
            @ForAll @DoubleRange(min = -1e4, max = 1e4) double degrees) {
        double[] direction = {line[3], line[4], line[5]};
        double[] point = new double[3];
        for (int i = 0; i < 3; i++) point[i] = line[i] + along * direction[i];
        double[] turned = point.clone();
        method.rotate(new double[] {line[0], line[1], line[2]}, direction, degrees, turned);
        for (int i = 0; i < 3; i++) assertEquals(point[i], turned[i], 1e-11);
    }

    @Property(tries = TRIES)
    void distancesAndHandednessStay(
            @ForAll("space") AxisRotation method,
            @ForAll("lines") double[] line,
            @ForAll @DoubleRange(min = -1e4, max = 1e4) double degrees) {
        double[] direction = {line[3], line[4], line[5]};
        double[] p = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
        method.rotate(new double[] {line[0], line[1], line[2]}, direction, degrees, p);
        for (int i = 0; i < 3; i++) for (int c = 0; c < 3; c++) p[3 * i + 3 + c] -= p[c];
        double determinant = 0;
        for (int i = 0; i < 3; i++) {
            int j = (i + 1) % 3;
            int k = (i + 2) % 3;
            double length =
                    Math.sqrt(p[3 + i] * p[3 + i] + p[6 + i] * p[6 + i] + p[9 + i] * p[9 + i]);
            assertEquals(1, length, 1e-11);
            determinant += p[3 + i] * (p[6 + j] * p[9 + k] - p[6 + k] * p[9 + j]);
        }
        assertTrue(Math.abs(determinant - 1) < 1e-11, () -> "handedness is lost");
    }
}
