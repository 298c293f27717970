package rasterlab.engine.spline.exact;

import rasterlab.engine.study.Deviation;

/**
 * How far points or a polyline are from the curve, as a multiple of what is allowed.
 *
 * <p>{@link CurveTask#allowed} says what is allowed; a polyline is off by the larger of the
 * farthest curve point from the polyline and the farthest polyline point from the curve. One that
 * does not go along the curve from its start to its end is off by {@value #OUT_OF_ORDER} times what
 * is allowed at least: its picture is right.
 */
public final class CurveComparison {
    private static final int BETWEEN = 4;
    private static final double OUT_OF_ORDER = 2;

    /**
     * The error allowed in any case: below the normal numbers rounding does not shrink with what is
     * rounded.
     */
    private static final double LEAST_ALLOWED = 8 * Double.MIN_VALUE;

    private CurveComparison() {}

    public static Deviation compare(CurveTask task, Polyline exact, Polyline actual) {
        if (task.flatness() > 0)
            return actual == exact
                    ? new Deviation(0, 0, 0, exact.size(), "")
                    : flat(task, exact, actual);
        double allowed = Math.max(task.allowed(), LEAST_ALLOWED);
        int shared = Math.min(exact.size(), actual.size());
        double worst = 0;
        String first = "";
        for (int i = 0; i < shared; i++) {
            double error = Math.hypot(exact.x(i) - actual.x(i), exact.y(i) - actual.y(i));
            if (Double.isNaN(error)) error = Double.POSITIVE_INFINITY;
            if (error > worst) {
                worst = error;
                first =
                        "at[%d]: (%s, %s) instead of (%s, %s)"
                                .formatted(i, actual.x(i), actual.y(i), exact.x(i), exact.y(i));
            }
        }
        int missing = exact.size() - shared;
        int extra = actual.size() - shared;
        double multiple = worst == 0 ? 0 : worst / allowed;
        return new Deviation(multiple, missing, extra, exact.size(), first);
    }

    private static Deviation flat(CurveTask task, Polyline exact, Polyline actual) {
        if (actual.size() < 2)
            return new Deviation(
                    Double.POSITIVE_INFINITY, 1, 0, exact.size(), "the polyline has no segment");
        double off = distance(exact, actual, 1, task.flatness());
        double back = distance(actual, exact, BETWEEN, task.flatness()) - unseen(exact);
        double worst = Math.max(off, back);
        double near = Math.max(worst, task.flatness()) + unseen(exact);
        int stray = PolylineOrder.firstOutOfOrder(exact, actual, near);
        if (stray >= 0 && worst <= OUT_OF_ORDER * task.flatness())
            return new Deviation(
                    OUT_OF_ORDER,
                    0,
                    0,
                    exact.size(),
                    "point %d, (%s, %s), is not on the way from the curve's start to its end"
                            .formatted(stray, actual.x(stray), actual.y(stray)));
        String first =
                worst == 0
                        ? ""
                        : "%s px off in %d segments, %s px are allowed"
                                .formatted(worst, actual.size() - 1, task.flatness());
        return new Deviation(worst / task.allowed(), 0, 0, exact.size(), first);
    }

    /**
     * @param steps how many places of each segment are looked at
     */
    private static double distance(Polyline from, Polyline to, int steps, double allowed) {
        var distance = new PolylineDistance(to, allowed);
        double worst = distance.add(from.x(0), from.y(0));
        for (int i = 0; i + 1 < from.size(); i++)
            for (int k = 1; k <= steps; k++) {
                double share = (double) k / steps;
                worst =
                        distance.add(
                                from.x(i) + share * (from.x(i + 1) - from.x(i)),
                                from.y(i) + share * (from.y(i + 1) - from.y(i)));
            }
        return worst;
    }

    /**
     * How far the curve is from its dense chords: about an eighth of the largest second difference.
     */
    private static double unseen(Polyline dense) {
        double largest = 0;
        for (int i = 0; i + 2 < dense.size(); i++)
            largest =
                    Math.max(
                            largest,
                            Math.hypot(
                                    dense.x(i) - 2 * dense.x(i + 1) + dense.x(i + 2),
                                    dense.y(i) - 2 * dense.y(i + 1) + dense.y(i + 2)));
        return largest / 7;
    }
}
