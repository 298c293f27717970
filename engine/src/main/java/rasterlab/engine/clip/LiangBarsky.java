package rasterlab.engine.clip;

import rasterlab.contract.SegmentSink;

/**
 * The segment as an interval of t that each side makes shorter.
 *
 * <p>The line x = side is met at t = (side − x0)/(x1 − x0). Of two opposite sides the segment meets
 * first, at the smaller t, the one it enters by, and leaves by the other. So enter is the largest
 * of 0 and the two smaller t, leave the smallest of 1 and the two larger ones, and enter ≤ t ≤
 * leave is what is left. Parallel to two sides, it lies between them or not: compared exactly.
 *
 * <p>Each t up to 1 errs by less than 2⁻⁵¹, so an interval longer or emptier than {@value #SURE} is
 * judged right; one closer to a single point is handed over. Since rounding keeps the order of
 * numbers, an end inside gets a t that is not within 0..1, and stays where it is.
 *
 * <p>Source: Y.-D. Liang and B. A. Barsky, A new concept and method for line clipping, ACM
 * Transactions on Graphics 3(1), 1984, pp. 1–22.
 */
public final class LiangBarsky implements SteppedSegmentClipper {
    private static final double SURE = 0x1p-48;

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
        walk.columns();
        walk.rows();
        walk.settle();
        walk.send(out);
    }

    @Override
    public ClipWalk walk(
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
        return "t = (side − x0)/(x1 − x0), (side − y0)/(y1 − y0); enters at the smaller of two opposite sides'";
    }

    private static final class Walk extends WindowWalk {
        private double enter;
        private double leave = 1;
        private double t = Double.NaN;
        private String at = "";
        private double high = Double.NaN;
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
        }

        @Override
        public boolean advance() {
            if (steps == 4 || enter - leave > SURE || unsure()) return false;
            switch (steps++) {
                case 0 -> step("left", columns());
                case 1 -> step("right", high);
                case 2 -> step("bottom", rows());
                default -> step("top", high);
            }
            if (steps == 4) settle();
            return true;
        }

        private void step(String side, double parameter) {
            at = side;
            t = parameter;
        }

        /** Cuts at the left and the right side; the t of the left one. */
        double columns() {
            return cut(xmin - x0, xmax - x0, dx);
        }

        /** Cuts at the bottom and the top side; the t of the bottom one. */
        double rows() {
            return cut(ymin - y0, ymax - y0, dy);
        }

        /**
         * Cuts at two opposite sides, without a branch that depends on where the segment lies.
         *
         * @param toLow from the first end to the lower side, {@code toHigh} to the higher one
         */
        private double cut(double toLow, double toHigh, double rate) {
            if (rate == 0) {
                if (toLow > 0 || toHigh < 0) leave = Double.NEGATIVE_INFINITY;
                high = Double.NaN;
                return Double.NaN;
            }
            double low = toLow / rate;
            high = toHigh / rate;
            divisions += 2;
            enter = Math.max(enter, Math.min(low, high));
            leave = Math.min(leave, Math.max(low, high));
            return low;
        }

        /** Hands over where the four sides left about a single point. */
        void settle() {
            if (Math.abs(leave - enter) <= SURE) handOver();
        }

        @Override
        boolean kept() {
            return enter <= leave;
        }

        @Override
        public void piece(SegmentSink out) {
            sendPart(enter, leave, out);
        }

        @Override
        public String at() {
            return at;
        }

        @Override
        public double decision() {
            return t;
        }
    }
}
