package rasterlab.engine.border;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.stream.DoubleStream;
import rasterlab.engine.transform.chain.Chain;

/** How many digits cancel in a chain of matrices, which bounds what double-double promises. */
final class Cancelling {
    /** Half of the 106 bits. */
    private static final BigDecimal HALF = new BigDecimal(0x1p53);

    /** Products of five numbers within are far from a double's ends. */
    private static final int MIDDLING = 170;

    private Cancelling() {}

    /** Whether all numbers but 0 are so near 1 that no product is too large or too small. */
    static boolean isMiddling(Chain chain) {
        return DoubleStream.concat(
                        DoubleStream.concat(
                                DoubleStream.of(chain.points()), DoubleStream.of(chain.h())),
                        Arrays.stream(chain.matrices()).flatMapToDouble(Arrays::stream))
                .allMatch(each -> each == 0 || Math.abs(Math.getExponent(each)) < MIDDLING);
    }

    /**
     * Whether H, or all coordinates beside it, are less than 2⁻⁵³ of the sum of the sizes of what
     * they are added up from. A sum of nothing but zeros cancels nothing.
     */
    static boolean moreThanHalf(Chain chain) {
        BigDecimal[] row = row(chain, false);
        BigDecimal[] sizes = row(chain, true);
        int h = chain.dimension();
        return sizes[h].compareTo(HALF.multiply(row[h].abs())) > 0
                || largest(sizes, h).compareTo(HALF.multiply(largest(row, h))) > 0;
    }

    private static BigDecimal largest(BigDecimal[] row, int count) {
        BigDecimal largest = BigDecimal.ZERO;
        for (int i = 0; i < count; i++) largest = largest.max(row[i].abs());
        return largest;
    }

    /** {@code [x y z h]} through all matrices, each number by its size if so wanted. */
    private static BigDecimal[] row(Chain chain, boolean sizes) {
        int size = chain.dimension() + 1;
        var row = new BigDecimal[size];
        for (int i = 0; i < size; i++)
            row[i] = exact(i < size - 1 ? chain.points()[i] : chain.h()[0], sizes);
        for (double[] matrix : chain.matrices()) {
            var next = new BigDecimal[size];
            for (int j = 0; j < size; j++) {
                next[j] = BigDecimal.ZERO;
                for (int k = 0; k < size; k++)
                    next[j] = next[j].add(row[k].multiply(exact(matrix[k * size + j], sizes)));
            }
            row = next;
        }
        return row;
    }

    private static BigDecimal exact(double number, boolean size) {
        return new BigDecimal(size ? Math.abs(number) : number);
    }
}
