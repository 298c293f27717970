package rasterlab.engine.spline.function;

import rasterlab.contract.SplineEnds;

/** The slopes that {@link MonotoneSpline} starts from: 0 at local extremes, else of parabolas. */
final class FirstSlopes {
    private FirstSlopes() {}

    static double[] of(Knots knots, SplineEnds ends) {
        int m = knots.pieces;
        double[] secant = knots.secant;
        var slopes = new double[m + 1];
        for (int i = 1; i < m; i++)
            slopes[i] =
                    between(secant[i - 1], secant[i], knots.shareAfter(i), knots.shareBefore(i));
        double left = end(ends.kind(), ends.left(), knots, 0, 1, slopes);
        double right = end(ends.kind(), ends.right(), knots, m - 1, -1, slopes);
        if (ends.kind() == SplineEnds.Kind.PERIODIC) {
            double after = knots.width[0] / (knots.width[0] + knots.width[m - 1]);
            left = between(secant[m - 1], secant[0], after, 1 - after);
            right = left;
        }
        slopes[0] = left;
        slopes[m] = right;
        return slopes;
    }

    private static double between(double before, double after, double share, double rest) {
        boolean oneSign = Math.signum(before) * Math.signum(after) > 0;
        return oneSign ? share * before + rest * after : 0;
    }

    /**
     * @param piece the first or the last
     * @param inward 1 at the first knot, −1 at the last
     */
    private static double end(
            SplineEnds.Kind kind,
            double given,
            Knots knots,
            int piece,
            int inward,
            double[] slopes) {
        double secant = knots.secant[piece];
        if (kind == SplineEnds.Kind.SLOPES) return sameWay(given, secant);
        if (knots.pieces == 1) return secant;
        if (kind == SplineEnds.Kind.NATURAL) {
            int neighbour = inward > 0 ? 1 : knots.pieces - 1;
            return sameWay((3 * secant - slopes[neighbour]) / 2, secant);
        }
        double outer = knots.width[piece];
        double share = outer / (outer + knots.width[piece + inward]);
        return sameWay(secant + share * (secant - knots.secant[piece + inward]), secant);
    }

    /** The slope where it leads the way of the secant, otherwise 0. */
    private static double sameWay(double slope, double secant) {
        return Math.signum(slope) * Math.signum(secant) > 0 ? slope : 0;
    }
}
