package rasterlab.engine.clip.segment;

import rasterlab.contract.SegmentSink;

/**
 * Ponomarev's listing in whole numbers with its faults, kept to be looked at beside {@link
 * CohenSutherland}.
 *
 * <p>It draws what it has when its loop ends, even where that is because the segment lies wholly
 * outside. It divides whole numbers, (y2 − y1)/(x2 − x1), before it multiplies: every slope below 1
 * becomes 0. Coordinates are ints: fractions are rounded away, those beyond an int become the
 * largest one, and differences overflow from 2³⁰ on.
 *
 * <p>Source: V. V. Ponomarev, Computer graphics (Mashinnaya grafika), Ozyorsk, 2006, fig. 68.
 */
public final class CohenSutherlandTextbook implements SteppedSegmentClipper {
    private static final int LEFT = 1;
    private static final int TOP = 2;
    private static final int RIGHT = 4;
    private static final int BOTTOM = 8;

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
        return new Walk(
                new int[] {whole(xmin), whole(ymin), whole(xmax), whole(ymax)},
                new int[] {whole(x0), whole(y0), whole(x1), whole(y1)});
    }

    private static int whole(double coordinate) {
        return (int) Math.rint(coordinate);
    }

    @Override
    public String decisionFormula() {
        return "code of the first end: 1 left, 2 at smaller y, 4 right, 8 at larger y";
    }

    private static final class Walk implements SegmentWalk {
        private final int[] window;
        private int x1;
        private int y1;
        private int x2;
        private int y2;
        private int code1;
        private int code2;
        private int decided;
        private int divisions;
        private boolean swapped;
        private String at = "";

        Walk(int[] window, int[] ends) {
            this.window = window;
            x1 = ends[0];
            y1 = ends[1];
            x2 = ends[2];
            y2 = ends[3];
            recode();
        }

        private void recode() {
            code1 = region(x1, y1);
            code2 = region(x2, y2);
        }

        private int region(int x, int y) {
            return (x < window[0] ? LEFT : 0)
                    | (y < window[1] ? TOP : 0)
                    | (x > window[2] ? RIGHT : 0)
                    | (y > window[3] ? BOTTOM : 0);
        }

        @Override
        public boolean advance() {
            boolean inside = (code1 | code2) == 0;
            boolean outside = (code1 & code2) != 0;
            if (inside || outside) return false;
            if (code1 == 0) swap();
            decided = code1;
            divisions++;
            if ((code1 & LEFT) != 0) moveToColumn(window[0], "left");
            else if ((code1 & TOP) != 0) moveToRow(window[1], "top");
            else if ((code1 & RIGHT) != 0) moveToColumn(window[2], "right");
            else moveToRow(window[3], "bottom");
            recode();
            return true;
        }

        private void moveToColumn(int x, String side) {
            at = side;
            y1 = y1 + (y2 - y1) / (x2 - x1) * (x - x1);
            x1 = x;
        }

        private void moveToRow(int y, String side) {
            at = side;
            x1 = x1 + (x2 - x1) / (y2 - y1) * (y - y1);
            y1 = y;
        }

        private void swap() {
            swapped = !swapped;
            int x = x1;
            int y = y1;
            x1 = x2;
            y1 = y2;
            x2 = x;
            y2 = y;
            code1 = code2;
            code2 = 0;
        }

        @Override
        public void piece(SegmentSink out) {
            if (swapped) out.segment(x2, y2, x1, y1);
            else out.segment(x1, y1, x2, y2);
        }

        @Override
        public void send(SegmentSink out) {
            piece(out);
        }

        @Override
        public String at() {
            return at;
        }

        @Override
        public double decision() {
            return decided;
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
