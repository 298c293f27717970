package rasterlab.engine.texture.filter;

import java.util.List;
import rasterlab.contract.TextureFilter;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Mutants;

/** Textures looked up with one mistake. */
final class FilterMutants implements Mutants<TextureFilter> {
    private static final TextureFilter RIGHT = new SummedAreaFilter();

    @Override
    public List<Mutant<TextureFilter>> all() {
        return List.of(
                new Mutant<>(
                        "one texel, whatever the footprint",
                        "aliasing",
                        (width, height, argb) ->
                                (s, t, a, b, c, d) ->
                                        argb[
                                                Math.floorMod((int) Math.floor(t * height), height)
                                                                * width
                                                        + Math.floorMod(
                                                                (int) Math.floor(s * width),
                                                                width)]),
                new Mutant<>(
                        "a square as large as the longer side",
                        "long-and-narrow",
                        looking(
                                (look, s, t, wide, high) -> {
                                    double side = Math.max(Math.abs(wide), Math.abs(high));
                                    return look.color(s, t, side, 0, 0, side);
                                })),
                new Mutant<>(
                        "a square as large as the shorter side",
                        "long-over-rows",
                        looking(
                                (look, s, t, wide, high) -> {
                                    double side = Math.min(Math.abs(wide), Math.abs(high));
                                    return look.color(s, t, side, 0, 0, side);
                                })),
                new Mutant<>(
                        "the top row comes first",
                        "bottom-row-first",
                        looking(
                                (look, s, t, wide, high) ->
                                        look.color(s, 1 - t, wide, 0, 0, high))),
                new Mutant<>(
                        "the picture does not repeat itself",
                        "beyond-the-border",
                        looking(
                                (look, s, t, wide, high) ->
                                        look.color(
                                                Math.max(wide / 2, Math.min(1 - wide / 2, s)),
                                                t,
                                                wide,
                                                0,
                                                0,
                                                high))),
                new Mutant<>(
                        "a footprint without area is as large as a texel",
                        "no-area",
                        (width, height, argb) -> {
                            TextureFilter.Lookup look = RIGHT.prepare(width, height, argb);
                            return (s, t, a, b, c, d) ->
                                    Footprint.isPoint(a, b, c, d, width, height)
                                            ? look.color(s, t, 1.0 / width, 0, 0, 1.0 / height)
                                            : look.color(s, t, a, b, c, d);
                        }));
    }

    private interface Looking {
        int color(TextureFilter.Lookup look, double s, double t, double wide, double high);
    }

    /** Another look at footprints that have an area and are not turned. */
    private static TextureFilter looking(Looking looking) {
        return (width, height, argb) -> {
            TextureFilter.Lookup look = RIGHT.prepare(width, height, argb);
            return (s, t, dsdx, dtdx, dsdy, dtdy) ->
                    Footprint.isPoint(dsdx, dtdx, dsdy, dtdy, width, height)
                            ? look.color(s, t, dsdx, dtdx, dsdy, dtdy)
                            : looking.color(look, s, t, dsdx, dtdy);
        };
    }
}
