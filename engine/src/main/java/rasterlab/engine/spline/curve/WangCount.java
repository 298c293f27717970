package rasterlab.engine.spline.curve;

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
     * The number of segments, at least 1.
     *
     * @param flatness pixels, above 0
     * @throws IllegalArgumentException if it is above {@value Flatness#MOST_SEGMENTS}
     */
    static int of(BezierPoints points, double flatness) {
        double d = points.degree();
        double steps = Math.ceil(Math.sqrt(d * (d - 1) / 8 * points.bend() / flatness));
        if (steps > Flatness.MOST_SEGMENTS) throw tooMany(flatness, steps);
        return steps < 1 ? 1 : (int) steps;
    }

    /**
     * The largest number of steps of a span.
     *
     * @param points of the curve; the first span again when this returns
     * @throws IllegalArgumentException if all spans together take too many
     */
    static int largest(Curve curve, BezierPoints points, double flatness) {
        if (curve.spans() == 1) return of(points, flatness);
        int largest = 0;
        for (int steps : ofAll(curve, points, flatness)) largest = Math.max(largest, steps);
        return largest;
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
        if (sum > Flatness.MOST_SEGMENTS) throw tooMany(flatness, sum);
        return steps;
    }

    private static IllegalArgumentException tooMany(double flatness, double segments) {
        return new IllegalArgumentException(
                "flatness: %s takes %.0f segments, at most %d are allowed"
                        .formatted(flatness, segments, Flatness.MOST_SEGMENTS));
    }
}
