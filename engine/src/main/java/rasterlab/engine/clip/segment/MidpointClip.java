package rasterlab.engine.clip.segment;

import java.util.Locale;
import rasterlab.contract.SegmentSink;

/**
 * Halving instead of dividing: made for hardware that could add and shift only.
 *
 * <p>First a visible point is sought: of the two halves of a segment with both ends outside, at
 * least one lies beyond a side that its ends share (if the middle is above the window, so is the
 * end that is no lower) and is thrown away. Then each invisible end is halved towards the visible
 * point until the two are neighbours. Halves of t are exact in binary, so no errors add up; there
 * are at most {@value #DEEPEST} halvings in each of the three parts.
 *
 * <p>A middle so near a side that rounding may decide, while a visible point is still sought, is
 * handed over; near a corner that is what the seeking comes down to. So is a segment of which one
 * extent is about as short as the smallest double, which cannot be halved.
 *
 * <p>Source: R. F. Sproull, I. E. Sutherland, A clipping divider, AFIPS Fall Joint Computer
 * Conference, 1968, pp. 765–776.
 */
public final class MidpointClip implements SteppedSegmentClipper {
    private static final int DEEPEST = 52;
    private static final double NARROWEST = 0x1p-52;

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
        return "t of the middle that is tested";
    }

    private enum Part {
        SEEKING,
        ENTERING,
        LEAVING,
        OVER
    }

    private static final class Walk extends WindowWalk {
        private double enter;
        private double leave = 1;
        private int enterCode;
        private int leaveCode;
        private double visible = Double.NaN;
        private double width = 1;
        private double t = Double.NaN;
        private Part part = Part.SEEKING;
        private Part tested = Part.SEEKING;

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
            if (vanishing(dx) || vanishing(dy)) handOver();
            enterCode = code(this.x0, this.y0);
            leaveCode = code(this.x1, this.y1);
            if ((enterCode & leaveCode) != 0) part = Part.OVER;
            else if (enterCode == 0) found(0);
            else if (leaveCode == 0) found(1);
        }

        private int code(double x, double y) {
            return (y > ymax ? CohenSutherland.TOP : 0)
                    | (y < ymin ? CohenSutherland.BOTTOM : 0)
                    | (x > xmax ? CohenSutherland.RIGHT : 0)
                    | (x < xmin ? CohenSutherland.LEFT : 0);
        }

        private void found(double at) {
            visible = at;
            part = enterCode != 0 ? Part.ENTERING : leaveCode != 0 ? Part.LEAVING : Part.OVER;
            width = part == Part.LEAVING ? leave - visible : visible - enter;
        }

        @Override
        public boolean advance() {
            if (part == Part.OVER || unsure()) return false;
            tested = part;
            switch (part) {
                case SEEKING -> seek();
                case ENTERING -> enter();
                default -> leave();
            }
            return true;
        }

        private void seek() {
            t = (enter + leave) / 2;
            int code = middle();
            if (near(t * dx, xmin - x0, xmax - x0) || near(t * dy, ymin - y0, ymax - y0))
                handOver();
            else if (code == 0) found(t);
            else if (rejected(code)) part = Part.OVER;
        }

        /** Throws away each half that lies beyond one side; true where both do. */
        private boolean rejected(int code) {
            boolean first = (code & enterCode) != 0;
            boolean second = (code & leaveCode) != 0;
            if (first) {
                enter = t;
                enterCode = code;
            }
            if (second) {
                leave = t;
                leaveCode = code;
            }
            return first && second;
        }

        private void enter() {
            t = (enter + visible) / 2;
            if (middle() == 0) visible = t;
            else enter = t;
            width /= 2;
            if (width > NARROWEST) return;
            enter = visible;
            visible = leaveCode == 0 ? 1 : visible;
            part = leaveCode == 0 ? Part.OVER : Part.LEAVING;
            width = leave - visible;
        }

        private void leave() {
            t = (visible + leave) / 2;
            if (middle() == 0) visible = t;
            else leave = t;
            width /= 2;
            if (width > NARROWEST) return;
            leave = visible;
            part = Part.OVER;
        }

        /**
         * The code of the middle, seen from the first end: that way a middle next to a side is told
         * apart as finely as t is, however far from 0 the window lies.
         */
        private int middle() {
            double right = t * dx;
            double up = t * dy;
            return (up > ymax - y0 ? CohenSutherland.TOP : 0)
                    | (up < ymin - y0 ? CohenSutherland.BOTTOM : 0)
                    | (right > xmax - x0 ? CohenSutherland.RIGHT : 0)
                    | (right < xmin - x0 ? CohenSutherland.LEFT : 0);
        }

        @Override
        boolean kept() {
            return !Double.isNaN(visible);
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
            return tested.name().toLowerCase(Locale.ROOT);
        }

        @Override
        public double decision() {
            return t;
        }
    }
}
