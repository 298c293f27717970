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
        return Stream.of(ofPlanes(), ofPoints(), ofWays()).flatMap(List::stream).toList();
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
                                            boolean isPoint = u0 == u1 && v0 == v1 && w0 == w1;
                                            boolean wasPoint = x0 == x1 && y0 == y1 && z0 == z1;
                                            if (!isPoint || wasPoint)
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

    private static List<Mutant<VolumeClipper>> ofWays() {
        return List.of(
                new Mutant<>(
                        "both-ends-out-dropped",
                        "thin-volume",
                        (zmin, x0, y0, z0, x1, y1, z1, out) -> {
                            if (isIn(zmin, x0, y0, z0) || isIn(zmin, x1, y1, z1))
                                RIGHT.clip(zmin, x0, y0, z0, x1, y1, z1, out);
                        }),
                new Mutant<>(
                        "always-reversed",
                        "through-each-plane",
                        (zmin, x0, y0, z0, x1, y1, z1, out) ->
                                RIGHT.clip(zmin, x1, y1, z1, x0, y0, z0, out)),
                new Mutant<>(
                        "box-for-pyramid",
                        "through-each-plane",
                        planes(
                                (zmin, x, y, z) ->
                                        new double[] {1 - x, 1 + x, 1 - y, 1 + y, z - zmin, 1 - z},
                                true)),
                new Mutant<>(
                        "y-does-not-cut",
                        "through-each-plane",
                        planes(
                                (zmin, x, y, z) -> new double[] {z - x, z + x, z - zmin, 1 - z},
                                true)),
                new Mutant<>(
                        "only-the-start-cut",
                        "through-each-plane",
                        (zmin, x0, y0, z0, x1, y1, z1, out) ->
                                RIGHT.clip(
                                        zmin,
                                        x0,
                                        y0,
                                        z0,
                                        x1,
                                        y1,
                                        z1,
                                        (u0, v0, w0, u1, v1, w1) ->
                                                out.segment(u0, v0, w0, x1, y1, z1))),
                new Mutant<>(
                        "last-plane-decides",
                        "behind-the-eye",
                        planes(VolumeClipMutants::pyramid, false)));
    }

    private static boolean isIn(double zmin, double x, double y, double z) {
        for (double each : pyramid(zmin, x, y, z)) if (each < 0) return false;
        return true;
    }

    private static double[] pyramid(double zmin, double x, double y, double z) {
        return new double[] {z - x, z + x, z - y, z + y, z - zmin, 1 - z};
    }

    private interface Planes {
        /** Numbers from 0 on are inside. */
        double[] of(double zmin, double x, double y, double z);
    }

    /**
     * @param extreme whether the last coming in and the first going out are taken, not those of the
     *     last plane that is passed
     */
    private static VolumeClipper planes(Planes planes, boolean extreme) {
        return (zmin, x0, y0, z0, x1, y1, z1, out) -> {
            double[] from = planes.of(zmin, x0, y0, z0);
            double[] to = planes.of(zmin, x1, y1, z1);
            double in = 0;
            double go = 1;
            for (int i = 0; i < from.length; i++) {
                if (from[i] < 0 && to[i] < 0) return;
                double t = from[i] / (from[i] - to[i]);
                if (from[i] < 0) in = extreme ? Math.max(in, t) : t;
                else if (to[i] < 0) go = extreme ? Math.min(go, t) : t;
            }
            if (in > go) return;
            out.segment(
                    x0 + in * (x1 - x0),
                    y0 + in * (y1 - y0),
                    z0 + in * (z1 - z0),
                    x0 + go * (x1 - x0),
                    y0 + go * (y1 - y0),
                    z0 + go * (z1 - z0));
        };
    }
}
