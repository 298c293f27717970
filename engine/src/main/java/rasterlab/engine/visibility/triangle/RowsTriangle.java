package rasterlab.engine.visibility.triangle;

import rasterlab.contract.DepthTriangleFiller;

/**
 * Each row begins with the depth at its first pixel's centre and steps on by ∂z/∂x.
 *
 * <p>Source: E. Catmull, A subdivision algorithm for computer display of curved surfaces, PhD
 * thesis, University of Utah, 1974.
 */
final class RowsTriangle implements DepthTriangleFiller {
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
        var walk = new DepthTriangleWalk(x, y, z, width, height);
        while (walk.advance()) {
            int at = walk.y() * width + walk.x();
            if (!(walk.depth() < depths[at])) continue;
            depths[at] = walk.depth();
            shown[at] = number;
        }
    }

    /**
     * The pixels of a triangle in a picture with their depths, row by row from left to right.
     *
     * <p>A row begins with the depth at its first pixel's centre; from then on each depth is the
     * one before and ∂z/∂x.
     */
    static final class DepthTriangleWalk {
        private final TrianglePlane plane;
        private final Rows rows;
        private final double step;
        private int x;
        private int end;
        private double depth;

        DepthTriangleWalk(double[] x, double[] y, double[] z, int width, int height) {
            plane = new TrianglePlane(x, y, z);
            rows = new Rows(x, y, width, height);
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

    /**
     * The rows of a triangle in a picture, each from its first pixel to the one after its last.
     *
     * <p>An edge from row y₀ to y₁ crosses row y where (y₀ ≤ y) ≠ (y₁ ≤ y), at X = x₀ + (y − y₀)(x₁
     * − x₀)/(y₁ − y₀); the pixels are those from ⌈X⌉ of the left crossing to before ⌈X⌉ of the
     * right one. Corners on multiples of 1/256 make the product exact, so that ⌈X⌉ is.
     */
    static final class Rows {
        private final double[] x;
        private final double[] y;
        private final int width;
        private final int height;
        private int row;
        private double left;
        private double right;

        Rows(double[] x, double[] y, int width, int height) {
            this.x = x;
            this.y = y;
            this.width = width;
            this.height = height;
            double top = Math.min(y[0], Math.min(y[1], y[2]));
            row = (int) Math.max(0, Math.ceil(top)) - 1;
        }

        /** Goes on to the next row with pixels in the picture; false where there is none. */
        boolean advance() {
            double bottom = Math.max(y[0], Math.max(y[1], y[2]));
            while (++row < height && row < bottom) {
                cross();
                if (from() < to()) return true;
            }
            return false;
        }

        private void cross() {
            left = Double.POSITIVE_INFINITY;
            right = Double.NEGATIVE_INFINITY;
            for (int i = 0; i < 3; i++) {
                int j = (i + 1) % 3;
                if (y[i] <= row == y[j] <= row) continue;
                double at = x[i] + (row - y[i]) * (x[j] - x[i]) / (y[j] - y[i]);
                left = Math.min(left, at);
                right = Math.max(right, at);
            }
        }

        int row() {
            return row;
        }

        /** Where the left edge crosses the row. */
        double left() {
            return left;
        }

        /** The first column. */
        int from() {
            return (int) Math.max(0, Math.ceil(left));
        }

        /** The column after the last. */
        int to() {
            return (int) Math.min(width, Math.ceil(right));
        }
    }
}
