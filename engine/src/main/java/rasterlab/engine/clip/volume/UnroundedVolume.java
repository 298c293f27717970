package rasterlab.engine.clip.volume;

import java.math.BigDecimal;
import rasterlab.contract.SpaceSegmentSink;
import rasterlab.engine.clip.UnroundedInterval;
import rasterlab.engine.range.Finite;

/** Clips a segment by the view volume without rounding before its last step. */
final class UnroundedVolume {
    private UnroundedVolume() {}

    /**
     * Checks all numbers, then does what {@link rasterlab.contract.VolumeClipper} says.
     *
     * @throws IllegalArgumentException if a coordinate is not finite or {@code zmin} is not above 0
     *     and below 1
     */
    static void clip(
            double zmin,
            double x0,
            double y0,
            double z0,
            double x1,
            double y1,
            double z1,
            SpaceSegmentSink out) {
        requireInside(zmin);
        Finite.require("x of end", x0, x1);
        Finite.require("y of end", y0, y1);
        Finite.require("z of end", z0, z1);
        if (Math.max(z0, z1) < zmin || Math.min(z0, z1) > 1) return;
        var left = new UnroundedInterval();
        if (left.cutBelow(z0, z1, zmin)
                && left.cutAbove(z0, z1, 1)
                && cutBySlopes(left, x0, z0, x1, z1)
                && cutBySlopes(left, y0, z0, y1, z1)) send(left, x0, y0, z0, x1, y1, z1, zmin, out);
    }

    /**
     * @throws IllegalArgumentException if {@code zmin} is not above 0 and below 1
     */
    static void requireInside(double zmin) {
        if (!(zmin > 0 && zmin < 1))
            throw new IllegalArgumentException(
                    "zmin must be a number above 0 and below 1, got " + zmin);
    }

    /** Cuts at c = z and c = −z. */
    private static boolean cutBySlopes(
            UnroundedInterval left, double c0, double z0, double c1, double z1) {
        return left.cut(UnroundedInterval.difference(z0, c0), UnroundedInterval.difference(z1, c1))
                && left.cut(sum(z0, c0), sum(z1, c1));
    }

    private static BigDecimal sum(double a, double b) {
        return new BigDecimal(a).add(new BigDecimal(b));
    }

    /** Each coordinate is rounded on its own; the slopes may then be passed by a last step. */
    private static void send(
            UnroundedInterval left,
            double x0,
            double y0,
            double z0,
            double x1,
            double y1,
            double z1,
            double zmin,
            SpaceSegmentSink out) {
        double fromZ = Math.max(zmin, Math.min(1, left.atEnter(z0, z1)));
        double toZ = Math.max(zmin, Math.min(1, left.atLeave(z0, z1)));
        out.segment(
                Math.max(-fromZ, Math.min(fromZ, left.atEnter(x0, x1))),
                Math.max(-fromZ, Math.min(fromZ, left.atEnter(y0, y1))),
                fromZ,
                Math.max(-toZ, Math.min(toZ, left.atLeave(x0, x1))),
                Math.max(-toZ, Math.min(toZ, left.atLeave(y0, y1))),
                toZ);
    }
}
