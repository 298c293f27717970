package rasterlab.engine.spline.curve;

import rasterlab.contract.Curve;
import rasterlab.contract.CurvePoints;

/**
 * Halving until every piece is flat: short chords where the curve bends, long ones where it does
 * not.
 *
 * <p>A cubic's second derivative is linear, so over a step h the largest is at an end, and the
 * chord lies within {@code h²·max(|B″(u)|, |B″(u + h)|) / 8} of the curve, point for point. A chord
 * that an S-curve crosses, a loop that comes back to its start, a cusp or control points on one
 * line cannot look flat to this bound, and it ends the halving. Where it is not small enough yet,
 * {@link ChordDistance} measures across the chord alone, which saves a third of the segments. The
 * middle is {@code (P(u) + P(u + h))/2 − h²·(B″(u) + B″(u + h))/16}, the second derivative there
 * the mean of those at the ends: halving takes no control points at all. Pieces yet to come wait on
 * a stack as deep as there are halvings. Degrees above 3 are halved by {@link HalvingWalk}.
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
        return "bound = h²·max(|B″(u)|, |B″(u + h)|) / 8 in pixels, or the largest distance across the"
                + " chord; the piece is halved where both are above the flatness";
    }

    private static final class Walk implements CurveWalk {
        /** Places of a waiting piece's numbers: its end, B″ there, |B″|² there, its width h. */
        private static final int END_X = 0;

        private static final int END_Y = 1;
        private static final int BEND_X = 2;
        private static final int BEND_Y = 3;
        private static final int BEND = 4;
        private static final int WIDTH = 5;
        private static final int NUMBERS = 6;

        private final BezierPoints points;
        private final int spans;
        private final double left;
        private final double enough;
        private final double[] waiting;
        private int top = -NUMBERS;
        private double x;
        private double y;
        private double bendX;
        private double bendY;
        private double bend;
        private double u = 1;
        private double decision;
        private int span = -1;
        private long splits;

        Walk(Curve curve, double flatness) {
            points = new BezierPoints(curve);
            spans = curve.spans();
            left = Flatness.left(curve, flatness, 1);
            enough = 64 * left * left;
            int steps = WangCount.largest(curve, points, left);
            int halvings = 32 - Integer.numberOfLeadingZeros(steps);
            waiting = new double[NUMBERS * (halvings + 2)];
        }

        @Override
        public boolean advance() {
            if (top < 0) {
                if (span == spans - 1) return false;
                nextSpan();
                if (span == 0) return true;
            }
            while (true) {
                double square = waiting[top + WIDTH] * waiting[top + WIDTH];
                double there = waiting[top + BEND];
                double bound = (bend > there ? bend : there) * square * square;
                decision = bound <= enough ? Math.sqrt(bound) / 8 : across(square);
                if (bound <= enough || decision <= left) {
                    pass();
                    return true;
                }
                split(square / 16);
            }
        }

        private double across(double square) {
            return ChordDistance.of(
                    waiting[top + END_X] - x,
                    waiting[top + END_Y] - y,
                    bendX,
                    bendY,
                    waiting[top + BEND_X],
                    waiting[top + BEND_Y],
                    square);
        }

        private void pass() {
            x = waiting[top + END_X];
            y = waiting[top + END_Y];
            bendX = waiting[top + BEND_X];
            bendY = waiting[top + BEND_Y];
            bend = waiting[top + BEND];
            u += waiting[top + WIDTH];
            top -= NUMBERS;
        }

        private void split(double sixteenth) {
            int end = top;
            double sumX = bendX + waiting[end + BEND_X];
            double sumY = bendY + waiting[end + BEND_Y];
            double half = 0.5 * waiting[end + WIDTH];
            waiting[end + WIDTH] = half;
            top += NUMBERS;
            put(
                    0.5 * (x + waiting[end + END_X]) - sixteenth * sumX,
                    0.5 * (y + waiting[end + END_Y]) - sixteenth * sumY,
                    0.5 * sumX,
                    0.5 * sumY,
                    half);
            splits++;
        }

        private void put(double endX, double endY, double endBendX, double endBendY, double width) {
            waiting[top + END_X] = endX;
            waiting[top + END_Y] = endY;
            waiting[top + BEND_X] = endBendX;
            waiting[top + BEND_Y] = endBendY;
            waiting[top + BEND] = endBendX * endBendX + endBendY * endBendY;
            waiting[top + WIDTH] = width;
        }

        private void nextSpan() {
            span++;
            if (span > 0) points.load(span);
            double[] px = points.x;
            double[] py = points.y;
            x = px[0];
            y = py[0];
            u = 0;
            bendX = 6 * (px[0] - 2 * px[1] + px[2]);
            bendY = 6 * (py[0] - 2 * py[1] + py[2]);
            bend = bendX * bendX + bendY * bendY;
            top = 0;
            double endBendX = 6 * (px[1] - 2 * px[2] + px[3]);
            double endBendY = 6 * (py[1] - 2 * py[2] + py[3]);
            put(px[3], py[3], endBendX, endBendY, 1);
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

        /**
         * The distance by which the piece that ends here was called flat, in pixels; 0 at the
         * start.
         */
        @Override
        public double decision() {
            return decision;
        }

        @Override
        public long splits() {
            return splits;
        }
    }
}
