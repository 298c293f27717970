package rasterlab.engine.pipeline;

import java.util.function.IntToDoubleFunction;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.transform.SphericalView;

/**
 * Finds what a pixel shows from the ray through its centre alone: no projection, no clipping, no
 * tables. Written without any of the renderer's code.
 */
final class PlainRays {
    /** The triangle that a ray meets, and the weights of its corners there. */
    record Hit(int face, int fan, double[] weights, double[] point) {}

    private final Mesh mesh;
    private final double[] eye;
    private final double[] right;
    private final double[] up;
    private final double[] forward;
    private final boolean central;
    private final double pixelsPerUnit;
    private final int width;
    private final int height;

    PlainRays(Scene scene, SphericalView camera, boolean central, int width, int height) {
        mesh = scene.mesh();
        double t = camera.thetaRadians();
        double p = camera.phiRadians();
        double[] out = {Math.sin(p) * Math.cos(t), Math.sin(p) * Math.sin(t), Math.cos(p)};
        eye = times(camera.rho(), out);
        forward = times(-1, out);
        right = new double[] {-Math.sin(t), Math.cos(t), 0};
        up = new double[] {-Math.cos(p) * Math.cos(t), -Math.cos(p) * Math.sin(t), Math.sin(p)};
        this.central = central;
        this.width = width;
        this.height = height;
        pixelsPerUnit = scene.pictureScale() * Math.min(width / 800.0, height / 600.0);
    }

    /** A cavalier picture: rays slant to the right and up as they go away along the world's y. */
    static PlainRays cavalier(Scene scene, double rho, int width, int height) {
        var rays = new PlainRays(scene, new SphericalView(0, 1, rho), false, width, height);
        double share = Math.sqrt(0.5);
        fill(rays.eye, 0, -rho, 0);
        fill(rays.right, 1, 0, 0);
        fill(rays.up, 0, 0, 1);
        fill(rays.forward, -share, 1, -share);
        double[] from = times(-rho, rays.forward);
        System.arraycopy(from, 0, rays.eye, 0, 3);
        return rays;
    }

    private static void fill(double[] vector, double x, double y, double z) {
        vector[0] = x;
        vector[1] = y;
        vector[2] = z;
    }

    /** The direction from a point to the eye. */
    double[] toEye(double[] point) {
        return unit(central ? minus(eye, point) : times(-1, forward));
    }

    /** The direction to an infinitely far viewer. */
    double[] toFarEye() {
        return unit(times(-1, forward));
    }

    /** The face that a pixel's ray meets first; null for the background. */
    Hit hit(double pixelX, double pixelY) {
        double u = (pixelX - width / 2) / pixelsPerUnit;
        double v = (height / 2 - pixelY) / pixelsPerUnit;
        double[] across = plus(times(u, right), times(v, up));
        double[] origin = central ? eye : plus(eye, across);
        double[] ray = central ? plus(times(length(eye), forward), across) : forward;
        Hit best = null;
        double nearest = Double.POSITIVE_INFINITY;
        for (int f = 0; f < mesh.faceCount(); f++)
            for (int fan = 1; fan + 1 < mesh.cornerCount(f); fan++) {
                double[] a = corner(f, 0);
                double[] e1 = minus(corner(f, fan), a);
                double[] e2 = minus(corner(f, fan + 1), a);
                double[] p = cross(ray, e2);
                double det = dot(e1, p);
                if (det == 0) continue;
                double[] s = minus(origin, a);
                double w1 = dot(s, p) / det;
                double[] q = cross(s, e1);
                double w2 = dot(ray, q) / det;
                double t = dot(e2, q) / det;
                if (w1 < 0 || w2 < 0 || w1 + w2 > 1 || t <= 0 || t >= nearest) continue;
                nearest = t;
                double[] weights = {1 - w1 - w2, w1, w2};
                best = new Hit(f, fan, weights, plus(origin, times(t, ray)));
            }
        return best;
    }

    /** Whether the pixels around show the same triangle: away from edges nobody may differ. */
    boolean inside(int x, int y, Hit hit) {
        for (double dx : new double[] {-0.01, 0.01})
            for (double dy : new double[] {-0.01, 0.01}) {
                Hit near = hit(x + dx, y + dy);
                if (near == null || near.face() != hit.face()) return false;
            }
        return true;
    }

    private double[] corner(int face, int corner) {
        int v = mesh.corner(face, corner);
        return new double[] {mesh.x(v), mesh.y(v), mesh.z(v)};
    }

    /** A corner's quantity mixed at a hit. */
    double mixed(Hit hit, IntToDoubleFunction ofCorner) {
        return hit.weights()[0] * ofCorner.applyAsDouble(0)
                + hit.weights()[1] * ofCorner.applyAsDouble(hit.fan())
                + hit.weights()[2] * ofCorner.applyAsDouble(hit.fan() + 1);
    }

    static double[] plus(double[] a, double[] b) {
        return new double[] {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
    }

    static double[] minus(double[] a, double[] b) {
        return new double[] {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    }

    static double[] times(double share, double[] a) {
        return new double[] {share * a[0], share * a[1], share * a[2]};
    }

    static double[] cross(double[] a, double[] b) {
        return new double[] {
            a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
        };
    }

    static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    static double length(double[] a) {
        return Math.sqrt(dot(a, a));
    }

    static double[] unit(double[] a) {
        return times(1 / length(a), a);
    }
}
