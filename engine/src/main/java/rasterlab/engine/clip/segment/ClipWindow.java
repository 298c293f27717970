package rasterlab.engine.clip.segment;

import rasterlab.engine.clip.RectangleSides;

/**
 * The points with xmin ≤ x ≤ xmax and ymin ≤ y ≤ ymax; it may have no width or no height or
 * neither.
 */
public record ClipWindow(double xmin, double ymin, double xmax, double ymax) {
    /** A 1024th of the largest coordinate, below which doubles are too sparse to be compared. */
    private static final double SPARSE = 1.0 / 1024;

    public ClipWindow {
        RectangleSides.requireOrdered(xmin, ymin, xmax, ymax);
    }

    /**
     * Which sides a point lies beyond, added up: 1 above, 2 below, 4 right, 8 left. 0 in the window
     * and on its sides; NaN is beyond none.
     */
    public int code(double x, double y) {
        return (y > ymax ? CohenSutherland.TOP : 0)
                | (y < ymin ? CohenSutherland.BOTTOM : 0)
                | (x > xmax ? CohenSutherland.RIGHT : 0)
                | (x < xmin ? CohenSutherland.LEFT : 0);
    }

    /** The sides as an array: xmin, ymin, xmax, ymax. */
    public double[] sides() {
        return new double[] {xmin, ymin, xmax, ymax};
    }

    /**
     * The unit of errors: the larger extent, or a 1024th of the largest coordinate where that is
     * more, so that 10⁻¹² of it is never less than four steps between doubles.
     */
    public double unit() {
        double far = 0;
        for (double side : sides()) far = Math.max(far, Math.abs(side));
        double width = xmax / 2 - xmin / 2;
        double height = ymax / 2 - ymin / 2;
        return Math.max(2 * Math.min(Math.max(width, height), Double.MAX_VALUE / 2), far * SPARSE);
    }

    @Override
    public String toString() {
        return "[" + xmin + ", " + xmax + "] × [" + ymin + ", " + ymax + "]";
    }
}
