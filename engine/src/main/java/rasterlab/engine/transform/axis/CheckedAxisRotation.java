package rasterlab.engine.transform.axis;

import org.joml.Vector3d;
import rasterlab.contract.AxisRotation;
import rasterlab.engine.transform.Coordinates;
import rasterlab.engine.transform.CountingArithmetic;
import rasterlab.engine.transform.Directions;

/** A method that looks at its arguments first, with a twin that counts its work on the points. */
abstract class CheckedAxisRotation implements AxisRotation {
    @Override
    public final void rotate(
            double[] through, double[] direction, double degrees, double[] points) {
        turn(through, checked(through, direction, points), degrees, points);
    }

    final void count(
            CountingArithmetic on,
            double[] through,
            double[] direction,
            double degrees,
            double[] points) {
        countTurn(on, through, checked(through, direction, points), degrees, points);
    }

    /** The unit vector along the axis, if everything is in range. */
    static double[] checked(double[] through, double[] direction, double[] points) {
        Coordinates.requireVector("through", through, Coordinates.LARGEST);
        Coordinates.requireVector("direction", direction, Double.MAX_VALUE);
        if (direction[0] == 0 && direction[1] == 0 && direction[2] == 0)
            throw new IllegalArgumentException("direction must not be zero, got (0, 0, 0)");
        Coordinates.require(points, 3, Coordinates.LARGEST);
        return unit(direction);
    }

    private static double[] unit(double[] direction) {
        Vector3d unit = Directions.unit(new Vector3d(direction));
        return new double[] {unit.x, unit.y, unit.z};
    }

    /**
     * @param k unit vector along the axis
     */
    abstract void turn(double[] through, double[] k, double degrees, double[] points);

    /** Turns the points operation by operation, each of them counted. */
    abstract void countTurn(
            CountingArithmetic on, double[] through, double[] k, double degrees, double[] points);
}
