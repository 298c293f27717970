package rasterlab.engine.transform.chain;

import java.util.Map;
import java.util.stream.Collectors;
import rasterlab.contract.PointTransformer;
import rasterlab.engine.transform.CountingArithmetic;

/**
 * The methods' work operation by operation, each of them counted.
 *
 * <p>In float every result is rounded once more, which for one operation on two floats is what
 * float arithmetic gives. Double-double does what double does, each operation with numbers of two
 * doubles; so its operations are named.
 */
final class CountingChain {
    private final CountingArithmetic on = new CountingArithmetic();
    private final boolean narrow;

    CountingChain(boolean narrow) {
        this.narrow = narrow;
    }

    /**
     * The operations of {@code method} for {@code chain}; empty for a method that is none of ours.
     */
    static Map<String, Long> counts(PointTransformer method, Chain chain) {
        var counting = new CountingChain(method instanceof FloatTransformer);
        double[] points = chain.points().clone();
        if (method instanceof DivideFirstTransformer) counting.divideFirst(chain, points);
        else if (method instanceof FloatTransformer || method instanceof DoubleTransformer)
            counting.transform(chain, points);
        else if (method instanceof DoubleDoubleTransformer) {
            counting.transform(chain, points);
            return counting.on.counts().entrySet().stream()
                    .collect(
                            Collectors.toMap(
                                    kind -> "double-double-" + kind.getKey(), Map.Entry::getValue));
        } else return Map.of();
        return counting.on.counts();
    }

    void transform(Chain chain, double[] points) {
        int size = chain.dimension() + 1;
        var product = new double[size * size];
        for (int i = 0; i < size; i++) product[i * size + i] = 1;
        for (double[] matrix : chain.matrices()) product = product(size, product, matrix);
        for (int i = 0; i < chain.size(); i++)
            image(product, points, i * chain.dimension(), chain.h()[i]);
    }

    void divideFirst(Chain chain, double[] points) {
        for (int i = 0; i < chain.size(); i++) {
            int at = i * chain.dimension();
            if (chain.h()[i] != 1)
                for (int j = 0; j < chain.dimension(); j++)
                    points[at + j] = on.over(points[at + j], chain.h()[i]);
            for (double[] matrix : chain.matrices()) image(matrix, points, at, 1);
        }
    }

    private double[] product(int size, double[] left, double[] right) {
        var product = new double[size * size];
        for (int i = 0; i < product.length; i++)
            for (int k = 0; k < size; k++)
                product[i] =
                        plus(
                                product[i],
                                times(left[i / size * size + k], right[k * size + i % size]));
        return product;
    }

    /** A plain point takes the last row as it is, without a multiplication. */
    private void image(double[] m, double[] points, int at, double h) {
        int size = (int) Math.sqrt(m.length);
        var image = new double[size];
        for (int j = 0; j < size; j++) {
            for (int k = 0; k < size - 1; k++)
                image[j] = plus(image[j], times(rounded(points[at + k]), m[k * size + j]));
            double shift = m[(size - 1) * size + j];
            image[j] = plus(image[j], h == 1 ? shift : times(h, shift));
        }
        for (int j = 0; j < size - 1; j++)
            points[at + j] = rounded(on.over(image[j], image[size - 1]));
    }

    private double plus(double a, double b) {
        return rounded(on.plus(rounded(a), rounded(b)));
    }

    private double times(double a, double b) {
        return rounded(on.times(rounded(a), rounded(b)));
    }

    private double rounded(double value) {
        return narrow ? (float) value : value;
    }
}
