package rasterlab.engine.transform.chain;

import rasterlab.engine.transform.Coordinates;

/** Checks what every method demands of its arguments and of its answer. */
final class ChainCheck {
    private ChainCheck() {}

    static void require(int dimension, double[][] matrices, double[] points, double[] h) {
        if (dimension != 2 && dimension != 3)
            throw new IllegalArgumentException("dimension must be 2 or 3, got " + dimension);
        for (int i = 0; i < matrices.length; i++) requireMatrix(dimension + 1, matrices[i], i);
        Coordinates.require(points, dimension, Coordinates.LARGEST);
        if (h.length != points.length / dimension)
            throw new IllegalArgumentException(
                    "h must have one number per point, %d, got %d"
                            .formatted(points.length / dimension, h.length));
        for (int i = 0; i < h.length; i++)
            if (!(Math.abs(h[i]) <= Coordinates.LARGEST))
                throw new IllegalArgumentException(
                        "h[%d] must be a finite number from %s to %s, got %s"
                                .formatted(i, -Coordinates.LARGEST, Coordinates.LARGEST, h[i]));
    }

    private static void requireMatrix(int size, double[] cells, int i) {
        if (cells.length != size * size)
            throw new IllegalArgumentException(
                    "matrices[%d] must have %d cells for these points, got %d"
                            .formatted(i, size * size, cells.length));
        for (int c = 0; c < cells.length; c++)
            if (!Double.isFinite(cells[c]))
                throw new IllegalArgumentException(
                        "matrices[%d], row %d, column %d must be a finite number, got %s"
                                .formatted(i, c / size + 1, c % size + 1, cells[c]));
    }

    /** Passes if the product of the matrices fits into its type. */
    static void requireProduct(double[] product) {
        for (double cell : product)
            if (!Double.isFinite(cell))
                throw new IllegalArgumentException(
                        "the product of the matrices is too large, an entry became " + cell);
    }

    /**
     * Passes if {@code a·b} is not so small that it loses digits; to be asked where a sum of such
     * products is itself that small.
     */
    static void requireKept(double a, double b, double smallest) {
        if (a != 0 && b != 0 && Math.abs(a * b) < smallest)
            throw new IllegalArgumentException(
                    "the product of %s and %s is too small for the method's numbers, below %s"
                            .formatted(a, b, smallest));
    }

    /** Checks the same for the matrix's last row, which a plain point takes as it is. */
    static void requireShiftKept(double h, double cell, double smallest) {
        if (h != 1) requireKept(h, cell, smallest);
    }

    static IllegalArgumentException tooLarge(int point) {
        return new IllegalArgumentException(
                "points[" + point + "]: its image is too large for the method's numbers");
    }
}
