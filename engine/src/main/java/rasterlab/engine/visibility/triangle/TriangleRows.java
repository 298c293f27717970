package rasterlab.engine.visibility.triangle;

/**
 * The rows of a triangle in a picture, each from its first pixel to the one after its last.
 *
 * <p>An edge from row y₀ to y₁ crosses row y where (y₀ ≤ y) ≠ (y₁ ≤ y), at X = x₀ + (y − y₀)(x₁ −
 * x₀)/(y₁ − y₀); the pixels are those from ⌈X⌉ of the left crossing to before ⌈X⌉ of the right one.
 * Corners on multiples of 1/256 make the product exact, so that ⌈X⌉ is.
 */
final class TriangleRows {
    private final double[] x;
    private final double[] y;
    private final int width;
    private final int height;
    private int row;
    private double left;
    private double right;

    TriangleRows(double[] x, double[] y, int width, int height) {
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
