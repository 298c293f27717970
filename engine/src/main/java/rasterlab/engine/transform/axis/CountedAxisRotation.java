package rasterlab.engine.transform.axis;

import org.joml.Vector3d;
import rasterlab.contract.AxisRotation;
import rasterlab.engine.transform.Arithmetic;
import rasterlab.engine.transform.Coordinates;
import rasterlab.engine.transform.Directions;

/** A method whose work on each point can be counted. */
abstract class CountedAxisRotation implements AxisRotation {
    @Override
    public final void rotate(
            double[] through, double[] direction, double degrees, double[] points) {
        rotate(Arithmetic.PLAIN, through, direction, degrees, points);
    }

    final void rotate(
            Arithmetic on, double[] through, double[] direction, double degrees, double[] points) {
        turn(on, through, checked(through, direction, points), degrees, points);
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
    abstract void turn(
            Arithmetic on, double[] through, double[] k, double degrees, double[] points);
}
