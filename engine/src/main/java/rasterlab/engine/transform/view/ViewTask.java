package rasterlab.engine.transform.view;

/**
 * One task: points and the eye that looks at them.
 *
 * @param theta in degrees
 * @param phi in degrees
 * @param rho distance from the origin
 * @param points x, y, z one after the other
 */
public record ViewTask(double theta, double phi, double rho, double[] points) {
    public ViewTask {
        points = points.clone();
    }
}
