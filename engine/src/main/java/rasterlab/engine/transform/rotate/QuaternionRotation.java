package rasterlab.engine.transform.rotate;

import rasterlab.engine.transform.Angle;

/**
 * The quaternion (w, 0, 0, z) = (cos θ/2, 0, 0, sin θ/2) is multiplied up and normalised in every
 * turn; cos = w² − z², sin = 2·w·z at the end.
 *
 * <p>Source: K. Shoemake, Animating rotation with quaternion curves, SIGGRAPH 1985, pp. 245–254.
 */
final class QuaternionRotation extends CountedRotation {
    @Override
    void turn(TurnLoops loops, double degrees, int times, double[] points) {
        Angle q = loops.accumulate(Angle.ofDegrees(degrees / 2), times);
        loops.turn(loops.twice(q), 1, points);
    }
}
