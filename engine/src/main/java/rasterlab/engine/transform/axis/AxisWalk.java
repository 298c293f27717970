package rasterlab.engine.transform.axis;

import java.util.List;

/** Points on their way through the seven steps; a new walk stands before the first. */
public final class AxisWalk {
    private final List<AxisStep> steps;
    private final double[] points;
    private int next;

    AxisWalk(List<AxisStep> steps, double[] points) {
        this.steps = steps;
        this.points = points;
    }

    /** Takes the next step; false when there is none. */
    public boolean advance() {
        if (next == steps.size()) return false;
        AxisStep step = steps.get(next++);
        for (int at = 0; at < points.length; at += 3) step.apply(points, at);
        return true;
    }

    /** The step just taken. */
    public String text() {
        return steps.get(next - 1).text();
    }

    /** Where the points are now: x, y, z one after the other. */
    public double[] points() {
        return points.clone();
    }
}
