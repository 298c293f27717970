package rasterlab.engine.transform.rotate;

import rasterlab.engine.transform.Angle;
import rasterlab.engine.transform.Arithmetic;

/**
 * The quaternion (w, 0, 0, z) = (cos θ/2, 0, 0, sin θ/2) is multiplied up and normalised in every
 * turn; cos = w² − z², sin = 2·w·z at the end.
 *
 * <p>Source: K. Shoemake, Animating rotation with quaternion curves, SIGGRAPH 1985, pp. 245–254.
 */
final class QuaternionRotation extends AccumulatedRotation {
    @Override
    void turn(Arithmetic on, double degrees, int times, double[] points) {
        Angle q = accumulate(on, Angle.ofDegrees(degrees / 2), times);
        double zw = on.times(q.sin(), q.cos());
        double cos = on.times(on.minus(q.cos(), q.sin()), on.plus(q.cos(), q.sin()));
        var all = new Angle(on.plus(zw, zw), cos);
        for (int at = 0; at < points.length; at += 2) PointTurn.repeat(on, all, 1, points, at);
    }
}
