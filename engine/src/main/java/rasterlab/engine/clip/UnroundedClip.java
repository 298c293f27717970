package rasterlab.engine.clip;

import rasterlab.contract.SegmentSink;

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
        FiniteNumbers.requireOrdered("xmin", xmin, "xmax", xmax);
        FiniteNumbers.requireOrdered("ymin", ymin, "ymax", ymax);
        FiniteNumbers.require("x0", x0);
        FiniteNumbers.require("y0", y0);
        FiniteNumbers.require("x1", x1);
        FiniteNumbers.require("y1", y1);
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
