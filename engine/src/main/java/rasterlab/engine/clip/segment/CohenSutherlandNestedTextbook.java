package rasterlab.engine.clip.segment;

import rasterlab.contract.SegmentSink;

/**
 * The other course text's listing, in real numbers, with its faults, kept to be looked at beside
 * {@link CohenSutherland}.
 *
 * <p>The test for the top stands a second time inside the branch for the bottom, where it never
 * holds, and the branches for right and left hang under it: an end below but neither right nor left
 * is never moved, nor is one right or left but not below, and the loop never ends. The branches for
 * right and left begin with x1 where y1 is meant. Only ends above the window are cut as they should
 * be. NaN lies on no side, so that a segment with it counts as inside.
 *
 * <p>Source: the course's textbook chapter on clipping, procedure CLIP.
 */
public final class CohenSutherlandNestedTextbook implements SteppedSegmentClipper {
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
        return new Walk(new double[] {xmin, ymin, xmax, ymax}, x0, y0, x1, y1);
    }

    @Override
    public String decisionFormula() {
        return "code of the first end: 1 above, 2 below, 4 right, 8 left";
    }

    private static final class Walk implements SegmentWalk {
        private final double[] window;
        private double x1;
        private double y1;
        private double x2;
        private double y2;
        private int code;
        private int divisions;
        private boolean swapped;
        private String at = "";

        Walk(double[] window, double x1, double y1, double x2, double y2) {
            this.window = window;
            this.x1 = x1;
            this.y1 = y1;
            this.x2 = x2;
            this.y2 = y2;
        }

        private int outcode(double x, double y) {
            return (y > window[3] ? WindowWalk.TOP : 0)
                    | (y < window[1] ? WindowWalk.BOTTOM : 0)
                    | (x > window[2] ? WindowWalk.RIGHT : 0)
                    | (x < window[0] ? WindowWalk.LEFT : 0);
        }

        private boolean reject() {
            return (outcode(x1, y1) & outcode(x2, y2)) != 0;
        }

        @Override
        public boolean advance() {
            if (reject() || (outcode(x1, y1) | outcode(x2, y2)) == 0) return false;
            if (outcode(x1, y1) == 0) swap();
            code = outcode(x1, y1);
            boolean above = (code & WindowWalk.TOP) != 0;
            boolean below = (code & WindowWalk.BOTTOM) != 0;
            at = "";
            if (above) moveToRow(window[3], "top");
            else if (below)
                if (above) moveToRow(window[1], "bottom");
                else if ((code & WindowWalk.RIGHT) != 0) moveToColumn(window[2], "right");
                else if ((code & WindowWalk.LEFT) != 0) moveToColumn(window[0], "left");
            return true;
        }

        private void moveToRow(double y, String side) {
            at = side;
            divisions++;
            x1 = x1 + (x2 - x1) * (y - y1) / (y2 - y1);
            y1 = y;
        }

        private void moveToColumn(double x, String side) {
            at = side;
            divisions++;
            y1 = x1 + (y2 - y1) * (x - x1) / (x2 - x1);
            x1 = x;
        }

        private void swap() {
            swapped = !swapped;
            double x = x1;
            double y = y1;
            x1 = x2;
            y1 = y2;
            x2 = x;
            y2 = y;
        }

        @Override
        public void piece(SegmentSink out) {
            if (swapped) out.segment(x2, y2, x1, y1);
            else out.segment(x1, y1, x2, y2);
        }

        @Override
        public void send(SegmentSink out) {
            if (!reject()) piece(out);
        }

        @Override
        public String at() {
            return at;
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
            return false;
        }
    }
}
