package rasterlab.engine.visibility.triangle;

import rasterlab.contract.DepthTriangleFiller;

/**
 * Each row begins with the depth on its left edge, up to a pixel away from the first centre, as
 * many texts have it; the picture's border makes it worse.
 */
final class LeftEdgeTriangle implements DepthTriangleFiller {
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
        double step = plane.perColumn();
        var rows = new RowsTriangle.Rows(x, y, width, height);
        while (rows.advance()) {
            double depth = plane.depth(rows.left(), rows.row());
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
