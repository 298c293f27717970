package rasterlab.engine.texture.mapping;

import java.util.Map;
import rasterlab.contract.TexturedSpan;

/**
 * s/d, t/d and 1/d are mixed along the row and divided at every pixel.
 *
 * <p>Source: P. S. Heckbert, H. P. Moreton, Interpolation for polygon texture mapping and shading,
 * 1991, pp. 101–111.
 */
final class PerspectiveMapper implements CountedMapper {
    @Override
    public double[] coordinates(TexturedSpan span) {
        var st = new double[2 * span.pixels()];
        for (int i = 0; i < span.pixels(); i++) at(span, i, st, 2 * i);
        return st;
    }

    /**
     * The operations, at each pixel f and two quotients, 6 products, and 5 sums and differences.
     */
    @Override
    public Map<String, Long> operations(TexturedSpan span) {
        long n = span.pixels();
        return CountedMapper.counts(3 * n, 6 * n, 5 * n);
    }

    static void at(TexturedSpan span, int i, double[] out, int at) {
        double f = span.pixels() == 1 ? 0 : i / (span.pixels() - 1.0);
        // Both weights are divided by the sum of the two, which never is 0: depths are above 0.
        double from = (1 - f) * span.toDepth();
        double to = f * span.fromDepth();
        out[at] = (from * span.fromS() + to * span.toS()) / (from + to);
        out[at + 1] = (from * span.fromT() + to * span.toT()) / (from + to);
    }
}
