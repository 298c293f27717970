package rasterlab.engine.spline.curve;

import rasterlab.contract.Curve;
import rasterlab.contract.CurvePoints;

/**
 * Equal steps of u, as many as Wang's count asks, each span's points by Horner's scheme around its
 * start; degrees above 3 by de Casteljau's triangle.
 *
 * <p>The number of steps is known before the first, so there is nothing to test on the way; where
 * only a part of the span is bent, the rest gets too many. {@link WangCount} has the source.
 *
 * <p>Source: G.-Z. Wang, The subdivision method for finding the intersection between two Bézier
 * curves or surfaces, Zhejiang University Journal, 1984.
 */
public final class UniformCurve implements SteppedCurve {
    private final DeCasteljauCurve triangle = new DeCasteljauCurve();

    @Override
    public void at(Curve curve, double[] t, CurvePoints out) {
        triangle.at(curve, t, out);
    }

    @Override
    public void flatten(Curve curve, double flatness, CurvePoints out) {
        if (curve.degree() > 3) {
            triangle.flatten(curve, flatness, out);
            return;
        }
        var walk = new Walk(curve, flatness);
        while (walk.advance()) out.point(walk.x, walk.y);
    }

    @Override
    public CurveWalk walk(Curve curve, double flatness) {
        return curve.degree() > 3 ? triangle.walk(curve, flatness) : new Walk(curve, flatness);
    }

    @Override
    public String decisionFormula() {
        return triangle.decisionFormula();
    }

    private static final class Walk implements CurveWalk {
        private final BezierPoints points;
        private final double flatness;
        private final int spans;
        private int span = -1;
        private int step;
        private int last;
        private double width;
        private double x;
        private double y;
        private double ax;
        private double ay;
        private double bx;
        private double by;
        private double cx;
        private double cy;

        Walk(Curve curve, double flatness) {
            points = new BezierPoints(curve);
            this.flatness = Flatness.left(curve, flatness, 1);
            spans = curve.spans();
            if (spans > 1) WangCount.ofAll(curve, points, this.flatness);
        }

        @Override
        public boolean advance() {
            if (step == last) return nextSpan();
            step++;
            if (step == last) {
                x = points.x[3];
                y = points.y[3];
            } else {
                double u = step * width;
                x = ((ax * u + bx) * u + cx) * u + points.x[0];
                y = ((ay * u + by) * u + cy) * u + points.y[0];
            }
            return true;
        }

        /** The first span begins with its start, the others with their first step. */
        private boolean nextSpan() {
            if (span == spans - 1) return false;
            span++;
            if (span > 0) points.load(span);
            double[] px = points.x;
            double[] py = points.y;
            cx = 3 * (px[1] - px[0]);
            cy = 3 * (py[1] - py[0]);
            bx = 3 * (px[0] - 2 * px[1] + px[2]);
            by = 3 * (py[0] - 2 * py[1] + py[2]);
            ax = px[3] - px[0] - 3 * (px[2] - px[1]);
            ay = py[3] - py[0] - 3 * (py[2] - py[1]);
            step = 0;
            last = WangCount.of(points, flatness);
            width = 1.0 / last;
            if (span > 0) return advance();
            x = px[0];
            y = py[0];
            return true;
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
            return (span + (double) step / last) / spans;
        }

        @Override
        public double decision() {
            return last;
        }
    }
}
