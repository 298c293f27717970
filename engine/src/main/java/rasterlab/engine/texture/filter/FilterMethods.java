package rasterlab.engine.texture.filter;

import java.util.List;
import rasterlab.contract.TextureFilter;
import rasterlab.engine.study.Method;
import rasterlab.engine.texture.TexelShares;
import rasterlab.engine.texture.TextureSampler;

/** The methods of the topic, in teaching order. */
final class FilterMethods {

    private FilterMethods() {}

    static List<Method<TextureFilter>> all() {
        return List.of(
                Method.failing(
                        "nearest",
                        new SampledFilter(
                                (sampler, s, t, lambda) -> sampler.nearest(s, t),
                                (texture, s, t, lambda) -> texture.nearest(s, t))),
                Method.failing(
                        "linear",
                        new SampledFilter(
                                (sampler, s, t, lambda) -> sampler.linear(s, t),
                                (texture, s, t, lambda) -> texture.linear(s, t))),
                Method.failing(
                        "mipmap-nearest",
                        new SampledFilter(TextureSampler::nearestLevel, TexelShares::nearestLevel)),
                Method.failing(
                        "trilinear",
                        new SampledFilter(TextureSampler::trilinear, TexelShares::trilinear)),
                Method.right("summed-area", new SummedAreaFilter()),
                Method.failing("nearest-textbook", new MaskedTextbookFilter()));
    }
}
