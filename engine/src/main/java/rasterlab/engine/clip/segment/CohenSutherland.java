package rasterlab.engine.clip.segment;

import rasterlab.contract.SegmentSink;

/**
 * A code of four bits for each end tells which sides it lies beyond; an end with a bit is moved
 * onto that side.
 *
 * <p>Nothing is left where the two codes share a bit; all that remains is left where both are 0.
 * New ends are computed from the segment as given, never from a moved end, so errors do not add up.
 * The base class {@link WindowWalk} keeps what is given: the window, the segment from (x0, y0) to
 * (x1, y1), dx = x1 − x0 and dy = y1 − y0. It also says when doubles cannot decide: a walk that is
 * {@code unsure} stops, and the segment is clipped without rounding instead.
 *
 * <p>It ends after at most four cuts. A cut puts an end on a side and takes a bit from its code. In
 * exact arithmetic the end moves towards the other end, so each of its coordinates changes in one
 * direction only, and between a cut at a side in x and a later one in y, x stays at or within that
 * side or crosses the other one, in which case the two codes share that bit; so an end is cut at
 * most once in x and once in y. The same holds here, because every code is the exact one: the
 * coordinate a cut sets is the side's own, and where the computed one is so near a side that its
 * rounding might change a bit, {@link UnroundedClip} clips the segment instead.
 *
 * <p>Source: W. M. Newman, R. F. Sproull, Principles of Interactive Computer Graphics, McGraw-Hill,
 * 1973, where the method of D. Cohen and I. Sutherland is described.
 */
public final class CohenSutherland implements SteppedSegmentClipper {
    static final int TOP = 1;
    static final int BOTTOM = 2;
    static final int RIGHT = 4;
    static final int LEFT = 8;

    @Override
    public void clip(
            double xmin,
            double ymin,
            double xmax,
            double ymax,
            double x0,
            double y0,
            double x1,
            double y1,
            SegmentSink out) {
        var walk = new RegionCodeWalk(xmin, ymin, xmax, ymax, x0, y0, x1, y1);
        while (walk.advance()) continue;
        walk.send(out);
    }

    @Override
    public SegmentWalk walk(
            double xmin,
            double ymin,
            double xmax,
            double ymax,
            double x0,
            double y0,
            double x1,
            double y1) {
        return new RegionCodeWalk(xmin, ymin, xmax, ymax, x0, y0, x1, y1);
    }

    @Override
    public String decisionFormula() {
        return "code of the end that is moved: 1 above, 2 below, 4 right, 8 left";
    }

    static final class RegionCodeWalk extends WindowWalk {
        private double fromX;
        private double fromY;
        private double toX;
        private double toY;
        private int fromCode;
        private int toCode;
        private int code;

        RegionCodeWalk(
                double xmin,
                double ymin,
                double xmax,
                double ymax,
                double x0,
                double y0,
                double x1,
                double y1) {
            super(xmin, ymin, xmax, ymax, x0, y0, x1, y1);
            fromX = this.x0;
            fromY = this.y0;
            toX = this.x1;
            toY = this.y1;
            fromCode = code(fromX, fromY);
            toCode = code(toX, toY);
        }

        /** Adds up the bits of the sides that a point lies beyond; 0 means inside. */
        int code(double x, double y) {
            return (x < xmin ? LEFT : 0)
                    | (x > xmax ? RIGHT : 0)
                    | (y < ymin ? BOTTOM : 0)
                    | (y > ymax ? TOP : 0);
        }

        /**
         * Moves one outside end, the first before the second, onto the line of a side it lies
         * beyond. There it may still lie beyond another side, which a later call cuts.
         */
        @Override
        public boolean advance() {
            boolean allInside = (fromCode | toCode) == 0;
            boolean allBeyondOneSide = (fromCode & toCode) != 0;
            if (allInside || allBeyondOneSide || unsure()) return false;
            divisions++;
            code = fromCode != 0 ? fromCode : toCode;
            if ((code & LEFT) != 0) moveToColumn(xmin, y0 + (xmin - x0) / dx * dy);
            else if ((code & RIGHT) != 0) moveToColumn(xmax, y0 + (xmax - x0) / dx * dy);
            else if ((code & BOTTOM) != 0) moveToRow(x0 + (ymin - y0) / dy * dx, ymin);
            else moveToRow(x0 + (ymax - y0) / dy * dx, ymax);
            return true;
        }

        private void moveToColumn(double x, double y) {
            if (near(y, ymin, ymax)) handOver(); // rounding may falsify the new code
            moveEnd(x, y);
        }

        private void moveToRow(double x, double y) {
            if (near(x, xmin, xmax)) handOver();
            moveEnd(x, y);
        }

        private void moveEnd(double x, double y) {
            if (fromCode != 0) {
                fromX = x;
                fromY = y;
                fromCode = code(x, y);
            } else {
                toX = x;
                toY = y;
                toCode = code(x, y);
            }
        }

        @Override
        boolean kept() {
            return (fromCode | toCode) == 0;
        }

        @Override
        public void piece(SegmentSink out) {
            out.segment(fromX, fromY, toX, toY);
        }

        @Override
        public String at() {
            if ((code & (LEFT | RIGHT)) != 0) return (code & LEFT) != 0 ? "left" : "right";
            return code == 0 ? "" : (code & BOTTOM) != 0 ? "bottom" : "top";
        }

        @Override
        public double decision() {
            return code;
        }
    }
}
