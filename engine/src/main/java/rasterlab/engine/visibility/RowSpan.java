package rasterlab.engine.visibility;

/**
 * The pixels of one row that a convex polygon owns: those from ⌈left⌉ to before ⌈right⌉.
 *
 * <p>A crossing with an edge is computed from its upper end to its lower one, so two polygons that
 * share an edge get bit-equal numbers and own each pixel once. An edge owns the row of its upper
 * end and not that of its lower one.
 */
public final class RowSpan {
    private double left;
    private double right;

    /** Takes the corners [first, end) of a polygon where it crosses a row. */
    public void load(double[] x, double[] y, int first, int end, int row) {
        left = Double.POSITIVE_INFINITY;
        right = Double.NEGATIVE_INFINITY;
        for (int k = first, p = end - 1; k < end; p = k++) {
            int upper = y[p] < y[k] ? p : k;
            int lower = upper == p ? k : p;
            if (row < y[upper] || row >= y[lower]) continue;
            double slope = (x[lower] - x[upper]) / (y[lower] - y[upper]);
            double crossing = x[upper] + (row - y[upper]) * slope;
            left = Math.min(left, crossing);
            right = Math.max(right, crossing);
        }
    }

    /** The first owned column from {@code least} on. */
    public int from(int least) {
        return (int) Math.max(least, Math.ceil(left));
    }

    /** The column after the last owned one, up to {@code most}. */
    public int to(int most) {
        return (int) Math.min(most, Math.ceil(right));
    }
}
