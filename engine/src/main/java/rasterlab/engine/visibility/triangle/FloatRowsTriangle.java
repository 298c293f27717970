package rasterlab.engine.visibility.triangle;

import rasterlab.contract.DepthTriangleFiller;

/** Depths are stepped along each row in float: every sum rounds, and they drift. */
final class FloatRowsTriangle implements DepthTriangleFiller {
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
        float step = (float) plane.perColumn();
        var rows = new RowsTriangle.Rows(x, y, width, height);
        while (rows.advance()) {
            float depth = (float) plane.depth(rows.from(), rows.row());
            int end = rows.row() * width + rows.to();
            for (int at = rows.row() * width + rows.from(); at < end; at++) {
                if (depth < depths[at]) {
                    depths[at] = depth;
                    shown[at] = number;
                }
                depth += step;
            }
        }
    }
}
