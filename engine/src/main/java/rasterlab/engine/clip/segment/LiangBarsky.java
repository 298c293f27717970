package rasterlab.engine.clip.segment;

import rasterlab.contract.SegmentSink;

/**
 * The segment as an interval of t that each side makes shorter.
 *
 * <p>The point p(t) is within the side k where t·p_k ≤ q_k:
 *
 * <pre>
 * left    p = −dx   q = x0 − xmin
 * right   p =  dx   q = xmax − x0
 * bottom  p = −dy   q = y0 − ymin
 * top     p =  dy   q = ymax − y0
 * </pre>
 *
 * <p>Where p_k &lt; 0 it enters there, at t = q_k/p_k, where p_k &gt; 0 it leaves; where p_k = 0 it
 * is parallel to the side, and all or nothing is within by the sign of q_k. What is left is enter ≤
 * t ≤ leave, from the last entering to the first leaving.
 *
 * <p>A t errs by a share of 3·u (u = 2⁻⁵³). An interval closer to a single point than {@value
 * #SURE} is handed over.
 *
 * <p>Source: Y.-D. Liang, B. A. Barsky, A new concept and method for line clipping, ACM
 * Transactions on Graphics 3(1), 1984, pp. 1–22.
 */
public final class LiangBarsky implements SteppedSegmentClipper {
    private static final double SURE = 0x1p-48;
    private static final String[] SIDES = {"left", "right", "bottom", "top"};

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
        return "t = q/p; enters where p < 0, leaves where p > 0";
    }

    private static final class Walk extends WindowWalk {
        private final double[] p;
        private final double[] q;
        private double enter;
        private double leave = 1;
        private double t = Double.NaN;
        private int sides;

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
            p = new double[] {-dx, dx, -dy, dy};
            q = new double[] {x0 - xmin, xmax - x0, y0 - ymin, ymax - y0};
        }

        @Override
        public boolean advance() {
            if (sides == 4 || enter > leave || unsure()) return false;
            cut(p[sides], q[sides]);
            sides++;
            boolean over = sides == 4 || enter > leave;
            if (over && Math.abs(leave - enter) <= SURE) handOver();
            return true;
        }

        private void cut(double p, double q) {
            t = Double.NaN;
            if (p == 0) {
                if (q < 0) leave = Double.NEGATIVE_INFINITY;
                return;
            }
            t = q / p;
            divisions++;
            if (p < 0) enter = Math.max(enter, t);
            else leave = Math.min(leave, t);
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
            return sides == 0 ? "" : SIDES[sides - 1];
        }

        @Override
        public double decision() {
            return t;
        }
    }
}
