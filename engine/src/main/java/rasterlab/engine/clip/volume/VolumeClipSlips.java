package rasterlab.engine.clip.volume;

import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import rasterlab.contract.VolumeClipper;
import rasterlab.engine.study.Slip;

/** Segments clipped by too few planes, or cut at the wrong place. */
final class VolumeClipSlips {
    private static final int PLANES = 6;
    private static final Set<Integer> ALL = Set.of(0, 1, 2, 3, 4, 5);

    private VolumeClipSlips() {}

    static List<Slip<VolumeClipper>> of(VolumeClipper right) {
        return List.of(
                new Slip<>(
                        "one-side-does-not-cut",
                        IntStream.range(0, 4).mapToObj(VolumeClipSlips::without).toList()),
                Slip.of("x-does-not-cut", clipping(Set.of(2, 3, 4, 5), Cut.RIGHT)),
                Slip.of("sides-do-not-cut", clipping(Set.of(4, 5), Cut.RIGHT)),
                Slip.of("near-and-far-do-not-cut", clipping(Set.of(0, 1, 2, 3), Cut.RIGHT)),
                Slip.of("cut-from-the-other-end", clipping(ALL, Cut.FROM_THE_OTHER_END)),
                Slip.of("ways-not-compared", clipping(ALL, Cut.NOT_COMPARED)),
                Slip.of(
                        "near-at-0",
                        (zmin, x0, y0, z0, x1, y1, z1, out) ->
                                clipping(ALL, Cut.RIGHT).clip(0, x0, y0, z0, x1, y1, z1, out)),
                Slip.of(
                        "cut-is-dropped",
                        (zmin, x0, y0, z0, x1, y1, z1, out) -> {
                            for (int i = 0; i < PLANES; i++)
                                if (inside(i, x0, y0, z0, zmin) < 0
                                        || inside(i, x1, y1, z1, zmin) < 0) return;
                            out.segment(x0, y0, z0, x1, y1, z1);
                        }),
                Slip.of(
                        "whole-where-any-is-inside",
                        (zmin, x0, y0, z0, x1, y1, z1, out) ->
                                right.clip(
                                        zmin,
                                        x0,
                                        y0,
                                        z0,
                                        x1,
                                        y1,
                                        z1,
                                        (ax, ay, az, bx, by, bz) ->
                                                out.segment(x0, y0, z0, x1, y1, z1))),
                Slip.of(
                        "divided-at-the-end",
                        (zmin, x0, y0, z0, x1, y1, z1, out) ->
                                right.clip(
                                        zmin,
                                        x0,
                                        y0,
                                        z0,
                                        x1,
                                        y1,
                                        z1,
                                        (ax, ay, az, bx, by, bz) ->
                                                out.segment(
                                                        ax / az, ay / az, az, bx / bz, by / bz,
                                                        bz))));
    }

    private enum Cut {
        RIGHT,
        FROM_THE_OTHER_END,
        NOT_COMPARED
    }

    private static VolumeClipper without(int plane) {
        return clipping(
                Set.copyOf(IntStream.range(0, PLANES).filter(i -> i != plane).boxed().toList()),
                Cut.RIGHT);
    }

    /** How far a point is inside a plane: of left, right, below, above, near and far. */
    private static double inside(int plane, double x, double y, double z, double zmin) {
        return switch (plane) {
            case 0 -> z + x;
            case 1 -> z - x;
            case 2 -> z + y;
            case 3 -> z - y;
            case 4 -> z - zmin;
            default -> 1 - z;
        };
    }

    private static VolumeClipper clipping(Set<Integer> planes, Cut cut) {
        return (zmin, x0, y0, z0, x1, y1, z1, out) -> {
            double in = 0;
            double on = 1;
            for (int i = 0; i < PLANES; i++) {
                if (!planes.contains(i)) continue;
                double from = inside(i, x0, y0, z0, zmin);
                double to = inside(i, x1, y1, z1, zmin);
                if (from < 0 && to < 0) return;
                double way = from / (from - to);
                if (from < 0) in = Math.max(in, cut == Cut.FROM_THE_OTHER_END ? 1 - way : way);
                else if (to < 0) on = Math.min(on, way);
            }
            if (in > on && cut != Cut.NOT_COMPARED) return;
            double[] p = {x0, y0, z0};
            double[] d = {x1 - x0, y1 - y0, z1 - z0};
            double[] a = in == 0 ? p : at(p, d, in);
            double[] b = on == 1 ? new double[] {x1, y1, z1} : at(p, d, on);
            out.segment(a[0], a[1], a[2], b[0], b[1], b[2]);
        };
    }

    private static double[] at(double[] p, double[] d, double way) {
        return new double[] {p[0] + way * d[0], p[1] + way * d[1], p[2] + way * d[2]};
    }
}
