package rasterlab.engine.polygon.scan;

import java.util.ArrayList;
import java.util.List;
import rasterlab.engine.geometry.Orientation;
import rasterlab.engine.range.Bounds;

/**
 * An edge of a polygon that is not level, from its upper end down, in pixel coordinates.
 *
 * <p>It crosses row y when upperY ≤ y &lt; lowerY, at X = upperX + (y − upperY)·dx/dy. A column c
 * is reached when X ≤ c, that is when E = (c − upperX)·dy − (y − upperY)·dx ≥ 0. {@link
 * Orientation} computes −E as it stands and tells its sign without error.
 *
 * @param winding 1 where the outline follows the edge downward, −1 where upward
 */
record PolygonEdge(double upperX, double upperY, double lowerX, double lowerY, int winding) {
    PolygonEdge {
        Bounds.requireSign("winding", winding);
    }

    /** The edges that cross a row from 0 to {@code height} − 1. */
    static List<PolygonEdge> crossing(double[] x, double[] y, int height) {
        var edges = new ArrayList<PolygonEdge>();
        for (int i = 0, before = x.length - 1; i < x.length; before = i++) {
            boolean down = y[before] < y[i];
            int upper = down ? before : i;
            int lower = down ? i : before;
            var edge = new PolygonEdge(x[upper], y[upper], x[lower], y[lower], down ? 1 : -1);
            if (edge.firstRow() < edge.endRow(height)) edges.add(edge);
        }
        return edges;
    }

    /** The first row of the picture that the edge crosses, if it crosses any. */
    int firstRow() {
        return (int) Math.max(0, Math.ceil(upperY));
    }

    /** The row after the last one it crosses. */
    int endRow(int height) {
        return (int) Math.min(height, Math.ceil(lowerY));
    }

    /** Whether the edge crosses this row at or left of this column. */
    boolean reaches(int column, int row) {
        return Orientation.of(upperX, upperY, lowerX, lowerY, column, row) <= 0;
    }

    /** The first column from 0 to {@code width} − 1 that is reached; {@code width} if none is. */
    int firstColumn(int row, int width) {
        int guess = (int) Math.max(0, Math.min(width, Math.ceil(x(row))));
        boolean notLater = guess == width || reaches(guess, row);
        boolean notEarlier = guess == 0 || !reaches(guess - 1, row);
        return notLater && notEarlier ? guess : searched(row, width);
    }

    /** X there, rounded. */
    private double x(int row) {
        double slope = (lowerX - upperX) / (lowerY - upperY);
        return upperX + (row - upperY) * slope;
    }

    RowCrossing crossing(int row, int width) {
        return new RowCrossing(
                upperX, upperY, lowerX, lowerY, x(row), firstColumn(row, width), winding);
    }

    private int searched(int row, int width) {
        int low = 0;
        int high = width;
        while (low < high) {
            int middle = (low + high) / 2;
            if (reaches(middle, row)) high = middle;
            else low = middle + 1;
        }
        return low;
    }
}
