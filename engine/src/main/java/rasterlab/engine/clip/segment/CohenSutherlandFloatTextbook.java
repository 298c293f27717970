package rasterlab.engine.clip.segment;

/**
 * The method in plain doubles, as it is often written, kept to be looked at beside {@link
 * CohenSutherland}.
 *
 * <p>The slope m = (y2 − y1)/(x2 − x1) is computed once, to save divisions; ends are moved along it
 * until their codes are 0. But m is rounded, so the moved end runs along another line than the one
 * through the other end. Where that line passes just outside a corner and the other end lies at
 * that corner, cutting at the one side brings the end beyond the other by a rounding, cutting there
 * brings it back, and so on for ever. No number of bits mends this; an exact code or a count of the
 * cuts does. (With m from the moved end each time, the end heads for the other one and the loop
 * ends.)
 *
 * <p>Where the ends are far out their fractions are lost as well, and infinities and NaN are not
 * refused.
 */
public final class CohenSutherlandFloatTextbook implements SteppedSegmentClipper {
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
        return new Walk(new ClipWindow(xmin, ymin, xmax, ymax), x0, y0, x1, y1);
    }

    @Override
    public String decisionFormula() {
        return "code of the first end: 1 above, 2 below, 4 right, 8 left";
    }

    private static final class Walk extends MovedEnds {
        private final double slope;

        Walk(ClipWindow window, double x1, double y1, double x2, double y2) {
            super(window, x1, y1, x2, y2);
            slope = (y2 - y1) / (x2 - x1);
            divisions++;
        }

        @Override
        String move(int outcode) {
            if ((outcode & CohenSutherland.TOP) != 0) return moveToRow(window.ymax(), "top");
            if ((outcode & CohenSutherland.BOTTOM) != 0) return moveToRow(window.ymin(), "bottom");
            if ((outcode & CohenSutherland.RIGHT) != 0) return moveToColumn(window.xmax(), "right");
            return moveToColumn(window.xmin(), "left");
        }

        private String moveToRow(double y, String side) {
            divisions++;
            x1 = x1 + (y - y1) / slope;
            y1 = y;
            return side;
        }

        private String moveToColumn(double x, String side) {
            y1 = y1 + slope * (x - x1);
            x1 = x;
            return side;
        }
    }
}
