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
 * rounding might change a bit, the walk is {@code unsure}: it stops, and the whole segment is
 * clipped without rounding instead. So it is from the start where {@link RoundingBound}, which says
 * how near that is, does not hold.
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
        var window = new WindowSides(xmin, ymin, xmax, ymax);
        var walk = new RegionCodeWalk(window, x0, y0, x1, y1);
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
        return new RegionCodeWalk(new WindowSides(xmin, ymin, xmax, ymax), x0, y0, x1, y1);
    }

    @Override
    public String decisionFormula() {
        return "code of the end that is moved: 1 above, 2 below, 4 right, 8 left";
    }

    /** The window as given: swapped sides are refused where the segment is sent. */
    record WindowSides(double xmin, double ymin, double xmax, double ymax) {
        WindowSides {
            // −0.0 becomes 0.0, so that no answer has a signed zero.
            xmin += 0.0;
            ymin += 0.0;
            xmax += 0.0;
            ymax += 0.0;
        }

        /** Adds up the bits of the sides that a point lies beyond; 0 means inside. */
        int code(double x, double y) {
            return (x < xmin ? LEFT : 0)
                    | (x > xmax ? RIGHT : 0)
                    | (y < ymin ? BOTTOM : 0)
                    | (y > ymax ? TOP : 0);
        }
    }

    /** The segment as given, from (x0, y0) to (x1, y1), and what is left of it, from and to. */
    private static final class RegionCodeWalk implements SegmentWalk {
        private final WindowSides window;
        private final double x0;
        private final double y0;
        private final double x1;
        private final double y1;
        private final double dx;
        private final double dy;
        private final double size;
        private double fromX;
        private double fromY;
        private double toX;
        private double toY;
        private int fromCode;
        private int toCode;
        private int code;
        private int divisions;
        private boolean unsure;

        RegionCodeWalk(WindowSides window, double x0, double y0, double x1, double y1) {
            this.window = window;
            this.x0 = fromX = x0 + 0.0;
            this.y0 = fromY = y0 + 0.0;
            this.x1 = toX = x1 + 0.0;
            this.y1 = toY = y1 + 0.0;
            dx = x1 - x0;
            dy = y1 - y0;
            fromCode = window.code(fromX, fromY);
            toCode = window.code(toX, toY);
            double width = window.xmax - window.xmin;
            double height = window.ymax - window.ymin;
            size = width + height;
            unsure = !RoundingBound.holds(width, height, dx, dy);
        }

        /**
         * Moves one outside end, the first before the second, onto the line of a side it lies
         * beyond. There it may still lie beyond another side, which a later call cuts.
         */
        @Override
        public boolean advance() {
            boolean allInside = (fromCode | toCode) == 0;
            boolean allBeyondOneSide = (fromCode & toCode) != 0;
            if (allInside || allBeyondOneSide || unsure) return false;
            code = fromCode != 0 ? fromCode : toCode;
            if ((code & LEFT) != 0) moveToColumn(window.xmin);
            else if ((code & RIGHT) != 0) moveToColumn(window.xmax);
            else if ((code & BOTTOM) != 0) moveToRow(window.ymin);
            else moveToRow(window.ymax);
            divisions++;
            return true;
        }

        private void moveToColumn(double x) {
            double y = y0 + (x - x0) / dx * dy;
            unsure = RoundingBound.hides(size, y, window.ymin, window.ymax);
            moveEnd(x, y);
        }

        private void moveToRow(double y) {
            double x = x0 + (y - y0) / dy * dx;
            unsure = RoundingBound.hides(size, x, window.xmin, window.xmax);
            moveEnd(x, y);
        }

        private void moveEnd(double x, double y) {
            if (fromCode != 0) {
                fromX = x;
                fromY = y;
                fromCode = window.code(x, y);
            } else {
                toX = x;
                toY = y;
                toCode = window.code(x, y);
            }
        }

        @Override
        public void send(SegmentSink out) {
            boolean allInside = (fromCode | toCode) == 0;
            if (unsure)
                UnroundedClip.clip(
                        window.xmin, window.ymin, window.xmax, window.ymax, x0, y0, x1, y1, out);
            else if (allInside) piece(out);
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

        @Override
        public int divisions() {
            return divisions;
        }

        @Override
        public boolean unsure() {
            return unsure;
        }
    }
}
