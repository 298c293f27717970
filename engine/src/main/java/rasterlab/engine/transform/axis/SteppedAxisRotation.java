package rasterlab.engine.transform.axis;

import java.util.List;
import rasterlab.engine.transform.Arithmetic;

/** A method made of seven steps; drawing and stepping go through the same walk. */
public abstract class SteppedAxisRotation extends CountedAxisRotation {
    abstract List<AxisStep> steps(double[] through, double[] k, double degrees);

    @Override
    final void turn(Arithmetic on, double[] through, double[] k, double degrees, double[] points) {
        var walk = new AxisWalk(on, steps(through, k, degrees), points);
        while (walk.advance()) {}
    }

    /**
     * A walk that takes {@code points} through the steps, all points in each.
     *
     * @throws IllegalArgumentException as {@link #rotate} does
     */
    public AxisWalk walk(double[] through, double[] direction, double degrees, double[] points) {
        double[] k = checked(through, direction, points);
        return new AxisWalk(Arithmetic.PLAIN, steps(through, k, degrees), points);
    }
}
