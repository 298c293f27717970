package rasterlab.engine.visibility.triangle;

import rasterlab.contract.DepthTriangleFiller;

/**
 * Depths are z₀ + (x − x₀)·∂z/∂x + (y − y₀)·∂z/∂y. On thin triangles the slopes are large, and what
 * they make of rounding does not cancel.
 */
final class SlopesTriangle implements DepthTriangleFiller {
    @Override
    public void fill(
            double[] x,
            double[] y,
            double[] z,
            int number,
            int width,
            int height,
            double[] depths,
            int[] shown) {
        var plane = new TrianglePlane(x, y, z);
        if (plane.area() == 0) return;
        double perColumn = plane.perColumn();
        double perRow = plane.perRow();
        var rows = new RowsTriangle.Rows(x, y, width, height);
        while (rows.advance()) {
            int line = rows.row() * width;
            for (int column = rows.from(); column < rows.to(); column++) {
                double depth = z[0] + (column - x[0]) * perColumn + (rows.row() - y[0]) * perRow;
                if (!(depth < depths[line + column])) continue;
                depths[line + column] = depth;
                shown[line + column] = number;
            }
        }
    }
}
