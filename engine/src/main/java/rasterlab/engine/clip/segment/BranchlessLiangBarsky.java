package rasterlab.engine.clip.segment;

import rasterlab.contract.SegmentSink;

/**
 * {@link LiangBarsky} without branches, for speed.
 *
 * <p>Of the left and the right side a segment with x1 &gt; x0 can enter by the left one only, and
 * leave by the right one; with x1 &lt; x0 the other way round. It enters at t = (near − x0)/(x1 −
 * x0) and leaves at t = 1 − (x1 − far)/(x1 − x0). So x cuts these two shares off its ends where
 * they are above 0, and y likewise. The larger share counts at each end: {@code enter} and {@code
 * back}. Something is left where enter + back &lt; 1.
 *
 * <p>A share errs by 4·u of itself (u = 2⁻⁵³), so enter + back is known to within 2⁻⁵⁰: nearer to 1
 * than {@value #SURE}, it is handed over, and so is a share too small for a double. A share is at
 * most 0 exactly where the end is within, so such an end stays where it is. A cut end gets the
 * side's own coordinate on the axis with the larger share; on the other axis it lies inside by
 * {@value #SURE} of the segment's extent, more than rounding takes, or else is handed over.
 *
 * <p>Where the segment lies is as good as random, so a processor guesses every branch on it wrong
 * often, which costs more than the arithmetic between two of them (the clipping benchmark shows
 * it); near and far sides and larger shares are therefore picked by sign bits.
 *
 * <p>Source: Y.-D. Liang, B. A. Barsky, A new concept and method for line clipping, ACM
 * Transactions on Graphics 3(1), 1984, pp. 1–22.
 */
public final class BranchlessLiangBarsky implements SteppedSegmentClipper {
    private static final double SURE = 0x1p-48;
    private static final double FLATTEST = 0x1p-900;

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
        if (!walk.beyondOneSide()) {
            walk.cutColumns();
            walk.cutRows();
            walk.settle();
        }
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
        return "t = (near − x0)/(x1 − x0) or 1 − (x1 − far)/(x1 − x0), the same in y";
    }

    private static final class Walk extends WindowWalk {
        private final double nearX;
        private final double farX;
        private final double nearY;
        private final double farY;
        private double enterX = -1;
        private double enterY = -1;
        private double backX = -1;
        private double backY = -1;
        private boolean kept;
        private int steps;

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
            nearX = picked(this.xmin, this.xmax, signs(dx));
            farX = picked(this.xmax, this.xmin, signs(dx));
            nearY = picked(this.ymin, this.ymax, signs(dy));
            farY = picked(this.ymax, this.ymin, signs(dy));
        }

        /** Whether both ends are beyond one side: two differences have a sign bit in common. */
        boolean beyondOneSide() {
            return (signs(x0 - xmin) & signs(x1 - xmin)
                            | signs(xmax - x0) & signs(xmax - x1)
                            | signs(y0 - ymin) & signs(y1 - ymin)
                            | signs(ymax - y0) & signs(ymax - y1))
                    != 0;
        }

        @Override
        public boolean advance() {
            if (steps == 4 || unsure() || steps == 0 && beyondOneSide()) return false;
            if (steps == 0) cutColumns();
            if (steps == 2) cutRows();
            if (++steps == 4) settle();
            return true;
        }

        void cutColumns() {
            if (Math.abs(dx) < FLATTEST) {
                parallel(dx);
                return;
            }
            double slowness = 1 / dx;
            divisions++;
            enterX = (nearX - x0) * slowness;
            backX = (x1 - farX) * slowness;
        }

        void cutRows() {
            if (Math.abs(dy) < FLATTEST) {
                parallel(dy);
                return;
            }
            double slowness = 1 / dy;
            divisions++;
            enterY = (nearY - y0) * slowness;
            backY = (y1 - farY) * slowness;
        }

        /** Parallel to two sides and not beyond one, it lies between them and is not cut. */
        private void parallel(double change) {
            if (change != 0) handOver();
        }

        /** Decides, or hands over what rounding might decide. */
        void settle() {
            double enter = enter();
            double back = back();
            double left = 1 - enter - back;
            kept = left > 0;
            if (Math.abs(left) <= SURE) handOver();
            if (Math.abs(enterX - enterY) <= SURE && enter > 0) handOver();
            if (Math.abs(backX - backY) <= SURE && back > 0) handOver();
            if (vanished(enterX, x0, nearX) | vanished(enterY, y0, nearY)) handOver();
            if (vanished(backX, x1, farX) | vanished(backY, y1, farY)) handOver();
        }

        /** Whether a share is 0 though the end is not on the side: too small for a double. */
        private static boolean vanished(double share, double end, double side) {
            return share == 0 & end != side;
        }

        private double enter() {
            return positive(picked(enterX, enterY, signs(enterX - enterY)));
        }

        private double back() {
            return positive(picked(backX, backY, signs(backX - backY)));
        }

        @Override
        boolean kept() {
            return kept;
        }

        @Override
        public void piece(SegmentSink out) {
            double enter = enter();
            double back = back();
            long byY = signs(enterX - enterY);
            long backByY = signs(backX - backY);
            long cut = set(enter);
            long backCut = set(back);
            out.segment(
                    picked(x0 + enter * dx, nearX, cut & ~byY),
                    picked(y0 + enter * dy, nearY, cut & byY),
                    picked(x1 - back * dx, farX, backCut & ~backByY),
                    picked(y1 - back * dy, farY, backCut & backByY));
        }

        /** All bits set where the sign bit is, else none. */
        private static long signs(double number) {
            return Double.doubleToRawLongBits(number) >> 63;
        }

        /** All bits set where a number that is not below 0 is not 0. */
        private static long set(double number) {
            return -Double.doubleToRawLongBits(number) >> 63;
        }

        /** The number, or 0 where it is below. */
        private static double positive(double number) {
            long bits = Double.doubleToRawLongBits(number);
            return Double.longBitsToDouble(bits & ~(bits >> 63));
        }

        @Override
        public String at() {
            return switch (steps) {
                case 0 -> "";
                case 1 -> dx < 0 ? "right" : "left";
                case 2 -> dx < 0 ? "left" : "right";
                case 3 -> dy < 0 ? "top" : "bottom";
                default -> dy < 0 ? "bottom" : "top";
            };
        }

        @Override
        public double decision() {
            if ((steps < 3 ? dx : dy) == 0) return Double.NaN;
            return switch (steps) {
                case 1 -> enterX;
                case 2 -> 1 - backX;
                case 3 -> enterY;
                case 4 -> 1 - backY;
                default -> Double.NaN;
            };
        }
    }
}
