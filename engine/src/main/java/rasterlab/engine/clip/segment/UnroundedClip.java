package rasterlab.engine.clip.segment;

import rasterlab.contract.SegmentSink;
import rasterlab.engine.clip.RectangleSides;
import rasterlab.engine.clip.UnroundedInterval;
import rasterlab.engine.range.Finite;

/** Clips a plane segment without rounding before its last step; about a hundred times slower. */
final class UnroundedClip {
    private UnroundedClip() {}

    /**
     * Checks all numbers, then does what {@link rasterlab.contract.SegmentClipper} says.
     *
     * @throws IllegalArgumentException if a number is not finite or the window's sides are swapped
     */
    static void clip(
            double xmin,
            double ymin,
            double xmax,
            double ymax,
            double x0,
            double y0,
            double x1,
            double y1,
            SegmentSink out) {
        RectangleSides.requireOrdered(xmin, ymin, xmax, ymax);
        Finite.require("x of end", x0, x1);
        Finite.require("y of end", y0, y1);
        boolean beyondOneSide =
                Math.max(x0, x1) < xmin
                        || Math.min(x0, x1) > xmax
                        || Math.max(y0, y1) < ymin
                        || Math.min(y0, y1) > ymax;
        if (beyondOneSide) return;
        var left = new UnroundedInterval();
        if (left.cutBelow(x0, x1, xmin)
                && left.cutAbove(x0, x1, xmax)
                && left.cutBelow(y0, y1, ymin)
                && left.cutAbove(y0, y1, ymax))
            out.segment(
                    left.atEnter(x0, x1),
                    left.atEnter(y0, y1),
                    left.atLeave(x0, x1),
                    left.atLeave(y0, y1));
    }
}
