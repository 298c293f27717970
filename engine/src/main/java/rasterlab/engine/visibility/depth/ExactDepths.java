package rasterlab.engine.visibility.depth;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * The order of surfaces in each pixel by fractions, whose terms are decimals without rounding.
 *
 * <p>With m = n − 1 and i + j = m, a surface from a to b is at z = m·a·b/(i·a + j·b) in pixel i.
 */
final class ExactDepths {
    private static final MathContext DIGITS = new MathContext(60);

    private ExactDepths() {}

    /** z as a fraction of positive terms. */
    private record Fraction(BigDecimal above, BigDecimal below) {
        int compareTo(Fraction other) {
            return above.multiply(other.below).compareTo(other.above.multiply(below));
        }
    }

    /** The true depths; the codes are ranks from 0 for the nearest, equal for equal depths. */
    static StoredDepths of(DepthRows rows) {
        var ranks = new int[rows.count()];
        var depths = new double[rows.count()];
        for (int i = 0; i < rows.pixels(); i++) {
            List<Fraction> z = depths(rows, i);
            int rank = 0;
            Fraction last = null;
            for (int s : order(z)) {
                int at = s * rows.pixels() + i;
                if (last != null && z.get(s).compareTo(last) != 0) rank++;
                last = z.get(s);
                ranks[at] = rank;
                depths[at] = last.above().divide(last.below(), DIGITS).doubleValue();
            }
        }
        return new StoredDepths(rows.pixels(), ranks, depths);
    }

    private static List<Fraction> depths(DepthRows rows, int pixel) {
        int whole = Math.max(1, rows.pixels() - 1);
        return IntStream.range(0, rows.surfaces())
                .mapToObj(
                        s -> {
                            BigDecimal a = new BigDecimal(rows.depths()[s]);
                            BigDecimal b = new BigDecimal(rows.to()[s]);
                            BigDecimal i = BigDecimal.valueOf(pixel);
                            BigDecimal j = BigDecimal.valueOf(whole - pixel);
                            return new Fraction(
                                    a.multiply(b).multiply(BigDecimal.valueOf(whole)),
                                    a.multiply(i).add(b.multiply(j)));
                        })
                .toList();
    }

    private static List<Integer> order(List<Fraction> z) {
        return IntStream.range(0, z.size())
                .boxed()
                .sorted(Comparator.comparing(z::get, Fraction::compareTo))
                .toList();
    }
}
