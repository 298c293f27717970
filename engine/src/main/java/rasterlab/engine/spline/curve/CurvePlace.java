package rasterlab.engine.spline.curve;

import rasterlab.contract.Curve;
import rasterlab.engine.range.Bounds;

/**
 * Where a curve is, how fast it goes there and how it bends, by u along one span.
 *
 * <p>From the last rows of de Casteljau's triangle, n being the degree: {@code P′ = n·(b₁ − b₀)} of
 * the row of two, {@code P″ = n·(n − 1)·(b₂ − 2·b₁ + b₀)} of the row of three points.
 *
 * @param span from 0
 * @param u in [0, 1]
 * @param x pixels
 * @param y pixels, grows down
 * @param dx pixels per unit of u
 * @param dy pixels per unit of u
 * @param ddx pixels per unit of u, squared
 * @param ddy pixels per unit of u, squared
 */
public record CurvePlace(
        int span, double u, double x, double y, double dx, double dy, double ddx, double ddy) {
    public CurvePlace {
        Bounds.requireAtLeast("span", span, 0);
        Bounds.require("u", u, 0, 1);
    }

    /**
     * @param t in [0, 1], over all spans
     */
    public static CurvePlace at(Curve curve, double t) {
        CurveSpans.requireInside(t);
        return of(curve, CurveSpans.span(curve, t), CurveSpans.local(curve, t));
    }

    /**
     * The place on one span, which at a joint tells its end from the next one's start.
     *
     * @throws IllegalArgumentException if there is no such span or u is outside [0, 1]
     */
    public static CurvePlace of(Curve curve, int span, double u) {
        if (span < 0 || span >= curve.spans())
            throw new IllegalArgumentException(
                    "span must be from 0 to %d, got %d".formatted(curve.spans() - 1, span));
        if (!(u >= 0 && u <= 1))
            throw new IllegalArgumentException("u must be from 0 to 1, got " + u);
        var points = new BezierPoints(curve);
        points.load(span);
        double[] x = derivatives(points.x, u);
        double[] y = derivatives(points.y, u);
        return new CurvePlace(span, u, x[0], y[0], x[1], y[1], x[2], y[2]);
    }

    /** Value, first and second derivative; overwrites {@code b}. */
    private static double[] derivatives(double[] b, double u) {
        int n = b.length - 1;
        double first = 0;
        double second = 0;
        for (int row = n; row > 0; row--) {
            if (row == 2) second = n * (n - 1.0) * (b[2] - 2 * b[1] + b[0]);
            if (row == 1) first = n * (b[1] - b[0]);
            for (int i = 0; i < row; i++) b[i] = (1 - u) * b[i] + u * b[i + 1];
        }
        return new double[] {b[0], first, second};
    }

    /** Length of the derivative, in pixels per unit of u; 0 at a cusp. */
    public double speed() {
        return Math.hypot(dx, dy);
    }

    /**
     * κ = (x′·y″ − y′·x″) / |P′|³ in 1/pixels, above 0 where the curve turns from x to y: clockwise
     * on a raster. Not a number where the curve stands still.
     */
    public double curvature() {
        double speed = speed();
        return (dx / speed * (ddy / speed) - dy / speed * (ddx / speed)) / speed;
    }
}
