package rasterlab.engine.texture.filter;

import java.util.List;
import rasterlab.engine.texture.DetailLevel;
import rasterlab.engine.texture.TexelShare;
import rasterlab.engine.texture.TexelShares;
import rasterlab.engine.texture.Texture;
import rasterlab.engine.texture.TextureSampler;
import rasterlab.engine.texture.Wrap;

/**
 * A texture looked up at the pixel's centre, by one of the filters that OpenGL names.
 *
 * <p>Source: L. Williams, Pyramidal parametrics, SIGGRAPH 1983, pp. 1–11; A. V. Kazantsev,
 * Foundations of computer graphics for programmers, Kazan, 2005, ch. 15, parameters of textures.
 */
final class SampledFilter implements SteppedFilter {
    /** A lookup in the texture, at a place and a level. */
    @FunctionalInterface
    interface TexelLookup {
        int color(TextureSampler sampler, double s, double t, double lambda);
    }

    /** Which texels that takes. */
    @FunctionalInterface
    interface Shares {
        List<TexelShare> of(TexelShares texture, double s, double t, double lambda);
    }

    private final TexelLookup look;
    private final Shares shares;

    SampledFilter(TexelLookup look, Shares shares) {
        this.look = look;
        this.shares = shares;
    }

    @Override
    public Lookup prepare(int width, int height, int[] argb) {
        var sampler =
                new TextureSampler(Texture.of(width, height, 4, argb), Wrap.REPEAT, Wrap.REPEAT);
        return (s, t, dsdx, dtdx, dsdy, dtdy) ->
                Footprint.isPoint(dsdx, dtdx, dsdy, dtdy, width, height)
                        ? sampler.nearest(s, t)
                        : look.color(sampler, s, t, lambda(dsdx, dtdx, dsdy, dtdy, width, height));
    }

    @Override
    public Trace trace(int width, int height, int[] argb) {
        var texture = new TexelShares(Texture.of(width, height, 4, argb));
        return (s, t, dsdx, dtdx, dsdy, dtdy) ->
                Footprint.isPoint(dsdx, dtdx, dsdy, dtdy, width, height)
                        ? texture.nearest(s, t)
                        : shares.of(texture, s, t, lambda(dsdx, dtdx, dsdy, dtdy, width, height));
    }

    private static double lambda(
            double dsdx, double dtdx, double dsdy, double dtdy, int width, int height) {
        return DetailLevel.of(DetailLevel.squaredStep(dsdx, dtdx, dsdy, dtdy, width, height));
    }
}
