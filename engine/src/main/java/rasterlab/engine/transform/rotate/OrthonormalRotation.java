package rasterlab.engine.transform.rotate;

import rasterlab.engine.transform.Angle;

/**
 * The matrix is multiplied up, made orthonormal again in every turn and applied to the points once,
 * at the end: the radius cannot drift, the angle still can.
 *
 * <p>Source: D. F. Rogers, J. A. Adams, Mathematical Elements for Computer Graphics, 1976.
 */
final class OrthonormalRotation extends CountedRotation {
    @Override
    void turn(TurnLoops loops, double degrees, int times, double[] points) {
        Angle all = loops.accumulate(Angle.ofDegrees(degrees), times);
        loops.turn(all, 1, points);
    }
}
