package rasterlab.engine.polygon.scan;

import java.util.Arrays;
import rasterlab.contract.FillRule;
import rasterlab.contract.PolygonFiller;
import rasterlab.contract.Spans;

/**
 * A polygon row by row as one writes it first, kept because each of its faults teaches a rule.
 *
 * <p>Both ends of an edge count, so a row through a corner meets two edges there and pairs them
 * wrongly. Both ends of a span are rounded and filled, so polygons that share an edge draw its
 * pixels twice. Crossings are paired, so every outline is filled by the even-odd rule.
 */
public final class NaivePolygon implements PolygonFiller {
    @Override
    public void fill(double[] x, double[] y, FillRule rule, int width, int height, Spans out) {
        PolygonCheck.check(x, y, width, height);
        var crossings = new double[x.length];
        for (int row = 0; row < height; row++) {
            int count = cross(x, y, row, crossings);
            Arrays.sort(crossings, 0, count);
            for (int i = 0; i + 1 < count; i += 2) {
                int from = (int) Math.max(0, Math.rint(crossings[i]));
                int last = (int) Math.min(width - 1, Math.rint(crossings[i + 1]));
                if (from <= last) out.span(row, from, last + 1);
            }
        }
    }

    private static int cross(double[] x, double[] y, int row, double[] crossings) {
        int count = 0;
        for (int i = 0, before = x.length - 1; i < x.length; before = i++) {
            if (y[before] == y[i]) continue;
            double share = (row - y[before]) / (y[i] - y[before]);
            if (share >= 0 && share <= 1)
                crossings[count++] = x[before] + share * (x[i] - x[before]);
        }
        return count;
    }
}
