package rasterlab.exercises.drawing;

import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import rasterlab.exercises.drawing.PlaneFigure.FigureKind;

/**
 * The part of the plane that a picture shows.
 *
 * @param sameScale whether a unit is as long in x as in y
 */
record PlaneBox(AxisRange x, AxisRange y, boolean sameScale) {
    /** Boxes that are thinner get a scale of its own for each axis. */
    private static final double THINNEST = 1 / 20.0;

    /** The shorter side of a box with one scale over its longer one, at least. */
    private static final double SHORTEST_SIDE = 0.35;

    /** How much farther than its figures a box reaches, on each side, as a share. */
    private static final double MARGIN = 0.07;

    /** The box of figures whose coordinates are all equal, or of none. */
    private static final List<CasePoint> ORIGIN = List.of(new CasePoint(0, 0));

    /**
     * The box around the window and what is expected, or, without a window, around what is given
     * and expected. For all other figures it grows by its own size at most: one far away does not
     * make the rest a dot.
     */
    static PlaneBox around(
            List<PlaneFigure> given, List<PlaneFigure> expected, List<PlaneFigure> actual) {
        boolean window = given.stream().anyMatch(PlaneBox::isWindow);
        List<CasePoint> all = finite(Stream.of(given, expected, actual).flatMap(List::stream));
        List<CasePoint> focus =
                finite(
                        Stream.concat(
                                given.stream().filter(each -> !window || isWindow(each)),
                                expected.stream()));
        if (all.isEmpty()) return of(ORIGIN, ORIGIN);
        return focus.stream().distinct().count() < 2 ? of(all, all) : of(focus, all);
    }

    private static PlaneBox of(List<CasePoint> focus, List<CasePoint> all) {
        double[] x = limits(focus, CasePoint::x);
        double[] y = limits(focus, CasePoint::y);
        double most = Math.max(half(x), half(y));
        boolean thin = isThin(half(x), half(y));
        grow(x, limits(all, CasePoint::x), thin ? half(x) : most);
        grow(y, limits(all, CasePoint::y), thin ? half(y) : most);
        if (isThin(half(x), half(y)))
            return new PlaneBox(range(x, half(x)), range(y, half(y)), false);
        double longest = Math.max(half(x), half(y));
        double shortest =
                longest > 0
                        ? longest * SHORTEST_SIDE
                        : Math.max(AxisRange.reachAround(x[0]), AxisRange.reachAround(y[0]));
        AxisRange wide = range(x, Math.max(half(x), shortest));
        AxisRange high = range(y, Math.max(half(y), shortest));
        return new PlaneBox(wide, high, !isThin(wide.half(), high.half()));
    }

    private static AxisRange range(double[] limits, double half) {
        return AxisRange.around(limits[0], limits[1], half * (1 + 2 * MARGIN));
    }

    /** Whether a point lies in the box, its border included. */
    boolean contains(CasePoint point) {
        return x.contains(point.x()) && y.contains(point.y());
    }

    private static boolean isThin(double half, double other) {
        double shorter = Math.min(half, other);
        return shorter > 0 && shorter < Math.max(half, other) * THINNEST;
    }

    private static void grow(double[] limits, double[] all, double half) {
        limits[0] = Math.max(all[0], limits[0] - half - half);
        limits[1] = Math.min(all[1], limits[1] + half + half);
    }

    private static double half(double[] limits) {
        return limits[1] / 2 - limits[0] / 2;
    }

    private static double[] limits(List<CasePoint> points, ToDoubleFunction<CasePoint> axis) {
        return AxisRange.limits(points.stream().mapToDouble(axis));
    }

    private static List<CasePoint> finite(Stream<PlaneFigure> figures) {
        return figures.flatMap(each -> each.points().stream()).filter(CasePoint::isFinite).toList();
    }

    private static boolean isWindow(PlaneFigure figure) {
        return figure.form() == FigureKind.WINDOW;
    }
}
