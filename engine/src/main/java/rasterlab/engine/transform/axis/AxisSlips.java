package rasterlab.engine.transform.axis;

import java.util.Arrays;
import java.util.List;
import rasterlab.contract.AxisRotation;
import rasterlab.engine.study.Slip;

/** Rotations about another axis, by another angle or of some points alone. */
final class AxisSlips {
    private AxisSlips() {}

    static List<Slip<AxisRotation>> of(AxisRotation right) {
        return List.of(
                Slip.of(
                        "point-not-moved-to-the-axis",
                        (through, direction, degrees, points) -> {
                            right.rotate(new double[3], direction, degrees, points);
                            add(points, through, 1);
                        }),
                Slip.of(
                        "moved-the-wrong-way",
                        (through, direction, degrees, points) ->
                                right.rotate(times(through, -1), direction, degrees, points)),
                Slip.of("sine-term-left-out", mean(right, 1)),
                Slip.of(
                        "twice-the-angle",
                        (through, direction, degrees, points) ->
                                right.rotate(through, direction, 2 * (degrees % 360), points)),
                Slip.of(
                        "half-the-angle",
                        (through, direction, degrees, points) ->
                                right.rotate(through, direction, degrees / 2, points)),
                Slip.of(
                        "sine-and-cosine-swapped",
                        (through, direction, degrees, points) ->
                                right.rotate(through, direction, 90 - degrees % 360, points)),
                Slip.of(
                        "about-a-coordinate-axis",
                        about(right, 1, 0, 0),
                        about(right, 0, 1, 0),
                        about(right, 0, 0, 1)),
                Slip.of(
                        "first-point-only",
                        (through, direction, degrees, points) ->
                                part(right, through, direction, degrees, points, 3)),
                Slip.of(
                        "last-point-left-out",
                        (through, direction, degrees, points) ->
                                part(
                                        right,
                                        through,
                                        direction,
                                        degrees,
                                        points,
                                        points.length - 3)));
    }

    /** The mean of the two ways to rotate, which has no term with the sine. */
    private static AxisRotation mean(AxisRotation right, int way) {
        return (through, direction, degrees, points) -> {
            double[] back = points.clone();
            right.rotate(through, direction, way * degrees, points);
            right.rotate(through, direction, -way * degrees, back);
            for (int i = 0; i < points.length; i++) points[i] = (points[i] + back[i]) / 2;
        };
    }

    private static AxisRotation about(AxisRotation right, double x, double y, double z) {
        return (through, direction, degrees, points) ->
                right.rotate(through, new double[] {x, y, z}, degrees, points);
    }

    private static void part(
            AxisRotation right,
            double[] through,
            double[] direction,
            double degrees,
            double[] points,
            int numbers) {
        double[] first = Arrays.copyOf(points, Math.max(0, Math.min(numbers, points.length)));
        right.rotate(through, direction, degrees, first);
        System.arraycopy(first, 0, points, 0, first.length);
    }

    private static void add(double[] points, double[] by, double factor) {
        for (int i = 0; i < points.length; i++) points[i] += factor * by[i % 3];
    }

    private static double[] times(double[] vector, double factor) {
        return new double[] {factor * vector[0], factor * vector[1], factor * vector[2]};
    }
}
