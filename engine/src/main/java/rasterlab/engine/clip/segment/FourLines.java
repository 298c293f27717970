package rasterlab.engine.clip.segment;

import rasterlab.contract.SegmentSink;

/**
 * The segment's points on the four lines that hold the sides, those on the sides being kept.
 *
 * <p>On the line x = side the point is at t = (side − x0)/(x1 − x0), y = y0 + t·(y1 − y0); it
 * counts if 0 ≤ t ≤ 1, that is if x0 and x1 are not both on one side of the line, and ymin ≤ y ≤
 * ymax. An end outside is replaced by the first or the last point that counts. All four lines are
 * always intersected: this is what the other methods save.
 *
 * <p>A y so near ymin or ymax that rounding may decide, at a corner, is handed over.
 */
public final class FourLines implements SteppedSegmentClipper {
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
        return "t = (side − x0)/(x1 − x0) or (side − y0)/(y1 − y0); counts in 0..1 on the side";
    }

    private static final class Walk extends WindowWalk {
        private final boolean fromInside;
        private final boolean toInside;
        private double first = Double.POSITIVE_INFINITY;
        private double last = Double.NEGATIVE_INFINITY;
        private double t = Double.NaN;
        private String at = "";
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
            fromInside = xmin <= x0 && x0 <= xmax && ymin <= y0 && y0 <= ymax;
            toInside = xmin <= x1 && x1 <= xmax && ymin <= y1 && y1 <= ymax;
        }

        @Override
        public boolean advance() {
            if (steps == 4 || unsure()) return false;
            t = Double.NaN;
            switch (steps++) {
                case 0 -> intersect("left", xmin, x0, x1, y0, dy, ymin, ymax);
                case 1 -> intersect("right", xmax, x0, x1, y0, dy, ymin, ymax);
                case 2 -> intersect("bottom", ymin, y0, y1, x0, dx, xmin, xmax);
                default -> intersect("top", ymax, y0, y1, x0, dx, xmin, xmax);
            }
            return true;
        }

        /**
         * Takes the point on one line, if it is on the side.
         *
         * @param from the first end's coordinate across the line, {@code to} the second's
         * @param start the first end's coordinate along the line, {@code rate} its change
         */
        private void intersect(
                String name,
                double side,
                double from,
                double to,
                double start,
                double rate,
                double lo,
                double hi) {
            at = name;
            if (from == to) return;
            t = (side - from) / (to - from);
            divisions++;
            if (side < Math.min(from, to) || side > Math.max(from, to)) return;
            double along = start + t * rate;
            if (near(along, lo, hi)) handOver();
            if (along < lo || along > hi) return;
            first = Math.min(first, t);
            last = Math.max(last, t);
        }

        @Override
        boolean kept() {
            return fromInside || toInside || first <= last;
        }

        @Override
        public void piece(SegmentSink out) {
            double enter = fromInside || first > last ? 0 : first;
            double leave = toInside || first > last ? 1 : last;
            if (steps < 4) out.segment(x0, y0, x1, y1);
            else sendPart(enter, leave, out);
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
