package rasterlab.engine.spline.curve;

/**
 * One step on the way to a point of a curve.
 *
 * @param text what the step did
 * @param factor what it multiplied by: u, or the weight of a control point
 * @param x of the points it left; the last step leaves the curve's point alone
 * @param y of the same points
 */
public record PointStep(String text, double factor, double[] x, double[] y) {
    /** A step that leaves one point. */
    static PointStep of(String text, double factor, double x, double y) {
        return new PointStep(text, factor, new double[] {x}, new double[] {y});
    }
}
