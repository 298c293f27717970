package rasterlab.engine.transform.rotate;

import java.util.Arrays;
import java.util.List;
import rasterlab.contract.PlaneRotation;
import rasterlab.engine.study.Slip;

/** Rotations by a matrix with one number mistaken, or of some numbers alone. */
final class RotateSlips {
    private RotateSlips() {}

    static List<Slip<PlaneRotation>> of(PlaneRotation right) {
        return List.of(
                Slip.of(
                        "sine-and-cosine-swapped",
                        by(a -> new double[] {sin(a), -cos(a), cos(a), sin(a)})),
                Slip.of(
                        "cosine-taken-for-1",
                        by(a -> new double[] {1, -a, a, 1}),
                        by(a -> new double[] {1, -sin(a), sin(a), 1})),
                Slip.of(
                        "one-sign-of-the-sine",
                        by(a -> new double[] {cos(a), sin(a), sin(a), cos(a)}),
                        by(a -> new double[] {cos(a), -sin(a), -sin(a), cos(a)})),
                Slip.of(
                        "mirrored-not-rotated",
                        by(a -> new double[] {cos(a), sin(a), sin(a), -cos(a)}),
                        by(a -> new double[] {-cos(a), sin(a), sin(a), cos(a)})),
                Slip.of("half-the-angle", by(a -> rotation(a / 2))),
                Slip.of("twice-the-angle", by(a -> rotation(2 * a))),
                Slip.of("one-coordinate-only", coordinate(right, 0), coordinate(right, 1)),
                Slip.of(
                        "first-point-only",
                        (degrees, times, points) -> part(right, degrees, times, points, 2)),
                Slip.of(
                        "last-point-left-out",
                        (degrees, times, points) ->
                                part(right, degrees, times, points, points.length - 2)));
    }

    private interface Matrix {
        /** Four numbers, row by row, by the angle in radians. */
        double[] of(double angle);
    }

    private static double[] rotation(double a) {
        return new double[] {cos(a), -sin(a), sin(a), cos(a)};
    }

    private static double sin(double angle) {
        return Math.sin(angle);
    }

    private static double cos(double angle) {
        return Math.cos(angle);
    }

    private static PlaneRotation by(Matrix matrix) {
        return (degrees, times, points) -> {
            double[] all = power(matrix.of(Math.toRadians(degrees % 360)), times);
            for (int i = 0; i + 1 < points.length; i += 2) {
                double x = points[i];
                double y = points[i + 1];
                points[i] = all[0] * x + all[1] * y;
                points[i + 1] = all[2] * x + all[3] * y;
            }
        };
    }

    private static double[] power(double[] matrix, int times) {
        double[] power = {1, 0, 0, 1};
        double[] squared = matrix;
        for (int left = times; left > 0; left /= 2) {
            if (left % 2 == 1) power = product(power, squared);
            squared = product(squared, squared);
        }
        return power;
    }

    private static double[] product(double[] a, double[] b) {
        return new double[] {
            a[0] * b[0] + a[1] * b[2],
            a[0] * b[1] + a[1] * b[3],
            a[2] * b[0] + a[3] * b[2],
            a[2] * b[1] + a[3] * b[3]
        };
    }

    private static PlaneRotation coordinate(PlaneRotation right, int kept) {
        return (degrees, times, points) -> {
            double[] rotated = points.clone();
            right.rotate(degrees, times, rotated);
            for (int i = kept; i < points.length; i += 2) points[i] = rotated[i];
        };
    }

    private static void part(
            PlaneRotation right, double degrees, int times, double[] points, int numbers) {
        double[] first = Arrays.copyOf(points, Math.max(0, Math.min(numbers, points.length)));
        right.rotate(degrees, times, first);
        System.arraycopy(first, 0, points, 0, first.length);
    }
}
