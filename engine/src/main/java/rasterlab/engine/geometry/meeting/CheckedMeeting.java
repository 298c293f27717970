package rasterlab.engine.geometry.meeting;

import rasterlab.contract.LinePlane;
import rasterlab.engine.geometry.Line;
import rasterlab.engine.geometry.Plane;
import rasterlab.engine.geometry.Vector;

/**
 * The course's formula with n·p* = 0 refused, and products by powers of two near 1: {@link
 * Plane#meets}.
 *
 * <p>Both products are rounded: where the line is nearly parallel, n·p* and with it μ lose digits.
 */
final class CheckedMeeting implements LinePlane {
    @Override
    public double meets(double[] normal, double c, double[] from, double[] through) {
        return new Plane(vector(normal), c).meets(new Line(vector(from), vector(through)));
    }

    private static Vector vector(double[] xyz) {
        return new Vector(xyz[0], xyz[1], xyz[2]);
    }
}
