package rasterlab.engine.transform.axis;

import rasterlab.engine.transform.Angle;
import rasterlab.engine.transform.Arithmetic;

/**
 * v' = v·cos + (k × v)·sin + k·(k·v)·(1 − cos), with v from a point of the axis and k along it.
 *
 * <p>1 − cos is taken as 2·sin² of the half angle, which does not cancel for small angles.
 *
 * <p>Source: O. Rodrigues, Journal de mathématiques pures et appliquées 5, 1840, pp. 380–440.
 */
public final class RodriguesRotation extends CountedAxisRotation {
    @Override
    void turn(Arithmetic on, double[] through, double[] k, double degrees, double[] points) {
        Angle by = Angle.ofDegrees(degrees);
        double half = Angle.ofDegrees(degrees / 2).sin();
        double lost = 2 * half * half;
        for (int at = 0; at < points.length; at += 3)
            turn(on, through, k, by.sin(), by.cos(), lost, points, at);
    }

    private static void turn(
            Arithmetic on,
            double[] through,
            double[] k,
            double sin,
            double cos,
            double lost,
            double[] points,
            int at) {
        double x = on.minus(points[at], through[0]);
        double y = on.minus(points[at + 1], through[1]);
        double z = on.minus(points[at + 2], through[2]);
        double along =
                on.times(
                        on.plus(on.plus(on.times(k[0], x), on.times(k[1], y)), on.times(k[2], z)),
                        lost);
        double crossX = on.minus(on.times(k[1], z), on.times(k[2], y));
        double crossY = on.minus(on.times(k[2], x), on.times(k[0], z));
        double crossZ = on.minus(on.times(k[0], y), on.times(k[1], x));
        points[at] = sum(on, through[0], x, cos, crossX, sin, k[0], along);
        points[at + 1] = sum(on, through[1], y, cos, crossY, sin, k[1], along);
        points[at + 2] = sum(on, through[2], z, cos, crossZ, sin, k[2], along);
    }

    private static double sum(
            Arithmetic on,
            double through,
            double v,
            double cos,
            double cross,
            double sin,
            double k,
            double along) {
        double turned = on.plus(on.times(v, cos), on.times(cross, sin));
        return on.plus(through, on.plus(turned, on.times(k, along)));
    }
}
