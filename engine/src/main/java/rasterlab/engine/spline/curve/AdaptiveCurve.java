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
 * {@link ChordDistance} measures across the chord alone, which saves a third of the segments; the
 * inner Bézier points' distances, of which the piece's is at most ¾, or 4⁄9 where they lie on both
 * sides, and that of its middle mostly decide before it has to. A piece whose inner points are near
 * the chord, wherever they lie along it, is flat too: so whatever the usual test of those points
 * calls flat is flat here, and there are never more pieces than Java2D's {@code
 * FlatteningPathIterator} makes. The fewest chords there can be are about two thirds of them, see
 * {@link FewestCurve}. The middle is {@code (P(u) + P(u + h))/2 − h²·(B″(u) + B″(u + h))/16}, the
 * second derivative there the mean of those at the ends: halving takes no control points at all.
 * Pieces yet to come wait on a stack as deep as there are halvings. Degrees above 3 are halved by
 * {@link HalvingWalk}.
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

        /** The squares of ¾ and 4⁄9: a piece's distance beside its inner points' larger one. */
        private static final double SAME_SIDE = 0.5625;

        private static final double BOTH_SIDES = 16.0 / 81;

        /** Products of four lengths between these lose nothing to the range of doubles. */
        private static final double SMALLEST_SQUARE = 1e-260;

        private static final double LARGEST_SQUARE = 1e260;

        /** 18⁄16, the share of the middle: a sixteenth of h² times the sum of both ends' B″. */
        private static final double MIDDLE = 1.125;

        private final BezierPoints points;
        private final int spans;
        private final double left;
        private final double leftSquare;
        private final double enough;
        private final double[] waiting;
        private int top = -NUMBERS;
        private double x;
        private double y;
        private double bendX;
        private double bendY;
        private double bend;
        private double u = 1;

        /** Where the piece passed last began, and how long it was. */
        private double startX;

        private double startY;
        private double startBendX;
        private double startBendY;
        private double width;
        private int span = -1;
        private long splits;

        Walk(Curve curve, double flatness) {
            points = new BezierPoints(curve);
            spans = curve.spans();
            left = Flatness.left(curve, flatness, 1);
            leftSquare = left * left;
            enough = 64 * leftSquare;
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
                if (flat(square)) {
                    pass();
                    return true;
                }
                split(square / 16);
            }
        }

        private boolean flat(double square) {
            double there = waiting[top + BEND];
            double bound = (bend > there ? bend : there) * square * square;
            if (bound <= enough) return true;
            double chordX = waiting[top + END_X] - x;
            double chordY = waiting[top + END_Y] - y;
            double endBendX = waiting[top + BEND_X];
            double endBendY = waiting[top + BEND_Y];
            double part = square / 18;
            double length = chordX * chordX + chordY * chordY;
            double along = part * (chordX * bendX + chordY * bendY);
            double endAlong = part * (chordX * endBendX + chordY * endBendY);
            double first = length / 3 - (2 * along + endAlong);
            double second = 2 * length / 3 - (along + 2 * endAlong);
            if (!(length > 0 && first >= 0 && first <= length && second >= 0 && second <= length))
                return ChordDistance.ofHull(
                                chordX, chordY, bendX, bendY, endBendX, endBendY, square)
                        <= left;
            double across = part * (chordX * bendY - chordY * bendX);
            double endAcross = part * (chordX * endBendY - chordY * endBendX);
            double most = leftSquare * length;
            if (!(most > SMALLEST_SQUARE && most < LARGEST_SQUARE))
                return ChordDistance.of(chordX, chordY, bendX, bendY, endBendX, endBendY, square)
                        <= left;
            double one = 2 * across + endAcross;
            double other = across + 2 * endAcross;
            double farther = Math.max(one * one, other * other);
            if (farther * (one * other >= 0 ? SAME_SIDE : BOTH_SIDES) <= most) return true;
            double middle = MIDDLE * (across + endAcross);
            if (middle * middle > most) return false;
            return ChordDistance.of(chordX, chordY, bendX, bendY, endBendX, endBendY, square)
                    <= left;
        }

        private void pass() {
            startX = x;
            startY = y;
            startBendX = bendX;
            startBendY = bendY;
            width = waiting[top + WIDTH];
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
            double square = width * width;
            double one = startBendX * startBendX + startBendY * startBendY;
            double bound = Math.max(one, bend) * square * square;
            if (bound <= enough) return Math.sqrt(bound) / 8;
            double chordX = x - startX;
            double chordY = y - startY;
            double across =
                    ChordDistance.of(chordX, chordY, startBendX, startBendY, bendX, bendY, square);
            return across < Double.POSITIVE_INFINITY
                    ? across
                    : ChordDistance.ofHull(
                            chordX, chordY, startBendX, startBendY, bendX, bendY, square);
        }

        @Override
        public long splits() {
            return splits;
        }
    }
}
