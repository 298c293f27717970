package rasterlab.engine.transform.chain;

import rasterlab.contract.PointTransformer;
import rasterlab.engine.transform.Coordinates;

/** Transforms in float, as graphics hardware does it: 24 bits instead of 53. */
final class FloatTransformer implements PointTransformer {
    private static final double SMALLEST = 0x1p-110;

    @Override
    public void transform(int dimension, double[][] matrices, double[] points, double[] h) {
        ChainCheck.require(dimension, matrices, points, h);
        Coordinates.requireFloat(points, dimension);
        requireFloat(h);
        int size = dimension + 1;
        float[] product = product(size, matrices);
        var image = new float[size];
        for (int i = 0; i < h.length; i++) {
            image(product, points, i * dimension, (float) h[i], image);
            float divisor = image[dimension];
            h[i] = divisor;
            for (int j = 0; j < dimension; j++) {
                float coordinate = divisor == 0 ? Float.NaN : image[j] / divisor;
                if (!Float.isFinite(divisor) || divisor != 0 && !Float.isFinite(coordinate))
                    throw ChainCheck.tooLarge(i);
                points[i * dimension + j] = coordinate;
            }
        }
    }

    private static float[] product(int size, double[][] matrices) {
        var product = new float[size * size];
        for (int i = 0; i < size; i++) product[i * size + i] = 1;
        var row = new float[size];
        for (int m = 0; m < matrices.length; m++) {
            float[] matrix = narrowed(matrices[m], m);
            for (int i = 0; i < size; i++) {
                for (int j = 0; j < size; j++) {
                    float sum = 0;
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
        }
        var wide = new double[size * size];
        for (int i = 0; i < wide.length; i++) wide[i] = product[i];
        ChainCheck.requireProduct(wide);
        return product;
    }

    private static float[] narrowed(double[] cells, int m) {
        var narrow = new float[cells.length];
        for (int i = 0; i < cells.length; i++) {
            narrow[i] = (float) cells[i];
            if (!Float.isFinite(narrow[i]) || narrow[i] == 0 && cells[i] != 0)
                throw new IllegalArgumentException(
                        "matrices[%d]: a float holds 0 and magnitudes from 1.4E-45 to 3.4E38, got %s"
                                .formatted(m, cells[i]));
        }
        return narrow;
    }

    private static void requireFloat(double[] h) {
        for (int i = 0; i < h.length; i++)
            if (!Float.isFinite((float) h[i]) || (float) h[i] == 0 && h[i] != 0)
                throw new IllegalArgumentException(
                        "h[%d]: a float holds 0 and magnitudes from 1.4E-45 to 3.4E38, got %s"
                                .formatted(i, h[i]));
    }

    /** {@code [point h] · M}. */
    private static void image(float[] m, double[] points, int at, float h, float[] image) {
        int size = image.length;
        for (int j = 0; j < size; j++) {
            float sum = 0;
            for (int k = 0; k < size - 1; k++) sum += (float) points[at + k] * m[k * size + j];
            image[j] = sum + h * m[(size - 1) * size + j];
            if (Math.abs(image[j]) < SMALLEST) {
                for (int k = 0; k < size - 1; k++)
                    ChainCheck.requireKept(points[at + k], m[k * size + j], SMALLEST);
                ChainCheck.requireShiftKept(h, m[(size - 1) * size + j], SMALLEST);
            }
        }
    }
}
