package rasterlab.engine.texture.mapping;

import java.util.Map;
import rasterlab.contract.TexturedSpan;

/**
 * The coordinates as colours are stepped along a row: s and t grow by (s₁ − s₀)/(n − 1) and (t₁ −
 * t₀)/(n − 1) from pixel to pixel, whatever the depths are. Exact, but for what the sums round,
 * where the depth does not change along the row.
 *
 * <p>Source: P. S. Heckbert, H. P. Moreton, Interpolation for polygon texture mapping and shading,
 * 1991, pp. 101–111, which shows what is wrong with it.
 */
final class AffineTextbookMapper implements CountedMapper {
    /** Two sums a pixel; a quotient and a difference for each step before the first. */
    @Override
    public Map<String, Long> operations(TexturedSpan span) {
        return CountedMapper.counts(2, 0, 2L * span.pixels() + 3);
    }

    @Override
    public double[] coordinates(TexturedSpan span) {
        var st = new double[2 * span.pixels()];
        double steps = span.pixels() - 1;
        double stepS = (span.toS() - span.fromS()) / steps;
        double stepT = (span.toT() - span.fromT()) / steps;
        double s = span.fromS();
        double t = span.fromT();
        for (int i = 0; i < span.pixels(); i++) {
            st[2 * i] = s;
            st[2 * i + 1] = t;
            s += stepS;
            t += stepT;
        }
        return st;
    }
}
