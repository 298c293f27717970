package rasterlab.exercises.graded;

import rasterlab.contract.SegmentClipper;
import rasterlab.contract.SegmentSink;

/**
 * Keeps the range of t in which the segment is within all four sides; an end is computed only where
 * a side cuts, and is put on that side.
 *
 * <p>Source: Y.-D. Liang, B. A. Barsky, A new concept and method for line clipping, ACM
 * Transactions on Graphics 3(1), 1984, pp. 1–22.
 */
public final class PlainClip implements SegmentClipper {
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
        double dx = x1 - x0;
        double dy = y1 - y0;
        double[] p = {-dx, dx, -dy, dy};
        double[] q = {x0 - xmin, xmax - x0, y0 - ymin, ymax - y0};
        double from = 0;
        double to = 1;
        for (int side = 0; side < 4; side++) {
            if (p[side] == 0 && q[side] < 0) return;
            if (p[side] < 0) from = Math.max(from, q[side] / p[side]);
            if (p[side] > 0) to = Math.min(to, q[side] / p[side]);
        }
        if (from > to) return;
        double fromX = from == 0 ? x0 : within(xmin, xmax, x0 + from * dx);
        double fromY = from == 0 ? y0 : within(ymin, ymax, y0 + from * dy);
        double toX = to == 1 ? x1 : within(xmin, xmax, x0 + to * dx);
        double toY = to == 1 ? y1 : within(ymin, ymax, y0 + to * dy);
        out.segment(fromX, fromY, toX, toY);
    }

    private static double within(double least, double most, double value) {
        return Math.max(least, Math.min(most, value));
    }
}
