package rasterlab.engine.spline;

import rasterlab.contract.Curve;

/**
 * How many equal steps of u make a span flat: {@code n = ⌈√(d·(d − 1)·|Δ²|/(8·flatness))⌉} for
 * degree d and the largest second difference Δ² of the Bézier points.
 *
 * <p>d·(d − 1)·|Δ²| bounds the second derivative, and a chord over a step h lies within h²/8 times
 * that of the curve, point for point, so neither cusps nor turns can hide from it.
 *
 * <p>Source: G.-Z. Wang, The subdivision method for finding the intersection between two Bézier
 * curves or surfaces, Zhejiang University Journal, 1984.
 */
final class WangCount {
    private WangCount() {}

    /**
     * At least 1.
     *
     * @param flatness pixels, above 0
     */
    static int of(BezierPoints points, double flatness) {
        double d = points.degree();
        double steps = Math.ceil(Math.sqrt(d * (d - 1) / 8 * points.bend() / flatness));
        return (int) Math.min(Math.max(1, steps), Integer.MAX_VALUE);
    }

    /**
     * The steps of each span.
     *
     * @throws IllegalArgumentException if all spans together take too many
     */
    static int[] ofAll(Curve curve, BezierPoints points, double flatness) {
        var steps = new int[curve.spans()];
        long sum = 0;
        for (int i = 0; i < steps.length; i++) {
            points.load(i);
            steps[i] = of(points, flatness);
            sum += steps[i];
        }
        points.load(0);
        if (sum > Flatness.MOST_SEGMENTS)
            throw new IllegalArgumentException(
                    "flatness: %s takes %d segments, at most %d are allowed"
                            .formatted(flatness, sum, Flatness.MOST_SEGMENTS));
        return steps;
    }
}
