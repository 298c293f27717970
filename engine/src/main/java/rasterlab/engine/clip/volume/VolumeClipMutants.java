package rasterlab.engine.clip.volume;

import java.util.List;
import java.util.stream.Stream;
import rasterlab.contract.VolumeClipper;
import rasterlab.engine.study.Mutant;

/** Segments clipped by the view volume with one mistake. */
final class VolumeClipMutants {
    private static final VolumeClipper RIGHT = new CohenSutherland6();

    private VolumeClipMutants() {}

    static List<Mutant<VolumeClipper>> all() {
        return Stream.concat(ofPlanes().stream(), ofPoints().stream()).toList();
    }

    private static List<Mutant<VolumeClipper>> ofPlanes() {
        return List.of(
                new Mutant<>(
                        "near-does-not-cut",
                        "through-each-plane",
                        (zmin, x0, y0, z0, x1, y1, z1, out) ->
                                RIGHT.clip(1e-300, x0, y0, z0, x1, y1, z1, out)),
                new Mutant<>(
                        "far-does-not-cut",
                        "through-each-plane",
                        (zmin, x0, y0, z0, x1, y1, z1, out) ->
                                RIGHT.clip(
                                        zmin / 8,
                                        x0 / 8,
                                        y0 / 8,
                                        z0 / 8,
                                        x1 / 8,
                                        y1 / 8,
                                        z1 / 8,
                                        (u0, v0, w0, u1, v1, w1) ->
                                                out.segment(
                                                        8 * u0, 8 * v0, 8 * w0, 8 * u1, 8 * v1,
                                                        8 * w1))),
                new Mutant<>(
                        "always-near-to-far",
                        "from-far-to-near",
                        (zmin, x0, y0, z0, x1, y1, z1, out) -> {
                            if (z0 <= z1) RIGHT.clip(zmin, x0, y0, z0, x1, y1, z1, out);
                            else RIGHT.clip(zmin, x1, y1, z1, x0, y0, z0, out);
                        }),
                new Mutant<>(
                        "divided-before-clipping", "behind-the-eye", new DivideFirstTextbook()));
    }

    private static List<Mutant<VolumeClipper>> ofPoints() {
        return List.of(
                new Mutant<>(
                        "eye-refused",
                        "at-the-eye",
                        (zmin, x0, y0, z0, x1, y1, z1, out) -> {
                            if (z0 == 0 || z1 == 0)
                                throw new IllegalArgumentException("z must not be 0");
                            RIGHT.clip(zmin, x0, y0, z0, x1, y1, z1, out);
                        }),
                new Mutant<>(
                        "point-left-dropped",
                        "touches-an-edge",
                        (zmin, x0, y0, z0, x1, y1, z1, out) ->
                                RIGHT.clip(
                                        zmin,
                                        x0,
                                        y0,
                                        z0,
                                        x1,
                                        y1,
                                        z1,
                                        (u0, v0, w0, u1, v1, w1) -> {
                                            if (u0 != u1 || v0 != v1 || w0 != w1)
                                                out.segment(u0, v0, w0, u1, v1, w1);
                                        })),
                new Mutant<>(
                        "point-segment-dropped",
                        "single-points",
                        (zmin, x0, y0, z0, x1, y1, z1, out) -> {
                            if (x0 != x1 || y0 != y1 || z0 != z1)
                                RIGHT.clip(zmin, x0, y0, z0, x1, y1, z1, out);
                        }));
    }
}
