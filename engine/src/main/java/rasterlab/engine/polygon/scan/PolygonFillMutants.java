package rasterlab.engine.polygon.scan;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import rasterlab.contract.FillRule;
import rasterlab.contract.PolygonFiller;
import rasterlab.contract.Spans;
import rasterlab.engine.study.Mutant;

/** Polygons filled with one mistake. */
final class PolygonFillMutants {
    private static final PolygonFiller RIGHT = new ScanlinePolygon();
    private static final int ASIDE = 64;

    /** The rule: an edge owns the row of its upper end, not that of its lower one. */
    private static final Crosses OWN = (y, y0, y1) -> y0 <= y && y < y1;

    private static final Rounding NEAREST = x -> Math.floor(x + 0.5);

    private PolygonFillMutants() {}

    static List<Mutant<PolygonFiller>> all() {
        return Stream.of(ofRules(), ofRounding()).flatMap(List::stream).toList();
    }

    private static List<Mutant<PolygonFiller>> ofRules() {
        return List.of(
                new Mutant<>(
                        "right-edge-included",
                        "corners-on-centres",
                        plain(OWN, (l, r) -> (int) Math.floor(r) + 1)),
                new Mutant<>(
                        "both-edge-ends",
                        "corner-on-the-left",
                        plain((y, y0, y1) -> y0 <= y && y <= y1, (l, r) -> (int) Math.ceil(r))),
                new Mutant<>(
                        "lower-edge-end",
                        "level-edges",
                        plain((y, y0, y1) -> y0 < y && y <= y1, (l, r) -> (int) Math.ceil(r))),
                new Mutant<>(
                        "always-even-odd",
                        "star-non-zero",
                        (x, y, rule, w, h, out) -> RIGHT.fill(x, y, FillRule.EVEN_ODD, w, h, out)),
                new Mutant<>(
                        "always-non-zero",
                        "star-even-odd",
                        (x, y, rule, w, h, out) -> RIGHT.fill(x, y, FillRule.NON_ZERO, w, h, out)),
                new Mutant<>(
                        "left-not-cut", "left-of-the-picture", PolygonFillMutants::notCutAtTheLeft),
                new Mutant<>("rows-upwards", "rows-from-the-top", PolygonFillMutants::upwards),
                new Mutant<>(
                        "crossings-in-double",
                        "far-corners",
                        plain(OWN, (l, r) -> (int) Math.ceil(r))),
                new Mutant<>(
                        "two-corners-drawn",
                        "two-corners",
                        (x, y, rule, w, h, out) -> {
                            if (x.length == 2) line(x, y, w, h, out);
                            else RIGHT.fill(x, y, rule, w, h, out);
                        }),
                new Mutant<>(
                        "last-edge-missing", "star-even-odd", PolygonFillMutants::openOutline));
    }

    /** Rows and columns that are rounded otherwise than up. */
    private static List<Mutant<PolygonFiller>> ofRounding() {
        Crosses floors = (y, y0, y1) -> Math.floor(y0) <= y && y < Math.floor(y1);
        Rounding up = Math::ceil;
        Rounding down = Math::floor;
        return List.of(
                new Mutant<>("columns-by-floor", "rows-from-the-top", plain(OWN, down, down)),
                new Mutant<>("left-by-floor", "rows-from-the-top", plain(OWN, down, up)),
                new Mutant<>("columns-rounded", "rows-from-the-top", plain(OWN, NEAREST, NEAREST)),
                new Mutant<>("rows-by-floor", "rows-from-the-top", plain(floors, up, up)),
                new Mutant<>(
                        "rows-and-columns-by-floor",
                        "rows-from-the-top",
                        plain(floors, down, down)));
    }

    private static void notCutAtTheLeft(
            double[] x, double[] y, FillRule rule, int width, int height, Spans out) {
        double[] aside = Arrays.stream(x).map(each -> each + ASIDE).toArray();
        RIGHT.fill(
                aside,
                y,
                rule,
                width + ASIDE,
                height,
                (row, from, to) -> out.span(row, from - ASIDE, to - ASIDE));
    }

