package rasterlab.engine.texture.filter;

import rasterlab.contract.TextureFilter;
import rasterlab.engine.texture.DetailLevel;
import rasterlab.engine.texture.Texture;
import rasterlab.engine.texture.TextureSampler;
import rasterlab.engine.texture.Wrap;

/** A texture looked up at the pixel's centre, by one of the filters that OpenGL names. */
final class SampledFilter implements TextureFilter {
    /** What is done with the texture, the place and the level. */
    @FunctionalInterface
    interface Look {
        int color(TextureSampler sampler, double s, double t, double lambda);
    }

    private final Look look;

    SampledFilter(Look look) {
        this.look = look;
    }

    @Override
    public Lookup prepare(int width, int height, int[] argb) {
        var sampler =
                new TextureSampler(Texture.of(width, height, 4, argb), Wrap.REPEAT, Wrap.REPEAT);
        return (s, t, dsdx, dtdx, dsdy, dtdy) ->
                look.color(
                        sampler,
                        s,
                        t,
                        DetailLevel.of(
                                DetailLevel.squaredStep(dsdx, dtdx, dsdy, dtdy, width, height)));
    }
}
