package rasterlab.engine.transform.axis;

import rasterlab.engine.transform.Angle;
import rasterlab.engine.transform.CountingArithmetic;

/**
 * v' = q·v·q⁻¹ with q = (cos α/2, k·sin α/2), multiplied out: t = 2·(u × v), v' = v + w·t + u × t.
 *
 * <p>Source: W. R. Hamilton, Elements of Quaternions, 1866; K. Shoemake, Animating rotation with
 * quaternion curves, SIGGRAPH 1985, pp. 245–254.
 */
public final class QuaternionAxisRotation extends CheckedAxisRotation {
    @Override
    void turn(double[] through, double[] k, double degrees, double[] points) {
        double w = Angle.ofDegrees(degrees / 2).cos();
        double[] u = vectorPart(k, degrees);
        var v = new double[3];
        var t = new double[3];
        for (int at = 0; at < points.length; at += 3) {
            for (int i = 0; i < 3; i++) v[i] = points[at + i] - through[i];
            for (int i = 0; i < 3; i++) t[i] = 2 * Cross.of(u, v, i);
            for (int i = 0; i < 3; i++)
                points[at + i] = through[i] + (v[i] + (w * t[i] + Cross.of(u, t, i)));
        }
    }

    private static double[] vectorPart(double[] k, double degrees) {
        double sin = Angle.ofDegrees(degrees / 2).sin();
        return new double[] {k[0] * sin, k[1] * sin, k[2] * sin};
    }

    @Override
    void countTurn(
            CountingArithmetic on, double[] through, double[] k, double degrees, double[] points) {
        double w = Angle.ofDegrees(degrees / 2).cos();
        double[] u = vectorPart(k, degrees);
        var v = new double[3];
        var t = new double[3];
        for (int at = 0; at < points.length; at += 3) {
            for (int i = 0; i < 3; i++) v[i] = on.minus(points[at + i], through[i]);
            for (int i = 0; i < 3; i++) t[i] = on.times(2, Cross.of(on, u, v, i));
            for (int i = 0; i < 3; i++) {
                double turned = on.plus(on.times(w, t[i]), Cross.of(on, u, t, i));
                points[at + i] = on.plus(through[i], on.plus(v[i], turned));
            }
        }
    }
}
