package rasterlab.engine.spline.curve;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class ControlHullTest {
    static Stream<Arguments> points() {
        return Stream.of(
                argumentSet(
                        "inner point is a corner",
                        of(0, 4, 2, 4, 0),
                        of(0, 0, 1, 4, 4),
                        of(0, 1, 3, 4)),
                argumentSet(
                        "point on an edge is a corner",
                        of(0, 2, 4, 4),
                        of(0, 0, 0, 4),
                        of(0, 2, 3)),
                argumentSet("line has an inside", of(1, 3, 2), of(1, 3, 2), of(0, 1)),
                argumentSet("upright line is lost", of(1, 1, 1), of(2, 9, 4), of(0, 1)),
                argumentSet("same point is a corner twice", of(7, 7, 7), of(4, 4, 4), of(0)),
                argumentSet(
                        "doubled corner is there twice",
                        of(0, 0, 4, 4),
                        of(0, 0, 0, 4),
                        of(0, 2, 3)),
                argumentSet("single point is lost", of(5), of(6), of(0)));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("points")
    void cornersGoAroundAllPoints(double[] x, double[] y, double[] corners) {
        int[] hull = ControlHull.of(x, y);
        var found = new double[hull.length];
        for (int i = 0; i < hull.length; i++) found[i] = hull[i];
        assertArrayEquals(corners, found);
    }

    @Test
    void noPointsAreRefused() {
        assertThrows(IllegalArgumentException.class, () -> ControlHull.of(of(), of()));
        assertThrows(IllegalArgumentException.class, () -> ControlHull.of(of(1), of(1, 2)));
    }

    private static double[] of(double... numbers) {
        return numbers;
    }
}