    private static void upwards(
            double[] x, double[] y, FillRule rule, int width, int height, Spans out) {
        var spans = new ArrayList<int[]>();
        RIGHT.fill(
                x, y, rule, width, height, (row, from, to) -> spans.add(new int[] {row, from, to}));
        Collections.reverse(spans);
        for (int[] span : spans) out.span(span[0], span[1], span[2]);
    }

    /** Fills in each row between the two corners the pixel that is nearest to their line. */
    private static void line(double[] x, double[] y, int width, int height, Spans out) {
        double last = Math.min(height - 1, Math.max(y[0], y[1]));
        for (int row = (int) Math.max(0, Math.ceil(Math.min(y[0], y[1]))); row <= last; row++) {
            double share = y[0] == y[1] ? 0 : (row - y[0]) / (y[1] - y[0]);
            int column = (int) Math.rint(x[0] + share * (x[1] - x[0]));
            if (column >= 0 && column < width) out.span(row, column, column + 1);
        }
    }

    private interface Crosses {
        boolean row(int y, double y0, double y1);
    }

    private interface Ends {
        int before(double left, double right);
    }

    private interface Rounding {
        double of(double crossing);
    }

    private record Crossing(double at, int direction) {}

    private static PolygonFiller plain(Crosses crosses, Ends ends) {
        return plain(crosses, Math::ceil, ends);
    }

    private static PolygonFiller plain(Crosses crosses, Rounding left, Rounding right) {
        return plain(crosses, left, (l, r) -> (int) right.of(r));
    }

    /** A plain filler: the crossings of each row, sorted, and where their sum is inside. */
    private static PolygonFiller plain(Crosses crosses, Rounding first, Ends ends) {
        return (x, y, rule, width, height, out) -> {
            for (int row = 0; row < height; row++) {
                var crossings = new ArrayList<Crossing>();
                for (int i = 0; i < x.length; i++) {
                    int j = (i + 1) % x.length;
                    if (y[i] == y[j]) continue;
                    if (!crosses.row(row, Math.min(y[i], y[j]), Math.max(y[i], y[j]))) continue;
                    double at = x[i] + (row - y[i]) * (x[j] - x[i]) / (y[j] - y[i]);
                    crossings.add(new Crossing(at, y[i] < y[j] ? 1 : -1));
                }
                crossings.sort(Comparator.comparingDouble(Crossing::at));
                spans(crossings, rule, first, ends, row, width, out);
            }
        };
    }

    private static void spans(
            List<Crossing> crossings,
            FillRule rule,
            Rounding first,
            Ends ends,
            int row,
            int width,
            Spans out) {
        int sum = 0;
        double left = 0;
        for (Crossing one : crossings) {
            boolean before = rule.inside(sum);
            sum += one.direction();
            if (before == rule.inside(sum)) continue;
            if (!before) {
                left = one.at();
                continue;
            }
            int from = Math.max(0, (int) first.of(left));
            int to = Math.min(width, ends.before(left, one.at()));
            if (from < to) out.span(row, from, to);
        }
    }

    /** Leaves out the edge from the last corner to the first. */
    private static void openOutline(
            double[] x, double[] y, FillRule rule, int width, int height, Spans out) {
        for (int row = 0; row < height; row++) {
            var crossings = new ArrayList<Crossing>();
            for (int i = 0; i + 1 < x.length; i++) {
                if (y[i] <= row == y[i + 1] <= row) continue;
                double at = x[i] + (row - y[i]) * (x[i + 1] - x[i]) / (y[i + 1] - y[i]);
                crossings.add(new Crossing(at, y[i] < y[i + 1] ? 1 : -1));
            }
            crossings.sort(Comparator.comparingDouble(Crossing::at));
            spans(crossings, rule, Math::ceil, (l, r) -> (int) Math.ceil(r), row, width, out);
        }
    }
}
