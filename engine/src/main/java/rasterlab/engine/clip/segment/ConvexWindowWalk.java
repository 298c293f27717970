package rasterlab.engine.clip.segment;

import java.math.BigDecimal;
import rasterlab.contract.SegmentSink;
import rasterlab.engine.clip.UnroundedInterval;
import rasterlab.engine.range.Finite;

/**
 * The steps of {@link CyrusBeck} in any convex window, one edge per step.
 *
 * <p>inside = n·(p0 − c) and rate = n·(p1 − p0) are sums of two products each; both err by less
 * than 2⁻⁵⁰ of what the products' sizes add up to. So the segment is handed over where that may
 * change on which side of an edge an end lies, or move a t between 0 and 1 by more than {@value
 * #MOST_SHIFT}, or an end by as much of the window's size.
 */
final class ConvexWindowWalk extends WindowWalk {
    private static final double ROUNDING = 0x1p-50;
    private static final double MOST_SHIFT = 0x1p-42;
    private static final double SURE = 4 * MOST_SHIFT;
    private static final double SMALLEST = 0x1p-900;

    private final double[] corners;
    private double enter;
    private double leave = 1;
    private double t = Double.NaN;
    private int edges;

    /** The window's sides here are those of the rectangle around the corners. */
    private ConvexWindowWalk(
            double[] corners, ClipWindow around, double x0, double y0, double x1, double y1) {
        super(around.xmin(), around.ymin(), around.xmax(), around.ymax(), x0, y0, x1, y1);
        this.corners = corners;
    }

    /**
     * @param corners of a convex window, counter-clockwise, none on a straight edge
     */
    static ConvexWindowWalk of(double[] corners, double x0, double y0, double x1, double y1) {
        double xmin = corners[0];
        double ymin = corners[1];
        double xmax = xmin;
        double ymax = ymin;
        for (int i = 2; i < corners.length; i += 2) {
            xmin = Math.min(xmin, corners[i]);
            xmax = Math.max(xmax, corners[i]);
            ymin = Math.min(ymin, corners[i + 1]);
            ymax = Math.max(ymax, corners[i + 1]);
        }
        return new ConvexWindowWalk(
                corners, new ClipWindow(xmin, ymin, xmax, ymax), x0, y0, x1, y1);
    }

    @Override
    public boolean advance() {
        if (2 * edges == corners.length || enter > leave || unsure()) return false;
        cut(2 * edges++);
        boolean over = 2 * edges == corners.length || enter > leave;
        if (over && Math.abs(leave - enter) <= SURE) handOver();
        return true;
    }

    private void cut(int edge) {
        int next = (edge + 2) % corners.length;
        double normalX = corners[edge + 1] - corners[next + 1];
        double normalY = corners[next] - corners[edge];
        double insideX = normalX * (x0 - corners[edge]);
        double insideY = normalY * (y0 - corners[edge + 1]);
        double rateX = normalX * dx;
        double rateY = normalY * dy;
        double inside = insideX + insideY;
        double rate = rateX + rateY;
        double sizes = Math.abs(insideX) + Math.abs(insideY) + Math.abs(rateX) + Math.abs(rateY);
        t = Double.NaN;
        if (hidden(inside, rate, sizes)) {
            handOver();
            return;
        }
        boolean fromInside = inside > 0;
        boolean toInside = inside + rate > 0;
        if (!fromInside && !toInside) leave = Double.NEGATIVE_INFINITY;
        if (fromInside == toInside) return;
        t = -inside / rate;
        divisions++;
        if (toInside) enter = Math.max(enter, t);
        else leave = Math.min(leave, t);
    }

    /** Whether rounding may change a sign, or shift a crossing between the ends too far. */
    private boolean hidden(double inside, double rate, double sizes) {
        double error = 2 * ROUNDING * sizes;
        // Written so that NaN makes it true.
        boolean signs =
                sizes >= SMALLEST && Math.abs(inside) > error && Math.abs(inside + rate) > error;
        if (!signs) return true;
        if (inside > 0 == inside + rate > 0) return false;
        double reach = Math.max(Math.max(Math.abs(dx), Math.abs(dy)) / size, 1);
        return reach * error > MOST_SHIFT * Math.abs(rate);
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
    void sendUnrounded(SegmentSink out) {
        Finite.require("x of end", x0, x1);
        Finite.require("y of end", y0, y1);
        var left = new UnroundedInterval();
        for (int edge = 0; edge < corners.length; edge += 2)
            if (!left.cut(distance(edge, x0, y0), distance(edge, x1, y1))) return;
        out.segment(
                left.atEnter(x0, x1),
                left.atEnter(y0, y1),
                left.atLeave(x0, x1),
                left.atLeave(y0, y1));
    }

    /** n·(p − c) of an edge, without rounding. */
    private BigDecimal distance(int edge, double x, double y) {
        int next = (edge + 2) % corners.length;
        BigDecimal normalX = UnroundedInterval.difference(corners[edge + 1], corners[next + 1]);
        BigDecimal normalY = UnroundedInterval.difference(corners[next], corners[edge]);
        BigDecimal byX = normalX.multiply(UnroundedInterval.difference(x, corners[edge]));
        return byX.add(normalY.multiply(UnroundedInterval.difference(y, corners[edge + 1])));
    }

    @Override
    public String at() {
        if (edges == 0) return "";
        return "edge from (" + corners[2 * edges - 2] + ", " + corners[2 * edges - 1] + ")";
    }

    @Override
    public double decision() {
        return t;
    }
}
