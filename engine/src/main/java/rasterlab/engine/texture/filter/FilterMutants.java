package rasterlab.engine.texture.filter;

import java.util.List;
import rasterlab.contract.TextureFilter;
import rasterlab.engine.study.Mutant;

/** Textures looked up with one mistake. */
final class FilterMutants {
    private static final PreparedFilter RIGHT = new SummedAreaFilter();

    private FilterMutants() {}

    static List<Mutant<TextureFilter>> all() {
        return List.of(
                new Mutant<>("one-texel", "aliasing", oneTexel()),
                new Mutant<>(
                        "square-of-longer-side",
                        "long-and-narrow",
                        looking(
                                (look, s, t, wide, high) -> {
                                    double side = Math.max(Math.abs(wide), Math.abs(high));
                                    return look.color(s, t, side, 0, 0, side);
                                })),
                new Mutant<>(
                        "square-of-shorter-side",
                        "long-over-rows",
                        looking(
                                (look, s, t, wide, high) -> {
                                    double side = Math.min(Math.abs(wide), Math.abs(high));
                                    return look.color(s, t, side, 0, 0, side);
                                })),
                new Mutant<>(
                        "top-row-first",
                        "bottom-row-first",
                        looking(
                                (look, s, t, wide, high) ->
                                        look.color(s, 1 - t, wide, 0, 0, high))),
                new Mutant<>(
                        "not-repeated",
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
                new Mutant<>("no-area-is-a-texel", "no-area", withoutPoints()));
    }

    private static PreparedFilter oneTexel() {
        return (width, height, argb) ->
                (s, t, a, b, c, d) ->
                        argb[
                                Math.floorMod((int) Math.floor(t * height), height) * width
                                        + Math.floorMod((int) Math.floor(s * width), width)];
    }

    private static PreparedFilter withoutPoints() {
        return (width, height, argb) -> {
            PreparedFilter.Lookup look = RIGHT.prepare(width, height, argb);
            return (s, t, a, b, c, d) ->
                    Footprint.isPoint(a, b, c, d, width, height)
                            ? look.color(s, t, 1.0 / width, 0, 0, 1.0 / height)
                            : look.color(s, t, a, b, c, d);
        };
    }

    private interface Looking {
        int color(PreparedFilter.Lookup look, double s, double t, double wide, double high);
    }

    /** The right filter, but for footprints that have an area and are not turned. */
    private static PreparedFilter looking(Looking looking) {
        return (width, height, argb) -> {
            PreparedFilter.Lookup look = RIGHT.prepare(width, height, argb);
            return (s, t, dsdx, dtdx, dsdy, dtdy) ->
                    Footprint.isPoint(dsdx, dtdx, dsdy, dtdy, width, height)
                            ? look.color(s, t, dsdx, dtdx, dsdy, dtdy)
                            : looking.color(look, s, t, dsdx, dtdy);
        };
    }
}
