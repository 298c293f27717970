package rasterlab.engine.transform.rotate;

import rasterlab.engine.transform.Angle;

/**
 * x' = x·cos θ − y·sin θ, y' = x·sin θ + y·cos θ in every turn.
 *
 * <p>The rounded sine and cosine belong to a slightly other angle and radius, by up to 2⁻⁵³; n
 * turns add that up n times.
 */
final class DirectRotation extends CountedRotation implements SteppedRotation {
    @Override
    void turn(TurnLoops loops, double degrees, int times, double[] points) {
        Angle by = Angle.ofDegrees(degrees);
        loops.turn(by, times, points);
    }

    @Override
    public TurnWalk walk(double degrees, int times, double x, double y) {
        require(degrees, times, new double[] {x, y});
        return new DirectWalk(Angle.ofDegrees(degrees), times, x, y);
    }
}
