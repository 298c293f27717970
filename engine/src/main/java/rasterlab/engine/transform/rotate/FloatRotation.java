package rasterlab.engine.transform.rotate;

import rasterlab.engine.transform.Angle;
import rasterlab.engine.transform.Coordinates;

/** The direct formula in float: sine and cosine are off by up to 2⁻²⁴, n turns add that up. */
final class FloatRotation extends CountedRotation {
    @Override
    void require(double degrees, int times, double[] points) {
        require(degrees, times, points, Coordinates.LARGEST_FLOAT);
        Coordinates.requireFloat(points, 2);
    }

    @Override
    void turn(TurnLoops loops, double degrees, int times, double[] points) {
        loops.turnInFloat(Angle.ofDegrees(degrees), times, points);
    }
}
