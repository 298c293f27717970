package rasterlab.engine.texture.mapping;

import java.util.Map;
import rasterlab.contract.TexturedSpan;

/**
 * s/d, t/d and 1/d are added up in float from pixel to pixel: every sum rounds, and they drift.
 *
 * <p>Source: P. S. Heckbert, H. P. Moreton, Interpolation for polygon texture mapping and shading,
 * 1991, pp. 101–111.
 */
final class SteppedMapper implements CountedMapper {
    /** Two quotients and three sums a pixel; 9 quotients and 3 differences before the first. */
    @Override
    public Map<String, Long> operations(TexturedSpan span) {
        long n = span.pixels();
        return CountedMapper.counts(2 * n + 9, 0, 3 * n + 3);
    }

    @Override
    public double[] coordinates(TexturedSpan span) {
        var st = new double[2 * span.pixels()];
        float steps = Math.max(1, span.pixels() - 1);
        float d = (float) (1 / span.fromDepth());
        float s = (float) (span.fromS() / span.fromDepth());
        float t = (float) (span.fromT() / span.fromDepth());
        float stepD = ((float) (1 / span.toDepth()) - d) / steps;
        float stepS = ((float) (span.toS() / span.toDepth()) - s) / steps;
        float stepT = ((float) (span.toT() / span.toDepth()) - t) / steps;
        for (int i = 0; i < span.pixels(); i++) {
            st[2 * i] = s / d;
            st[2 * i + 1] = t / d;
            d += stepD;
            s += stepS;
            t += stepT;
        }
        return st;
    }
}
