package rasterlab.engine.spline.curve;

import rasterlab.contract.Curve;

/** Goes over corners that are chosen span by span, before the first of them is passed. */
abstract class CornersWalk implements CurveWalk {
    final CubicPiece cubic = new CubicPiece();
    final double left;
    private final BezierPoints points;
    private final int spans;
    private double[] corners = {};
    private int count;
    private int span = -1;
    private int at;
    private double x;
    private double y;

    CornersWalk(Curve curve, double flatness) {
        points = new BezierPoints(curve);
        spans = curve.spans();
        left = Flatness.left(curve, flatness, 1);
        WangCount.ofAll(curve, points, left);
    }

    /** Chooses u of the span's corners, from 0 to 1, and says how many chords they have. */
    abstract int chosen();

    /** The corners chosen: one more than chords, perhaps with room behind them. */
    abstract double[] corners();

    /** x of the corner at u, which is neither the first nor the last. */
    double inX(double u) {
        return cubic.x(u);
    }

    double inY(double u) {
        return cubic.y(u);
    }

    @Override
    public boolean advance() {
        if (at == count) {
            if (span == spans - 1) return false;
            nextSpan();
            if (span == 0) return true;
        }
        at++;
        boolean end = at == count;
        x = end ? points.x[3] : inX(corners[at]);
        y = end ? points.y[3] : inY(corners[at]);
        return true;
    }

    private void nextSpan() {
        span++;
        points.load(span);
        cubic.load(points);
        count = chosen();
        corners = corners();
        at = 0;
        x = points.x[0];
        y = points.y[0];
    }

    @Override
    public double x() {
        return x;
    }

    @Override
    public double y() {
        return y;
    }

    @Override
    public double t() {
        return (span + (at == count ? 1 : corners[at])) / spans;
    }

    /** How far the curve is from the chord that ends here; 0 at the start. */
    @Override
    public double decision() {
        return at == 0 ? 0 : cubic.fromChord(corners[at - 1], corners[at]);
    }
}
