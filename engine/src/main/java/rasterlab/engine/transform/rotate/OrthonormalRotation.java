package rasterlab.engine.transform.rotate;

import rasterlab.engine.transform.Angle;
import rasterlab.engine.transform.Arithmetic;

/** The matrix is multiplied up and made orthonormal again in every turn. */
final class OrthonormalRotation extends AccumulatedRotation {
    @Override
    void turn(Arithmetic on, double degrees, int times, double[] points) {
        Angle all = accumulate(on, Angle.ofDegrees(degrees), times);
        for (int at = 0; at < points.length; at += 2) PointTurn.repeat(on, all, 1, points, at);
    }
}
