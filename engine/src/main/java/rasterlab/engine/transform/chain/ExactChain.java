package rasterlab.engine.transform.chain;

import static rasterlab.engine.transform.exact.BigTrig.DIGITS;

import java.math.BigDecimal;
import java.util.Arrays;
import rasterlab.engine.transform.exact.BigMatrix;

/** The right images, each point taken through one matrix after the other without any rounding. */
final class ExactChain {
    private ExactChain() {}

    /** The image and H of each of the first {@code limit} points: dimension + 1 numbers each. */
    static double[] images(Chain chain, int limit) {
        int dimension = chain.dimension();
        BigMatrix[] matrices =
                Arrays.stream(chain.matrices())
                        .map(cells -> BigMatrix.of(dimension + 1, cells))
                        .toArray(BigMatrix[]::new);
        int count = Math.min(limit, chain.size());
        var images = new double[count * (dimension + 1)];
        for (int i = 0; i < count; i++) {
            BigDecimal[] row = new BigDecimal[dimension + 1];
            for (int j = 0; j < dimension; j++)
                row[j] = new BigDecimal(chain.points()[i * dimension + j]);
            row[dimension] = new BigDecimal(chain.h()[i]);
            for (BigMatrix matrix : matrices) row = matrix.image(row);
            put(row, images, i * (dimension + 1));
        }
        return images;
    }

    private static void put(BigDecimal[] row, double[] images, int at) {
        int last = row.length - 1;
        for (int j = 0; j < last; j++)
            images[at + j] =
                    row[last].signum() == 0
                            ? Double.NaN
                            : row[j].divide(row[last], DIGITS).doubleValue();
        images[at + last] = row[last].doubleValue();
    }
}
