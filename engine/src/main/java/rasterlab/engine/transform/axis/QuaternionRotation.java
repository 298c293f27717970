package rasterlab.engine.transform.axis;

import rasterlab.engine.transform.Angle;
import rasterlab.engine.transform.Arithmetic;

/**
 * v' = q·v·q⁻¹ with q = (cos α/2, k·sin α/2), multiplied out: t = 2·(u × v), v' = v + w·t + u × t.
 *
 * <p>Source: W. R. Hamilton, Elements of Quaternions, 1866; K. Shoemake, Animating rotation with
 * quaternion curves, SIGGRAPH 1985, pp. 245–254.
 */
public final class QuaternionRotation extends CountedAxisRotation {
    @Override
    void turn(Arithmetic on, double[] through, double[] k, double degrees, double[] points) {
        Angle half = Angle.ofDegrees(degrees / 2);
        double[] u = {k[0] * half.sin(), k[1] * half.sin(), k[2] * half.sin()};
        var v = new double[3];
        var t = new double[3];
        for (int at = 0; at < points.length; at += 3) {
            for (int i = 0; i < 3; i++) v[i] = on.minus(points[at + i], through[i]);
            for (int i = 0; i < 3; i++) {
                double cross = cross(on, u, v, i);
                t[i] = on.plus(cross, cross);
            }
            for (int i = 0; i < 3; i++) {
                double turned = on.plus(on.times(half.cos(), t[i]), cross(on, u, t, i));
                points[at + i] = on.plus(through[i], on.plus(v[i], turned));
            }
        }
    }

    private static double cross(Arithmetic on, double[] a, double[] b, int i) {
        int j = i == 2 ? 0 : i + 1;
        int k = i == 0 ? 2 : i - 1;
        return on.minus(on.times(a[j], b[k]), on.times(a[k], b[j]));
    }
}
