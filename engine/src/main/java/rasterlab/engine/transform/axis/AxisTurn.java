package rasterlab.engine.transform.axis;

/**
 * One task: points, the line they turn about and the angle.
 *
 * @param through a point of the line
 * @param direction of the line, any length but 0
 * @param degrees counter-clockwise seen from where {@code direction} points to
 * @param points x, y, z one after the other
 */
public record AxisTurn(double[] through, double[] direction, double degrees, double[] points) {
    public AxisTurn {
        through = through.clone();
        direction = direction.clone();
        points = points.clone();
    }

    /** The line through (x, y, z). */
    static AxisTurn about(double x, double y, double z, double degrees, double... points) {
        return new AxisTurn(new double[3], new double[] {x, y, z}, degrees, points);
    }
}
