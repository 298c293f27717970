package rasterlab.engine.clip.segment;

import rasterlab.contract.SegmentSink;

/**
 * Base of most methods' walks: window, segment, and whether doubles are good enough.
 *
 * <p>Where {@link RoundingBound} does not hold, a walk is {@link #unsure} from the start.
 */
abstract class WindowWalk implements SegmentWalk {
    private static final double FLATTEST = 0x1p-600;

    final double xmin;
    final double ymin;
    final double xmax;
    final double ymax;
    final double x0;
    final double y0;
    final double x1;
    final double y1;
    final double dx;
    final double dy;
    final double size;
    int divisions;
    private boolean unsure;

    WindowWalk(
            double xmin,
            double ymin,
            double xmax,
            double ymax,
            double x0,
            double y0,
            double x1,
            double y1) {
        // −0.0 becomes 0.0, so that the difference of two equal numbers has no sign bit.
        this.xmin = xmin + 0.0;
        this.ymin = ymin + 0.0;
        this.xmax = xmax + 0.0;
        this.ymax = ymax + 0.0;
        this.x0 = x0 + 0.0;
        this.y0 = y0 + 0.0;
        this.x1 = x1 + 0.0;
        this.y1 = y1 + 0.0;
        dx = this.x1 - this.x0;
        dy = this.y1 - this.y0;
        double width = xmax - xmin;
        double height = ymax - ymin;
        size = width + height;
        unsure = !RoundingBound.holds(width, height, dx, dy);
    }

    /** Leaves the decision to unrounded arithmetic. */
    final void handOver() {
        unsure = true;
    }

    /**
     * Whether a length is not 0, yet so short that its products with shares and with the window's
     * sides may fall among the subnormal numbers, which have few digits.
     */
    static boolean vanishing(double length) {
        return Math.abs(length) < FLATTEST && length != 0;
    }

    /**
     * Whether the rounding of a computed coordinate may hide on which side of one of two lines it
     * is.
     */
    final boolean near(double computed, double low, double high) {
        return RoundingBound.hides(size, computed, low, high);
    }

    /**
     * The second number where the sign bit is set, else the first: a choice without a branch.
     *
     * @param sign below 0 or not
     */
    static double picked(double first, double second, long sign) {
        long one = Double.doubleToRawLongBits(first);
        long other = Double.doubleToRawLongBits(second);
        return Double.longBitsToDouble(one ^ (one ^ other) & sign >> 63);
    }

    /** The coordinate where it is in lo..hi, else the nearer of the two. */
    static double clamped(double coordinate, double lo, double hi) {
        return Math.max(lo, Math.min(hi, coordinate));
    }

    /**
     * Sends the part from t = {@code enter} to {@code leave}, moved into the window; an end stays
     * as it is where its t is 0 or 1.
     */
    final void sendPart(double enter, double leave, SegmentSink out) {
        double back = 1 - leave;
        out.segment(
                clamped(x0 + enter * dx, xmin, xmax),
                clamped(y0 + enter * dy, ymin, ymax),
                clamped(x1 - back * dx, xmin, xmax),
                clamped(y1 - back * dy, ymin, ymax));
    }

    /** Sends the same part as it is on the way, before it is moved into the window. */
    final void showPart(double enter, double leave, SegmentSink out) {
        double back = 1 - leave;
        out.segment(x0 + enter * dx, y0 + enter * dy, x1 - back * dx, y1 - back * dy);
    }

    @Override
    public final boolean unsure() {
        return unsure;
    }

    @Override
    public final int divisions() {
        return divisions;
    }

    @Override
    public final void send(SegmentSink out) {
        if (unsure) sendUnrounded(out);
        else if (kept()) sendKept(out);
    }

    /** Sends what is left where the walk is sure and has ended. */
    void sendKept(SegmentSink out) {
        piece(out);
    }

    /** Computes all again without rounding, and checks the numbers. */
    void sendUnrounded(SegmentSink out) {
        UnroundedClip.clip(xmin, ymin, xmax, ymax, x0, y0, x1, y1, out);
    }

    /** Whether something is left, where the walk is sure. */
    abstract boolean kept();
}
