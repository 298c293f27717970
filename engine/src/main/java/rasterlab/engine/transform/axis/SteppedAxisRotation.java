package rasterlab.engine.transform.axis;

import java.util.List;
import rasterlab.engine.transform.CountingArithmetic;

/** A method made of seven steps; drawing and stepping go through the same walk. */
public abstract class SteppedAxisRotation extends CheckedAxisRotation {
    abstract List<AxisStep> steps(double[] through, double[] k, double degrees);

    @Override
    final void turn(double[] through, double[] k, double degrees, double[] points) {
        var walk = new AxisWalk(steps(through, k, degrees), points);
        while (walk.advance()) {}
    }

    @Override
    final void countTurn(
            CountingArithmetic on, double[] through, double[] k, double degrees, double[] points) {
        for (AxisStep step : steps(through, k, degrees))
            for (int at = 0; at < points.length; at += 3) step.count(on, points, at);
    }

    /**
     * A walk that takes {@code points} through the steps, all points in each.
     *
     * @throws IllegalArgumentException as {@link #rotate} does
     */
    public AxisWalk walk(double[] through, double[] direction, double degrees, double[] points) {
        double[] k = checked(through, direction, points);
        return new AxisWalk(steps(through, k, degrees), points);
    }
}
