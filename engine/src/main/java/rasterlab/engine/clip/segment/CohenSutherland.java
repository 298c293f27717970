package rasterlab.engine.clip.segment;

import rasterlab.contract.SegmentSink;

/**
 * A code of four bits for each end tells which sides it lies beyond; an end with a bit is moved
 * onto that side.
 *
 * <p>Nothing is left where the two codes share a bit; all that remains is left where both are 0.
 * New ends are computed from the segment as given, never from a moved end, so errors do not add up.
 *
 * <p>It ends after at most four cuts. A cut puts an end on a side and takes a bit from its code. In
 * exact arithmetic the end moves towards the other end, so each of its coordinates changes in one
 * direction only, and between a cut at a side in x and a later one in y, x stays at or within that
 * side or crosses the other one, in which case the two codes share that bit; so an end is cut at
 * most once in x and once in y. The same holds here, because every code is the exact one: the
 * coordinate a cut sets is the side's own, and where the computed one is so near a side that its
 * rounding might change a bit, the segment is handed over instead.
 *
 * <p>Source: W. M. Newman, R. F. Sproull, Principles of Interactive Computer Graphics, 1973, where
 * the method of D. Cohen and I. Sutherland is described.
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
        var walk = new Walk(xmin, ymin, xmax, ymax, x0, y0, x1, y1);
        while (walk.open()) walk.cut();
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
        return new Walk(xmin, ymin, xmax, ymax, x0, y0, x1, y1);
    }

    @Override
    public String decisionFormula() {
        return "code of the end that is moved: 1 above, 2 below, 4 right, 8 left";
    }

    static final class Walk extends WindowWalk {
        private double fromX;
        private double fromY;
        private double toX;
        private double toY;
        private int fromCode;
        private int toCode;
        private int code;

        Walk(
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

        /**
         * Which sides a point lies beyond: the signs of four differences, bit by bit. A difference
         * of doubles has the right sign always, and that of equals is +0, none of them being −0.
         */
        int code(double x, double y) {
            return columnCode(x) | rowCode(y);
        }

        private int columnCode(double x) {
            return sign(xmax - x) * RIGHT | sign(x - xmin) * LEFT;
        }

        private int rowCode(double y) {
            return sign(ymax - y) * TOP | sign(y - ymin) * BOTTOM;
        }

        /** 1 for what is below 0, else 0, without a branch. */
        private static int sign(double difference) {
            return (int) (Double.doubleToRawLongBits(difference) >>> 63);
        }

        /** Whether the codes leave something to decide, and doubles are good enough for it. */
        boolean open() {
            return (fromCode & toCode) == 0 && (fromCode | toCode) != 0 && !unsure();
        }

        @Override
        public boolean advance() {
            if (!open()) return false;
            cut();
            return true;
        }

        /**
         * Moves an end onto a side; on the other axis it lies anywhere, on this one within. What
         * {@code picked} takes is the second number where the code has the bit, else the first.
         */
        void cut() {
            code = fromCode != 0 ? fromCode : toCode;
            divisions++;
            if ((code & (LEFT | RIGHT)) != 0) {
                double x = picked(xmax, xmin, -(code & LEFT));
                double y = y0 + (x - x0) / dx * dy;
                if (near(y, ymin, ymax)) handOver();
                move(x, y, rowCode(y));
            } else {
                double y = picked(ymax, ymin, -(code & BOTTOM));
                double x = x0 + (y - y0) / dy * dx;
                if (near(x, xmin, xmax)) handOver();
                move(x, y, columnCode(x));
            }
        }

        private void move(double x, double y, int newCode) {
            if (fromCode != 0) {
                fromX = x;
                fromY = y;
                fromCode = newCode;
            } else {
                toX = x;
                toY = y;
                toCode = newCode;
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
