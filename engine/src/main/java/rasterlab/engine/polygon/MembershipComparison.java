package rasterlab.engine.polygon;

import rasterlab.engine.study.Deviation;

/**
 * How far misjudged points lie from the boundary that they were put on the wrong side of.
 *
 * <p>The unit is one ulp of the largest coordinate of polygon and point, the smallest step that
 * their doubles can tell: by how many such steps the point would have to be moved for the answer to
 * be right, at least 1.
 */
public final class MembershipComparison {
    private static final double ULP_BELOW_TWO = 0x1p-52;

    private MembershipComparison() {}

    /** The points judged inside but not exactly so are extra, the others missing. */
    public static Deviation compare(ShapeAndPoints input, Membership exact, Membership actual) {
        double worst = 0;
        long missing = 0;
        long extra = 0;
        String first = "";
        for (int i = 0; i < exact.size(); i++) {
            if (i < actual.size() && exact.inside(i) == actual.inside(i)) continue;
            if (exact.inside(i)) missing++;
            else extra++;
            double ulps = ulps(input, i);
            worst = Math.max(worst, ulps);
            if (first.isEmpty()) first = difference(input.points(), i, exact.inside(i), ulps);
        }
        return new Deviation(worst, missing, extra, exact.size(), first);
    }

    private static String difference(Points points, int i, boolean inside, double ulps) {
        return "point %d (%s, %s) is %s but judged %s, %.4g ulps from the boundary"
                .formatted(
                        i,
                        points.x(i),
                        points.y(i),
                        inside ? "inside" : "outside",
                        inside ? "outside" : "inside",
                        ulps);
    }

    private static double ulps(ShapeAndPoints input, int point) {
        double px = input.points().x(point);
        double py = input.points().y(point);
        double largest = Math.max(Math.abs(px), Math.abs(py));
        Points corners = input.corners();
        for (int i = 0; i < corners.size(); i++)
            largest = Math.max(largest, Math.max(Math.abs(corners.x(i)), Math.abs(corners.y(i))));
        if (largest == 0) return 1;
        // The scale brings all numbers near 1, so that neither a difference nor a square overflows.
        int exponent = Math.getExponent(largest);
        double x = near1(px, exponent);
        double y = near1(py, exponent);
        double least = Double.MAX_VALUE;
        for (int i = 0; i < corners.size(); i++) {
            int j = (i + 1) % corners.size();
            double ax = near1(corners.x(i), exponent) - x;
            double ay = near1(corners.y(i), exponent) - y;
            double bx = near1(corners.x(j), exponent) - x;
            double by = near1(corners.y(j), exponent) - y;
            least = Math.min(least, fromOrigin(ax, ay, bx - ax, by - ay));
        }
        return Math.max(1, Math.ceil(least / ULP_BELOW_TWO));
    }

    /** The coordinate at a scale where the largest lies in [1, 2). */
    private static double near1(double value, int exponent) {
        return Math.scalb(value, -exponent);
    }

    /** Distance from the origin to the segment that starts at a and goes on by d. */
    private static double fromOrigin(double ax, double ay, double dx, double dy) {
        double square = dx * dx + dy * dy;
        double along = square == 0 ? 0 : -(ax * dx + ay * dy) / square;
        double mu = Math.min(1, Math.max(0, along));
        return Math.hypot(ax + mu * dx, ay + mu * dy);
    }
}
