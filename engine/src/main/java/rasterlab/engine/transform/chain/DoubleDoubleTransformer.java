package rasterlab.engine.transform.chain;

import rasterlab.contract.PointTransformer;

/**
 * Transforms with numbers of two doubles each: half of the digits may cancel and an image is still
 * right to its last bit.
 *
 * <p>Source: T. J. Dekker, A floating-point technique for extending the available precision,
 * Numerische Mathematik 18, 1971, pp. 224–242.
 */
final class DoubleDoubleTransformer implements PointTransformer {
    private static final double SMALLEST = 0x1p-900;

    @Override
    public void transform(int dimension, double[][] matrices, double[] points, double[] h) {
        ChainCheck.require(dimension, matrices, points, h);
        int size = dimension + 1;
        DoubleDouble[] product = product(size, matrices);
        var image = new DoubleDouble[size];
        for (int i = 0; i < h.length; i++) {
            image(product, points, i * dimension, h[i], image);
            DoubleDouble divisor = image[dimension];
            h[i] = divisor.high();
            for (int j = 0; j < dimension; j++) {
                double coordinate = h[i] == 0 ? Double.NaN : image[j].over(divisor);
                if (!divisor.isFinite() || h[i] != 0 && !Double.isFinite(coordinate))
                    throw ChainCheck.tooLarge(i);
                points[i * dimension + j] = coordinate;
            }
        }
    }

    private static DoubleDouble[] product(int size, double[][] matrices) {
        var product = new DoubleDouble[size * size];
        for (int i = 0; i < product.length; i++)
            product[i] = i / size == i % size ? DoubleDouble.ONE : DoubleDouble.ZERO;
        for (double[] matrix : matrices) product = product(size, product, matrix);
        return product;
    }

    private static DoubleDouble[] product(int size, DoubleDouble[] left, double[] right) {
        var product = new DoubleDouble[size * size];
        for (int i = 0; i < product.length; i++) {
            DoubleDouble sum = DoubleDouble.ZERO;
            for (int k = 0; k < size; k++)
                sum = sum.plus(left[i / size * size + k].times(right[k * size + i % size]));
            ChainCheck.requireProduct(new double[] {sum.high(), sum.low()});
            if (Math.abs(sum.high()) < SMALLEST)
                for (int k = 0; k < size; k++)
                    ChainCheck.requireKept(
                            left[i / size * size + k].high(), right[k * size + i % size], SMALLEST);
            product[i] = sum;
        }
        return product;
    }

    /** {@code [point h] · M}. */
    private static void image(
            DoubleDouble[] m, double[] points, int at, double h, DoubleDouble[] image) {
        int size = image.length;
        for (int j = 0; j < size; j++) {
            DoubleDouble sum = DoubleDouble.ZERO;
            for (int k = 0; k < size - 1; k++)
                sum = sum.plus(m[k * size + j].times(points[at + k]));
            DoubleDouble shift = m[(size - 1) * size + j];
            sum = sum.plus(h == 1 ? shift : shift.times(h));
            if (Math.abs(sum.high()) < SMALLEST) {
                for (int k = 0; k < size - 1; k++)
                    ChainCheck.requireKept(points[at + k], m[k * size + j].high(), SMALLEST);
                ChainCheck.requireShiftKept(h, shift.high(), SMALLEST);
            }
            image[j] = sum;
        }
    }
}
