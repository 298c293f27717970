package rasterlab.engine.texture.filter;

import java.util.List;
import rasterlab.contract.TextureFilter;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;
import rasterlab.engine.texture.TexelShares;
import rasterlab.engine.texture.TextureSampler;

/** The methods of the topic, in teaching order. */
final class FilterMethods {
    private static final String CHAPTER =
            "Kazantsev, course text on computer graphics, chapter 15, parameters of textures";
    private static final String WILLIAMS =
            "L. Williams, Pyramidal parametrics, SIGGRAPH 1983; " + CHAPTER;

    private FilterMethods() {}

    static List<Method<TextureFilter>> all() {
        return List.of(
                method(
                        "nearest",
                        "the texel that the pixel's centre lies in",
                        "one texel, whatever the footprint",
                        "1 texel per pixel",
                        "made smaller, fine patterns flicker and form false ones (aliasing)",
                        CHAPTER,
                        new SampledFilter(
                                (sampler, s, t, lambda) -> sampler.nearest(s, t),
                                (texture, s, t, lambda) -> texture.nearest(s, t))),
                method(
                        "linear",
                        "four texels mixed by the distance of their centres",
                        "four texels, whatever the footprint",
                        "4 texels and 3 mixes per pixel",
                        "as nearest, once more than two texels fall on a pixel",
                        CHAPTER,
                        new SampledFilter(
                                (sampler, s, t, lambda) -> sampler.linear(s, t),
                                (texture, s, t, lambda) -> texture.linear(s, t))),
                method(
                        "mipmap-nearest",
                        "the nearest texel of level ⌊λ + ½⌋, λ = log₂ ρ",
                        "one texel as large as the footprint's longer side, within √2",
                        "1 texel and 1 logarithm per pixel",
                        "steps between levels; squares where footprints are long or turned",
                        WILLIAMS,
                        new SampledFilter(TextureSampler::nearestLevel, TexelShares::nearestLevel)),
                method(
                        "trilinear",
                        "linear in the two levels around λ, mixed by λ",
                        "the colour changes without steps",
                        "8 texels, 7 mixes and 1 logarithm per pixel",
                        "blurs where the footprint is long and narrow",
                        WILLIAMS,
                        new SampledFilter(TextureSampler::trilinear, TexelShares::trilinear)),
                method(
                        "summed-area",
                        "(S(r,u) − S(l,u) − S(r,d) + S(l,d))/area of a table of sums",
                        "every texel counts by its share of the footprint",
                        "16 entries per channel and pixel, however large the footprint",
                        "none known; refuses a turned footprint",
                        "F. C. Crow, Summed-area tables for texture mapping, SIGGRAPH 1984",
                        new SummedAreaFilter()));
    }

    private static Method<TextureFilter> method(
            String name,
            String formula,
            String invariant,
            String cost,
            String failures,
            String source,
            TextureFilter implementation) {
        return new Method<>(
                name, new About(formula, invariant, cost, failures, source), implementation);
    }
}
