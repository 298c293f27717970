package rasterlab.engine.spline.curve;

import rasterlab.contract.Curve;

/**
 * The blending functions as printed, kept to be looked at beside the right ones.
 *
 * <p>Hermite's are right. Bézier's first is printed as 1 − t³ for (1 − t)³: the weights then add up
 * to more than 1 between the ends, and the curve leaves its hull away from the origin. There are
 * formulas for cubics in these two forms only.
 *
 * <p>Source: A. V. Kazantsev, Foundations of computer graphics for programmers, Kazan, 2005, ch. 8.
 */
public final class BlendingTextbookCurve extends EvaluatedCurve {
    @Override
    CurveSpan span(Curve curve, int index) {
        boolean hermite = curve.kind() == Curve.Kind.HERMITE;
        boolean bezier = curve.kind() == Curve.Kind.BEZIER && curve.degree() == 3;
        if (!hermite && !bezier)
            throw new IllegalArgumentException(
                    "kind must be hermite, or bezier with 4 points; got %s with %d"
                            .formatted(curve.kind().code(), curve.x().length));
        return (t, point) -> {
            double[] weights = hermite ? hermite(t) : bezier(t);
            point[0] = mean(weights, curve.x());
            point[1] = mean(weights, curve.y());
        };
    }

    private static double[] hermite(double t) {
        double square = t * t;
        double cube = square * t;
        return new double[] {
            2 * cube - 3 * square + 1, 3 * square - 2 * cube, cube - 2 * square + t, cube - square
        };
    }

    private static double[] bezier(double t) {
        double square = t * t;
        double cube = square * t;
        return new double[] {1 - cube, 3 * t * (t - 1) * (t - 1), 3 * square * (1 - t), cube};
    }

    private static double mean(double[] weights, double[] points) {
        double sum = 0;
        for (int i = 0; i < weights.length; i++) sum += weights[i] * points[i];
        return sum;
    }
}
