package rasterlab.engine.clip.polygon;

/**
 * A polygon to clip by a window, each as x and y of its corners in turn; any doubles, for methods
 * refuse what is no convex window and no simple polygon.
 */
public record PolygonInWindow(double[] window, double[] subject) {
    /** The corners of an upright rectangle, counter-clockwise. */
    public static double[] rectangle(double xmin, double ymin, double xmax, double ymax) {
        return new double[] {xmin, ymin, xmax, ymin, xmax, ymax, xmin, ymax};
    }

    int corners() {
        return subject.length / 2;
    }
}
