package rasterlab.engine.clip.segment;

import rasterlab.contract.SegmentSink;
import rasterlab.engine.clip.polygon.ConvexWindow;

/**
 * The segment cut by each edge of a convex window, through the edge's inward normal.
 *
 * <p>With a corner c of the edge and its inward normal n, the points within are those with n·(p −
 * c) ≥ 0. On the segment n·(p(t) − c) = inside + t·rate, inside = n·(p0 − c), rate = n·(p1 − p0);
 * it enters at t = −inside/rate where rate &gt; 0, leaves there where rate &lt; 0, and runs along
 * the edge where rate = 0. The contract's window is a rectangle, corners counter-clockwise, so that
 * one of n's coordinates is 0 and t errs by less than 2⁻⁵⁰, unless a difference is so small that n
 * times it does not fit in a double, which is handed over; {@link ConvexWindowWalk} takes any other
 * convex window.
 *
 * <p>Source: M. Cyrus, J. Beck, Generalized two- and three-dimensional clipping, Computers and
 * Graphics 3, 1978, pp. 23–28.
 */
public final class CyrusBeck implements SteppedSegmentClipper {
    private static final double SURE = 0x1p-48;
    private static final double NARROWEST = 0x1p-300;
    private static final String[] SIDES = {"bottom", "right", "top", "left"};

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

    /**
     * A walk through any convex window.
     *
     * @param corners x and y of each in turn, in either direction; not changed
     * @throws IllegalArgumentException if the window is not convex or has no area, now, or if an
     *     end is not finite, now or from {@link SegmentWalk#send}
     */
    public SegmentWalk walk(double[] corners, double x0, double y0, double x1, double y1) {
        return ConvexWindowWalk.of(ConvexWindow.of(corners).xy(), x0, y0, x1, y1);
    }

    /**
     * Sends what is left of the segment in a convex window, if anything, once. As in {@link
     * rasterlab.contract.SegmentClipper} an end in the window stays as it is and the decision is
     * exact; a new end on a slanted edge may lie outside by its rounding.
     *
     * @param corners as for {@link #walk(double[], double, double, double, double)}
     */
    public void clip(
            double[] corners, double x0, double y0, double x1, double y1, SegmentSink out) {
        SegmentWalk walk = walk(corners, x0, y0, x1, y1);
        while (walk.advance()) continue;
        walk.send(out);
    }

    @Override
    public String decisionFormula() {
        return "t = −n·(p0 − c)/n·(p1 − p0); enters where n·(p1 − p0) > 0, else leaves";
    }

    private static final class Walk extends WindowWalk {
        private final double[] corners;
        private double enter;
        private double leave = 1;
        private double t = Double.NaN;
        private int edges;

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
            corners = new double[] {xmin, ymin, xmax, ymin, xmax, ymax, xmin, ymax};
            // An edge without length has no normal.
            if (!(xmax - xmin >= NARROWEST && ymax - ymin >= NARROWEST)) handOver();
            if (vanishing(dx) || vanishing(dy)) handOver();
            if (vanishing(x0 - xmin) || vanishing(x0 - xmax)) handOver();
            if (vanishing(y0 - ymin) || vanishing(y0 - ymax)) handOver();
        }

        @Override
        public boolean advance() {
            if (2 * edges == corners.length || enter > leave || unsure()) return false;
            cut(2 * edges++);
            if (2 * edges == corners.length && Math.abs(leave - enter) <= SURE) handOver();
            return true;
        }

        private void cut(int edge) {
            int next = (edge + 2) % corners.length;
            double normalX = corners[edge + 1] - corners[next + 1];
            double normalY = corners[next] - corners[edge];
            double inside = normalX * (x0 - corners[edge]) + normalY * (y0 - corners[edge + 1]);
            double rate = normalX * dx + normalY * dy;
            t = Double.NaN;
            if (rate == 0) {
                if (inside < 0) leave = Double.NEGATIVE_INFINITY;
                return;
            }
            t = -inside / rate;
            divisions++;
            if (rate > 0) enter = Math.max(enter, t);
            else leave = Math.min(leave, t);
            if (enter > leave && enter - leave <= SURE) handOver();
        }

        @Override
        boolean kept() {
            return enter <= leave;
        }

        @Override
        public void piece(SegmentSink out) {
            showPart(enter, leave, out);
        }

        @Override
        void sendKept(SegmentSink out) {
            sendPart(enter, leave, out);
        }

        @Override
        public String at() {
            return edges == 0 ? "" : SIDES[edges - 1];
        }

        @Override
        public double decision() {
            return t;
        }
    }
}
