package rasterlab.engine.transform.chain;

import rasterlab.contract.PointTransformer;

/**
 * The matrices multiplied into one, every point multiplied by it, then divided by H.
 *
 * <p>A cell of the product is off by some 2⁻⁵³ of the sum of the magnitudes in it. Where they
 * cancel, in a shift there and back or in H close to 0, that is much of what is left.
 */
final class DoubleTransformer implements PointTransformer {
    private static final double SMALLEST = 0x1p-960;

    @Override
    public void transform(int dimension, double[][] matrices, double[] points, double[] h) {
        ChainCheck.require(dimension, matrices, points, h);
        int size = dimension + 1;
        double[] product = product(size, matrices);
        var image = new double[size];
        for (int i = 0; i < h.length; i++) {
            image(product, points, i * dimension, h[i], image);
            h[i] = image[dimension];
            for (int j = 0; j < dimension; j++) {
                double coordinate = h[i] == 0 ? Double.NaN : image[j] / h[i];
                if (!Double.isFinite(h[i]) || h[i] != 0 && !Double.isFinite(coordinate))
                    throw ChainCheck.tooLarge(i);
                points[i * dimension + j] = coordinate;
            }
        }
    }

    private static double[] product(int size, double[][] matrices) {
        var product = new double[size * size];
        for (int i = 0; i < size; i++) product[i * size + i] = 1;
        var row = new double[size];
        for (double[] matrix : matrices) {
            for (int i = 0; i < size; i++) {
                for (int j = 0; j < size; j++) {
                    double sum = 0;
                    for (int k = 0; k < size; k++)
                        sum += product[i * size + k] * matrix[k * size + j];
                    if (Math.abs(sum) < SMALLEST)
                        for (int k = 0; k < size; k++)
                            ChainCheck.requireKept(
                                    product[i * size + k], matrix[k * size + j], SMALLEST);
                    row[j] = sum;
                }
                System.arraycopy(row, 0, product, i * size, size);
            }
            ChainCheck.requireProduct(product);
        }
        return product;
    }

    /** {@code [point h] · M}. */
    static void image(double[] m, double[] points, int at, double h, double[] image) {
        int size = image.length;
        for (int j = 0; j < size; j++) {
            double sum = 0;
            for (int k = 0; k < size - 1; k++) sum += points[at + k] * m[k * size + j];
            image[j] = sum + h * m[(size - 1) * size + j];
            if (Math.abs(image[j]) < SMALLEST) {
                for (int k = 0; k < size - 1; k++)
                    ChainCheck.requireKept(points[at + k], m[k * size + j], SMALLEST);
                ChainCheck.requireShiftKept(h, m[(size - 1) * size + j], SMALLEST);
            }
        }
    }
}
