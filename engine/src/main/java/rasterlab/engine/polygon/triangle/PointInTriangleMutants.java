package rasterlab.engine.polygon.triangle;

import java.util.List;
import java.util.stream.Stream;
import rasterlab.contract.PointInTriangle;
import rasterlab.engine.study.Mutant;

/** Points judged by a triangle with one mistake. */
final class PointInTriangleMutants {
    private static final PointInTriangle RIGHT = new RobustTriangle();
    private static final double EPSILON = 1e-9;

    private PointInTriangleMutants() {}

    static List<Mutant<PointInTriangle>> all() {
        return Stream.concat(ofSides().stream(), ofNumbersAndShapes().stream()).toList();
    }

    private static List<Mutant<PointInTriangle>> ofSides() {
        return List.of(
                new Mutant<>(
                        "side-is-outside",
                        "boundary-other-way-round",
                        bySides((a, b, c) -> a > 0 && b > 0 && c > 0 || a < 0 && b < 0 && c < 0)),
                new Mutant<>(
                        "counter-clockwise-only",
                        "boundary-one-way-round",
                        unlessFlat(bySides((a, b, c) -> a >= 0 && b >= 0 && c >= 0))),
                new Mutant<>(
                        "clockwise-only",
                        "boundary-other-way-round",
                        unlessFlat(bySides((a, b, c) -> a <= 0 && b <= 0 && c <= 0))),
                new Mutant<>(
                        "absolute-epsilon",
                        "smaller-than-any-epsilon",
                        unlessFlat(
                                bySides(
                                        (a, b, c) ->
                                                a > -EPSILON && b > -EPSILON && c > -EPSILON
                                                        || a < EPSILON
                                                                && b < EPSILON
                                                                && c < EPSILON))),
                new Mutant<>(
                        "flat-is-whole-line",
                        "corners-on-one-line",
                        bySides(
                                (a, b, c) ->
                                        a >= 0 && b >= 0 && c >= 0 || a <= 0 && b <= 0 && c <= 0)));
    }

    private static List<Mutant<PointInTriangle>> ofNumbersAndShapes() {
        return List.of(
                new Mutant<>(
                        "products-in-int", "past-2-15", unlessFlat(PointInTriangleMutants::inInt)),
                new Mutant<>(
                        "coordinates-in-float",
                        "small-and-far-away",
                        (ax, ay, bx, by, cx, cy, x, y) ->
                                RIGHT.contains(
                                        (float) ax,
                                        (float) ay,
                                        (float) bx,
                                        (float) by,
                                        (float) cx,
                                        (float) cy,
                                        (float) x,
                                        (float) y)),
                new Mutant<>(
                        "box-for-triangle",
                        "two-steps-from-the-sides",
                        PointInTriangleMutants::box),
                new Mutant<>(
                        "flat-holds-nothing",
                        "corners-on-one-line",
                        (ax, ay, bx, by, cx, cy, x, y) ->
                                cross(ax, ay, bx, by, cx, cy) != 0
                                        && RIGHT.contains(ax, ay, bx, by, cx, cy, x, y)),
                new Mutant<>(
                        "third-side-unchecked",
                        "well-inside-and-outside",
                        unlessFlat(bySides((a, b, c) -> a >= 0 && b >= 0 || a <= 0 && b <= 0))),
                new Mutant<>(
                        "vertex-is-outside",
                        "boundary-other-way-round",
                        (ax, ay, bx, by, cx, cy, x, y) ->
                                !(x == ax && y == ay || x == bx && y == by || x == cx && y == cy)
                                        && RIGHT.contains(ax, ay, bx, by, cx, cy, x, y)));
    }

    /**
     * Judges right on a triangle without area: that all its line is inside is a mistake of its own.
     */
    private static PointInTriangle unlessFlat(PointInTriangle mistaken) {
        return (ax, ay, bx, by, cx, cy, x, y) ->
                (cross(ax, ay, bx, by, cx, cy) == 0 ? RIGHT : mistaken)
                        .contains(ax, ay, bx, by, cx, cy, x, y);
    }

    private interface Sides {
        boolean inside(double a, double b, double c);
    }

    private static PointInTriangle bySides(Sides sides) {
        return (ax, ay, bx, by, cx, cy, x, y) ->
                sides.inside(
                        cross(ax, ay, bx, by, x, y),
                        cross(bx, by, cx, cy, x, y),
                        cross(cx, cy, ax, ay, x, y));
    }

    private static double cross(double ax, double ay, double bx, double by, double x, double y) {
        return (bx - ax) * (y - ay) - (by - ay) * (x - ax);
    }

    private static boolean inInt(
            double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
        if (ax != (int) ax || x != (int) x) return RIGHT.contains(ax, ay, bx, by, cx, cy, x, y);
        int a = intCross((int) ax, (int) ay, (int) bx, (int) by, (int) x, (int) y);
        int b = intCross((int) bx, (int) by, (int) cx, (int) cy, (int) x, (int) y);
        int c = intCross((int) cx, (int) cy, (int) ax, (int) ay, (int) x, (int) y);
        return a >= 0 && b >= 0 && c >= 0 || a <= 0 && b <= 0 && c <= 0;
    }

    private static int intCross(int ax, int ay, int bx, int by, int x, int y) {
        return (bx - ax) * (y - ay) - (by - ay) * (x - ax);
    }

    private static boolean box(
            double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
        return x >= Math.min(ax, Math.min(bx, cx))
                && x <= Math.max(ax, Math.max(bx, cx))
                && y >= Math.min(ay, Math.min(by, cy))
                && y <= Math.max(ay, Math.max(by, cy));
    }
}
