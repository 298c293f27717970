package rasterlab.engine.clip.segment;

import java.util.List;
import rasterlab.contract.SegmentClipper;
import rasterlab.contract.SegmentSink;
import rasterlab.engine.study.Slip;

/** Segments that are cut at the wrong point, not at all or too seldom. */
final class SegmentClipSlips {
    private SegmentClipSlips() {}

    static List<Slip<SegmentClipper>> of(SegmentClipper right) {
        return List.of(
                Slip.of(
                        "right-does-not-cut",
                        (xmin, ymin, xmax, ymax, x0, y0, x1, y1, out) ->
                                right.clip(
                                        xmin,
                                        ymin,
                                        Math.max(xmax, Math.max(x0, x1)),
                                        ymax,
                                        x0,
                                        y0,
                                        x1,
                                        y1,
                                        out)),
                Slip.of(
                        "whole-where-any-is-inside",
                        (xmin, ymin, xmax, ymax, x0, y0, x1, y1, out) ->
                                right.clip(
                                        xmin,
                                        ymin,
                                        xmax,
                                        ymax,
                                        x0,
                                        y0,
                                        x1,
                                        y1,
                                        (ax, ay, bx, by) -> out.segment(x0, y0, x1, y1))),
                Slip.of(
                        "cut-is-dropped",
                        (xmin, ymin, xmax, ymax, x0, y0, x1, y1, out) -> {
                            var window = new Window(xmin, ymin, xmax, ymax);
                            if ((window.code(x0, y0) | window.code(x1, y1)) == 0)
                                out.segment(x0, y0, x1, y1);
                        }),
                Slip.of(
                        "x-y-swapped",
                        (xmin, ymin, xmax, ymax, x0, y0, x1, y1, out) ->
                                right.clip(
                                        xmin,
                                        ymin,
                                        xmax,
                                        ymax,
                                        x0,
                                        y0,
                                        x1,
                                        y1,
                                        (ax, ay, bx, by) -> out.segment(ay, ax, by, bx))),
                Slip.of("each-end-cut-once", SegmentClipSlips::onceEach),
                Slip.of("slope-upside-down", byCodes((dx, dy) -> dx / dy, false)),
                Slip.of("cut-from-the-other-end", byCodes((dx, dy) -> dy / dx, true)));
    }

    private interface Slope {
        double of(double dx, double dy);
    }

    private record Window(double xmin, double ymin, double xmax, double ymax) {
        /** Bits 1, 2, 4 and 8 for left, right, below and above. */
        int code(double x, double y) {
            int code = x < xmin ? 1 : x > xmax ? 2 : 0;
            return code + (y < ymin ? 4 : y > ymax ? 8 : 0);
        }

        /**
         * The point in which an end with that code is cut.
         *
         * @param other whether the other end's place is added to the step
         */
        double[] cut(double[] end, double[] far, int code, Slope slope, boolean other) {
            double[] from = other ? far : end;
            if ((code & 3) != 0) {
                double x = (code & 1) != 0 ? xmin : xmax;
                double by = slope.of(far[0] - end[0], far[1] - end[1]);
                return new double[] {x, from[1] + (x - end[0]) * by};
            }
            double y = (code & 4) != 0 ? ymin : ymax;
            double by = slope.of(far[1] - end[1], far[0] - end[0]);
            return new double[] {from[0] + (y - end[1]) * by, y};
        }
    }

    private static void onceEach(
            double xmin,
            double ymin,
            double xmax,
            double ymax,
            double x0,
            double y0,
            double x1,
            double y1,
            SegmentSink out) {
        var window = new Window(xmin, ymin, xmax, ymax);
        double[] a = {x0, y0};
        double[] b = {x1, y1};
        int codeA = window.code(x0, y0);
        int codeB = window.code(x1, y1);
        if ((codeA & codeB) != 0) return;
        Slope slope = (dx, dy) -> dy / dx;
        double[] from = codeA == 0 ? a : window.cut(a, b, codeA, slope, false);
        double[] to = codeB == 0 ? b : window.cut(b, a, codeB, slope, false);
        out.segment(from[0], from[1], to[0], to[1]);
    }

    /** Cohen and Sutherland's way with another point to cut in; gives up after eight cuts. */
    private static SegmentClipper byCodes(Slope slope, boolean other) {
        return (xmin, ymin, xmax, ymax, x0, y0, x1, y1, out) -> {
            var window = new Window(xmin, ymin, xmax, ymax);
            double[] a = {x0, y0};
            double[] b = {x1, y1};
            for (int cuts = 0; cuts < 8; cuts++) {
                int codeA = window.code(a[0], a[1]);
                int codeB = window.code(b[0], b[1]);
                if ((codeA & codeB) != 0) return;
                if ((codeA | codeB) == 0) {
                    out.segment(a[0], a[1], b[0], b[1]);
                    return;
                }
                if (codeA != 0) a = window.cut(a, b, codeA, slope, other);
                else b = window.cut(b, a, codeB, slope, other);
            }
        };
    }
}
