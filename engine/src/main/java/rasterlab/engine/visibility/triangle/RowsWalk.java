package rasterlab.engine.visibility.triangle;

/**
 * The pixels of a triangle in a picture with their depths, row by row from left to right.
 *
 * <p>A row begins with the depth at its first pixel's centre; from then on each depth is the one
 * before and ∂z/∂x.
 */
final class RowsWalk {
    private final TrianglePlane plane;
    private final TriangleRows rows;
    private final double step;
    private int x;
    private int end;
    private double depth;

    RowsWalk(double[] x, double[] y, double[] z, int width, int height) {
        plane = new TrianglePlane(x, y, z);
        rows = new TriangleRows(x, y, width, height);
        step = plane.perColumn();
    }

    /** Goes on to the next pixel; false where there is none. */
    boolean advance() {
        if (++x < end) {
            depth += step;
            return true;
        }
        if (plane.area() == 0 || !rows.advance()) return false;
        x = rows.from();
        end = rows.to();
        depth = plane.depth(x, rows.row());
        return true;
    }

    int x() {
        return x;
    }

    int y() {
        return rows.row();
    }

    double depth() {
        return depth;
    }
}
