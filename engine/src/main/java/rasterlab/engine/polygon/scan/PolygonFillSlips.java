package rasterlab.engine.polygon.scan;

import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import rasterlab.contract.FillRule;
import rasterlab.contract.PolygonFiller;
import rasterlab.contract.Spans;
import rasterlab.engine.study.Slip;

/** Polygons filled at another place, by half of a rule, or with runs that end elsewhere. */
final class PolygonFillSlips {
    private PolygonFillSlips() {}

    static List<Slip<PolygonFiller>> of(PolygonFiller right) {
        return List.of(
                Slip.of(
                        "half-a-pixel-on",
                        moved(right, one -> one - 0.5, one -> one - 0.5),
                        moved(right, one -> one + 0.5, one -> one + 0.5),
                        moved(right, one -> one - 0.5, one -> one),
                        moved(right, one -> one, one -> one - 0.5)),
                Slip.of(
                        "vertices-in-whole-numbers",
                        moved(right, Math::floor, Math::floor),
                        moved(right, Math::rint, Math::rint)),
                Slip.of("directions-ignored", PolygonFillSlips::withoutDirections),
                Slip.of(
                        "first-edge-missing",
                        (x, y, rule, width, height, out) ->
                                byEdges(x, y, 1, rule, false, width, height, out)),
                Slip.of(
                        "outside-filled",
                        (x, y, rule, width, height, out) ->
                                byEdges(x, y, 0, rule, true, width, height, out)),
                Slip.of(
                        "last-row-of-picture-left-out",
                        (x, y, rule, width, height, out) ->
                                right.fill(
                                        x,
                                        y,
                                        rule,
                                        width,
                                        height,
                                        (row, from, to) -> {
                                            if (row < height - 1) out.span(row, from, to);
                                        })),
                Slip.of("first-and-last-pixel-alone", ends(right)),
                Slip.of(
                        "length-for-end",
                        changed(
                                right,
                                (row, from, to, out) -> {
                                    if (to - from > from) out.span(row, from, to - from);
                                })),
                Slip.of("y-upwards", PolygonFillSlips::upwards));
    }

    private static PolygonFiller moved(
            PolygonFiller right, DoubleUnaryOperator x, DoubleUnaryOperator y) {
        return (xs, ys, rule, width, height, out) ->
                right.fill(
                        Arrays.stream(xs).map(x).toArray(),
                        Arrays.stream(ys).map(y).toArray(),
                        rule,
                        width,
                        height,
                        out);
    }

    private interface Changed {
        void span(int row, int from, int to, Spans out);
    }

    private static PolygonFiller changed(PolygonFiller right, Changed changed) {
        return (x, y, rule, width, height, out) ->
                right.fill(
                        x,
                        y,
                        rule,
                        width,
                        height,
                        (row, from, to) -> changed.span(row, from, to, out));
    }

    private static PolygonFiller ends(PolygonFiller right) {
        return changed(
                right,
                (row, from, to, out) -> {
                    out.span(row, from, from + 1);
                    if (to - from > 1) out.span(row, to - 1, to);
                });
    }

    /** Row y stands for row height − 1 − y. */
    private static void upwards(
            double[] x, double[] y, FillRule rule, int width, int height, Spans out) {
        byEdges(
                x,
                y,
                0,
                rule,
                false,
                width,
                height,
                (row, from, to) -> out.span(height - 1 - row, from, to));
    }

    private static void withoutDirections(
            double[] x, double[] y, FillRule rule, int width, int height, Spans out) {
        byCrossings(x, y, 0, rule, false, false, width, height, out);
    }

    private static void byEdges(
            double[] x,
            double[] y,
            int first,
            FillRule rule,
            boolean outside,
            int width,
            int height,
            Spans out) {
        byCrossings(x, y, first, rule, outside, true, width, height, out);
    }

    /**
     * Counts crossings along each row.
     *
     * @param first edge, 0 being that from the last vertex to the first
     * @param outside whether the rest of the row is filled
     * @param signed whether edges downwards and upwards count one against the other
     */
    private static void byCrossings(
            double[] x,
            double[] y,
            int first,
            FillRule rule,
            boolean outside,
            boolean signed,
            int width,
            int height,
            Spans out) {
        for (int row = 0; row < height; row++) {
            var changes = new int[width + 1];
            for (int i = first; i < x.length; i++) {
                int j = (i + x.length - 1) % x.length;
                if (y[i] == y[j] || row < Math.min(y[i], y[j]) || row >= Math.max(y[i], y[j]))
                    continue;
                double at = x[j] + (row - y[j]) * (x[i] - x[j]) / (y[i] - y[j]);
                int column = (int) Math.max(0, Math.min(width, Math.ceil(at)));
                changes[column] += signed && y[i] < y[j] ? -1 : 1;
            }
            spans(row, changes, rule, outside, width, out);
        }
    }

    private static void spans(
            int row, int[] changes, FillRule rule, boolean outside, int width, Spans out) {
        int winding = 0;
        int from = -1;
        for (int column = 0; column <= width; column++) {
            winding += changes[column];
            boolean in = column < width && rule.inside(winding) != outside;
            if (in && from < 0) from = column;
            if (in || from < 0) continue;
            out.span(row, from, column);
            from = -1;
        }
    }
}
