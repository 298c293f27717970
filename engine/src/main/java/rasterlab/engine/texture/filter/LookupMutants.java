package rasterlab.engine.texture.filter;

import java.util.List;
import rasterlab.contract.TextureFilter;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.texture.DetailLevel;
import rasterlab.engine.texture.Texture;
import rasterlab.engine.texture.TextureSampler;
import rasterlab.engine.texture.Wrap;

/** The bilinear and the trilinear lookup with one mistake, where just that lookup is asked for. */
final class LookupMutants {
    private LookupMutants() {}

    /** Mutants of the method {@code linear}. */
    static List<Mutant<TextureFilter>> linear() {
        return List.of(
                new Mutant<>(
                        "one-texel",
                        "magnified",
                        looked(Wrap.REPEAT, (texture, s, t, right, down) -> texture.nearest(s, t))),
                new Mutant<>(
                        "corner-not-center",
                        "magnified",
                        moved((s, size) -> s + 0.5 / size, (t, size) -> t + 0.5 / size)),
                new Mutant<>(
                        "weights-swapped",
                        "magnified",
                        moved(LookupMutants::swapped, LookupMutants::swapped)),
                new Mutant<>(
                        "top-row-first", "bottom-row-first", moved((s, w) -> s, (t, h) -> 1 - t)),
                new Mutant<>(
                        "not-repeated",
                        "beyond-the-border",
                        looked(
                                Wrap.CLAMP_TO_EDGE,
                                (texture, s, t, right, down) -> texture.linear(s, t))),
                new Mutant<>(
                        "s-t-swapped",
                        "bottom-row-first",
                        looked(Wrap.REPEAT, (texture, s, t, right, down) -> texture.linear(t, s))),
                new Mutant<>(
                        "size-less-one",
                        "magnified",
                        moved(
                                (s, w) -> (s * (w - 1) + 0.5) / w,
                                (t, h) -> (t * (h - 1) + 0.5) / h)));
    }

    /** Mutants of the method {@code trilinear}. */
    static List<Mutant<TextureFilter>> trilinear() {
        return List.of(
                level("level-0-alone", (texture, s, t, right, down) -> texture.linear(s, t)),
                level(
                        "nearest-level",
                        (texture, s, t, right, down) ->
                                texture.linearLevel(s, t, lambda(Math.max(right, down)))),
                level(
                        "natural-logarithm",
                        (texture, s, t, right, down) ->
                                texture.trilinear(
                                        s, t, lambda(Math.max(right, down)) * Math.log(2))),
                new Mutant<>(
                        "levels-swapped",
                        "turned",
                        looked(
                                Wrap.REPEAT,
                                (texture, s, t, right, down) ->
                                        texture.trilinear(
                                                s, t, across(lambda(Math.max(right, down)))))),
                level(
                        "one-texel-of-each-level",
                        (texture, s, t, right, down) ->
                                texture.nearestBetween(s, t, lambda(Math.max(right, down)))),
                new Mutant<>(
                        "square-of-shorter-side",
                        "long-and-narrow",
                        looked(
                                Wrap.REPEAT,
                                (texture, s, t, right, down) ->
                                        texture.trilinear(s, t, lambda(Math.min(right, down))))),
                level(
                        "step-not-rooted",
                        (texture, s, t, right, down) ->
                                texture.trilinear(s, t, 2 * lambda(Math.max(right, down)))),
                level(
                        "coarser-level-alone",
                        (texture, s, t, right, down) ->
                                texture.trilinear(s, t, Math.ceil(lambda(Math.max(right, down))))),
                level(
                        "finer-level-alone",
                        (texture, s, t, right, down) ->
                                texture.trilinear(
                                        s, t, Math.floor(lambda(Math.max(right, down))))));
    }

    static double lambda(double squaredStep) {
        return DetailLevel.of(squaredStep);
    }

    /** Returns a level as far from the coarser one as λ is from the finer. */
    private static double across(double lambda) {
        return lambda > 0 ? Math.floor(lambda) + 1 - (lambda - Math.floor(lambda)) : lambda;
    }

    /** Returns a place as far from the next centre as the given one is from the one before. */
    private static double swapped(double place, int size) {
        double texels = place * size - 0.5;
        double before = Math.floor(texels);
        return (before + 1 - (texels - before) + 0.5) / size;
    }

    interface AtLevel {
        /**
         * @param right squared length of the step to the right, in texels
         * @param down the same downwards
         */
        int color(TextureSampler texture, double s, double t, double right, double down);
    }

    private interface Moved {
        double to(double place, int size);
    }

    private static Mutant<TextureFilter> level(String name, AtLevel at) {
        return new Mutant<>(name, "between-levels", looked(Wrap.REPEAT, at));
    }

    static PreparedFilter looked(Wrap wrap, AtLevel at) {
        return (width, height, argb) -> {
            var texture = new TextureSampler(Texture.of(width, height, 4, argb), wrap, wrap);
            return (s, t, dsdx, dtdx, dsdy, dtdy) ->
                    at.color(
                            texture,
                            s,
                            t,
                            DetailLevel.squaredStep(dsdx, dtdx, 0, 0, width, height),
                            DetailLevel.squaredStep(0, 0, dsdy, dtdy, width, height));
        };
    }

    private static PreparedFilter moved(Moved s, Moved t) {
        return (width, height, argb) -> {
            var texture =
                    new TextureSampler(
                            Texture.of(width, height, 4, argb), Wrap.REPEAT, Wrap.REPEAT);
            return (atS, atT, dsdx, dtdx, dsdy, dtdy) ->
                    texture.linear(s.to(atS, width), t.to(atT, height));
        };
    }
}
