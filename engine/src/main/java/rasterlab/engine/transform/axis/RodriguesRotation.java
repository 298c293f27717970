package rasterlab.engine.transform.axis;

import rasterlab.engine.transform.Angle;
import rasterlab.engine.transform.CountingArithmetic;

/**
 * v' = v·cos + (k × v)·sin + k·(k·v)·(1 − cos), with v from a point of the axis and k along it.
 *
 * <p>1 − cos is taken as 2·sin² of the half angle, which does not cancel for small angles.
 *
 * <p>Source: O. Rodrigues, Journal de mathématiques pures et appliquées 5, 1840, pp. 380–440.
 */
public final class RodriguesRotation extends CheckedAxisRotation {
    @Override
    void turn(double[] through, double[] k, double degrees, double[] points) {
        Angle by = Angle.ofDegrees(degrees);
        double lost = lost(degrees);
        var v = new double[3];
        for (int at = 0; at < points.length; at += 3) {
            for (int i = 0; i < 3; i++) v[i] = points[at + i] - through[i];
            double along = (k[0] * v[0] + k[1] * v[1] + k[2] * v[2]) * lost;
            for (int i = 0; i < 3; i++)
                points[at + i] =
                        through[i]
                                + (v[i] * by.cos() + Cross.of(k, v, i) * by.sin() + k[i] * along);
        }
    }

    /** 1 − cos. */
    private static double lost(double degrees) {
        double half = Angle.ofDegrees(degrees / 2).sin();
        return 2 * half * half;
    }

    @Override
    void countTurn(
            CountingArithmetic on, double[] through, double[] k, double degrees, double[] points) {
        Angle by = Angle.ofDegrees(degrees);
        double lost = lost(degrees);
        var v = new double[3];
        for (int at = 0; at < points.length; at += 3) {
            for (int i = 0; i < 3; i++) v[i] = on.minus(points[at + i], through[i]);
            double dot = on.plus(on.times(k[0], v[0]), on.times(k[1], v[1]));
            double along = on.times(on.plus(dot, on.times(k[2], v[2])), lost);
            for (int i = 0; i < 3; i++) {
                double cross = on.times(Cross.of(on, k, v, i), by.sin());
                double turned = on.plus(on.times(v[i], by.cos()), cross);
                points[at + i] = on.plus(through[i], on.plus(turned, on.times(k[i], along)));
            }
        }
    }
}
