package rasterlab.engine.clip.segment;

/**
 * Kazantsev's listing in real numbers as printed, kept to be looked at beside {@link
 * CohenSutherland}.
 *
 * <p>Within the branch for "below" the cut at the bottom hangs on a second test for "above", which
 * never holds there, and the branches for right and left hang on that test's else: an end below but
 * neither right nor left is never moved, nor is one right or left but not below, and the loop never
 * ends. The branches for right and left mix x and y twice: y1 ← <b>x1</b> + (y2 − y1)·(<b>ymax</b>
 * − x1)/(x2 − x1) for the right, with ymin for the left, where y1, xmax and xmin are meant; in a
 * square window from (0, 0) the second slip is not seen. Only ends above the window are cut as they
 * should be. NaN counts as inside.
 *
 * <p>Source: A. V. Kazantsev, Foundations of computer graphics for programmers, Kazan, 2005, ch. 4,
 * procedure CLIP.
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
        return new Walk(new ClipWindow(xmin, ymin, xmax, ymax), x0, y0, x1, y1);
    }

    @Override
    public String decisionFormula() {
        return "code of the first end: 1 above, 2 below, 4 right, 8 left";
    }

    private static final class Walk extends MovedEnds {
        Walk(ClipWindow window, double x1, double y1, double x2, double y2) {
            super(window, x1, y1, x2, y2);
        }

        @Override
        String move(int outcode) {
            boolean above = (outcode & CohenSutherland.TOP) != 0;
            boolean below = (outcode & CohenSutherland.BOTTOM) != 0;
            if (above) return moveToRow(window.ymax(), "top");
            else if (below)
                if (above) return moveToRow(window.ymin(), "bottom");
                else if ((outcode & CohenSutherland.RIGHT) != 0)
                    return moveToColumn(window.ymax(), window.xmax(), "right");
                else if ((outcode & CohenSutherland.LEFT) != 0)
                    return moveToColumn(window.ymin(), window.xmin(), "left");
            return "";
        }

        private String moveToRow(double y, String side) {
            divisions++;
            x1 = x1 + (x2 - x1) * (y - y1) / (y2 - y1);
            y1 = y;
            return side;
        }

        /** Moves the end to the column x, having measured the way to the row in its place. */
        private String moveToColumn(double row, double x, String side) {
            divisions++;
            y1 = x1 + (y2 - y1) * (row - x1) / (x2 - x1);
            x1 = x;
            return side;
        }
    }
}
