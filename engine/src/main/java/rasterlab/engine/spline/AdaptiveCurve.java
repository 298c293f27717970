package rasterlab.engine.spline;

import rasterlab.contract.Curve;
import rasterlab.contract.CurvePoints;

/**
 * Halving until every piece is flat: short chords where the curve bends, long ones where it does
 * not.
 *
 * <p>A cubic's second derivative is linear, so over a step h the largest is at an end, and the
 * chord lies within {@code h²·max(|B″(u)|, |B″(u + h)|) / 8} of the curve, point for point. A chord
 * that an S-curve crosses, a loop that comes back to its start, a cusp or control points on one
 * line cannot look flat to this bound. The middle is {@code (P(u) + P(u + h))/2 − h²·(B″(u) + B″(u
 * + h))/16}, the second derivative there the mean of those at the ends: halving takes no control
 * points at all. Pieces yet to come wait on a stack as deep as there are halvings. Degrees above 3
 * are halved by {@link HalvingWalk}.
 *
 * <p>Source: the bound is {@link WangCount}'s for one piece; halving by second derivatives: J.
 * Clark, Some properties of B-splines, 1981 (central differencing).
 */
public final class AdaptiveCurve implements SteppedCurve {
    private final DeCasteljauCurve triangle = new DeCasteljauCurve();

    @Override
    public void at(Curve curve, double[] t, CurvePoints out) {
        triangle.at(curve, t, out);
    }

    @Override
    public void flatten(Curve curve, double flatness, CurvePoints out) {
        if (curve.degree() > 3) {
            walk(curve, flatness).drain(out);
            return;
        }
        var walk = new Walk(curve, flatness);
        while (walk.advance()) out.point(walk.x, walk.y);
    }

    @Override
    public CurveWalk walk(Curve curve, double flatness) {
        if (curve.degree() <= 3) return new Walk(curve, flatness);
        return new HalvingWalk(curve, flatness, AdaptiveCurve::bound);
    }

    /** Wang's bound for one step over the whole piece. */
    private static double bound(BezierPoints piece) {
        double d = piece.degree();
        return d * (d - 1) / 8 * piece.bend();
    }

    @Override
    public String decisionFormula() {
        return "bound = h²·max(|B″(u)|, |B″(u + h)|) / 8 in pixels; the piece is halved where it is"
                + " above the flatness";
    }

    private static final class Walk implements CurveWalk {
        /** Wang's count is below 2²⁴ steps, and a power of two reaches it. */
        private static final int DEEPEST = 26;

        private final BezierPoints points;
        private final int spans;
        private final double enough;
        private final double[] endX = new double[DEEPEST];
        private final double[] endY = new double[DEEPEST];
        private final double[] endBendX = new double[DEEPEST];
        private final double[] endBendY = new double[DEEPEST];
        private final double[] endWidth = new double[DEEPEST];
        private double x;
        private double y;
        private double bendX;
        private double bendY;
        private double u = 1;
        private double decision;
        private int span = -1;
        private int top = -1;
        private long splits;

        Walk(Curve curve, double flatness) {
            points = new BezierPoints(curve);
            double left = Flatness.left(curve, flatness, 1);
            WangCount.ofAll(curve, points, left);
            enough = 64 * left * left;
            spans = curve.spans();
        }

        @Override
        public boolean advance() {
            if (top < 0) {
                if (span == spans - 1) return false;
                nextSpan();
                if (span == 0) return true;
            }
            while (true) {
                double width = endWidth[top];
                double here = bendX * bendX + bendY * bendY;
                double there = endBendX[top] * endBendX[top] + endBendY[top] * endBendY[top];
                double square = Math.max(here, there) * (width * width) * (width * width);
                if (square <= enough) {
                    decision = square;
                    moveTo(top--, width);
                    return true;
                }
                split(width);
            }
        }

        private void moveTo(int end, double width) {
            x = endX[end];
            y = endY[end];
            bendX = endBendX[end];
            bendY = endBendY[end];
            u += width;
        }

        private void split(double width) {
            int end = top++;
            double sixteenth = width * width / 16;
            double middleX = bendX + endBendX[end];
            double middleY = bendY + endBendY[end];
            endX[top] = 0.5 * (x + endX[end]) - sixteenth * middleX;
            endY[top] = 0.5 * (y + endY[end]) - sixteenth * middleY;
            endBendX[top] = 0.5 * middleX;
            endBendY[top] = 0.5 * middleY;
            endWidth[end] = 0.5 * width;
            endWidth[top] = 0.5 * width;
            splits++;
        }

        private void nextSpan() {
            span++;
            points.load(span);
            double[] px = points.x;
            double[] py = points.y;
            x = px[0];
            y = py[0];
            u = 0;
            bendX = 6 * (px[0] - 2 * px[1] + px[2]);
            bendY = 6 * (py[0] - 2 * py[1] + py[2]);
            top = 0;
            endX[0] = px[3];
            endY[0] = py[3];
            endBendX[0] = 6 * (px[1] - 2 * px[2] + px[3]);
            endBendY[0] = 6 * (py[1] - 2 * py[2] + py[3]);
            endWidth[0] = 1;
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
            return (span + u) / spans;
        }

        /** The bound of the piece that ends here, in pixels; 0 at the start. */
        @Override
        public double decision() {
            return Math.sqrt(decision) / 8;
        }

        @Override
        public long splits() {
            return splits;
        }
    }
}
