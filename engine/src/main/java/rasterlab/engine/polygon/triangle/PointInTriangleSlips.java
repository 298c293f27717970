package rasterlab.engine.polygon.triangle;

import java.util.List;
import java.util.stream.IntStream;
import rasterlab.contract.PointInTriangle;
import rasterlab.engine.study.Slip;

/** Points judged by some sides of a triangle, or by a parallelogram. */
final class PointInTriangleSlips {
    private PointInTriangleSlips() {}

    static List<Slip<PointInTriangle>> of(PointInTriangle right) {
        return List.of(
                each("one-side-unchecked", i -> by(s -> without(s, i))),
                each("one-side-is-outside", i -> by(s -> s[i] > 0 && without(s, i))),
                each("parallelogram-for-triangle", i -> by(s -> parallelogram(s, i))),
                each("one-side-checked-alone", i -> by(s -> s[i] >= 0)),
                Slip.of("any-side-will-do", by(s -> s[0] >= 0 || s[1] >= 0 || s[2] >= 0)),
                Slip.of(
                        "point-x-y-swapped",
                        (ax, ay, bx, by, cx, cy, x, y) ->
                                right.contains(ax, ay, bx, by, cx, cy, y, x)),
                Slip.of("wide-epsilon", by(s -> s[0] >= -1e-6 && s[1] >= -1e-6 && s[2] >= -1e-6)));
    }

    private interface Judge {
        /**
         * Whether the point is inside.
         *
         * @param sides of the point to the sides, each above 0 inside; their sum is the area
         */
        boolean inside(double[] sides);
    }

    private interface Form {
        PointInTriangle of(int side);
    }

    private static Slip<PointInTriangle> each(String name, Form form) {
        return new Slip<>(name, IntStream.range(0, 3).mapToObj(form::of).toList());
    }

    private static PointInTriangle by(Judge judge) {
        return (ax, ay, bx, by, cx, cy, x, y) -> {
            double area = cross(ax, ay, bx, by, cx, cy);
            double sign = area < 0 ? -1 : 1;
            return judge.inside(
                    new double[] {
                        sign * cross(ax, ay, bx, by, x, y),
                        sign * cross(bx, by, cx, cy, x, y),
                        sign * cross(cx, cy, ax, ay, x, y)
                    });
        };
    }

    private static boolean without(double[] s, int side) {
        return s[(side + 1) % 3] >= 0 && s[(side + 2) % 3] >= 0;
    }

    /** Two shares from 0 to 1 each, whatever their sum. */
    private static boolean parallelogram(double[] s, int side) {
        double area = s[0] + s[1] + s[2];
        double one = s[(side + 1) % 3];
        double other = s[(side + 2) % 3];
        return one >= 0 && other >= 0 && one <= area && other <= area;
    }

    private static double cross(double ax, double ay, double bx, double by, double x, double y) {
        return (bx - ax) * (y - ay) - (by - ay) * (x - ax);
    }
}
