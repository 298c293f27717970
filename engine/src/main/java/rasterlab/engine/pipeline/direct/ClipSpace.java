package rasterlab.engine.pipeline.direct;

import java.util.List;
import org.joml.Matrix4d;
import rasterlab.engine.pipeline.fast.Culling;
import rasterlab.engine.pipeline.fast.TriangleView;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.ViewTransform;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * The way from the world to the clip space in which −w ≤ x, y, z ≤ w is drawn.
 *
 * <p>With s pixels per unit, the picture's middle at pixel (c₁, c₂) and d = ρ in perspective, 1
 * otherwise: {@code x/w = 2·s·d·X/(width·w) + (2·c₁ + 1)/width − 1}, y alike with its sign turned,
 * w = z of eye space or 1. Depth runs from the nearest to the farthest vertex of the scene, so that
 * its bits are spent where there is something.
 */
final class ClipSpace {
    /** Room before the nearest and behind the farthest vertex, as a share of their depths. */
    private static final double ROOM = 1e-5;

    private final ViewTransform transform;
    private final PictureFit fit;
    private final List<double[]> planes;
    private final double near;
    private final double far;

    ClipSpace(ViewedMesh view) {
        transform = view.transform();
        fit = view.fit();
        planes =
                view.clipPlanes().stream()
                        .map(plane -> new double[] {plane.a(), plane.b(), plane.c(), plane.d()})
                        .toList();
        double nearest = Double.POSITIVE_INFINITY;
        double farthest = Double.NEGATIVE_INFINITY;
        for (int v = 0; v < view.mesh().vertexCount(); v++) {
            nearest = Math.min(nearest, view.eyeZ(v));
            farthest = Math.max(farthest, view.eyeZ(v));
        }
        double room = ROOM * Math.max(Math.abs(nearest), Math.abs(farthest));
        near = Math.max(view.near(), nearest - room);
        far = Math.min(view.far(), farthest + room);
    }

    /** Whether nothing lies between the near and the far plane. */
    boolean empty() {
        return !(near < far);
    }

    /** The pipeline's view, whose eye space is the world. */
    TriangleView view() {
        return new TriangleView(new Matrix4d(), worldToClip(), planes, Culling.NONE);
    }

    private Matrix4d worldToClip() {
        double[] w = transform.central() ? eyeRow(2) : new double[] {0, 0, 0, 1};
        double distance = transform.central() ? transform.distance() : 1;
        double[] x =
                sum(
                        2 * fit.pixelsPerUnit() * distance / fit.width(),
                        eyeRow(0),
                        (2 * fit.toPixelX(0) + 1) / fit.width() - 1,
                        w);
        double[] y =
                sum(
                        2 * fit.pixelsPerUnit() * distance / fit.height(),
                        eyeRow(1),
                        1 - (2 * fit.toPixelY(0) + 1) / fit.height(),
                        w);
        double[] z = depthRow();
        return new Matrix4d(
                x[0], y[0], z[0], w[0], //
                x[1], y[1], z[1], w[1], //
                x[2], y[2], z[2], w[2], //
                x[3], y[3], z[3], w[3]);
    }

    /** The matrix row for the depth: −w at the near plane to w at the far one. */
    private double[] depthRow() {
        double[] one = {0, 0, 0, 1};
        double deep = far - near;
        return transform.central()
                ? sum((far + near) / deep, eyeRow(2), -2 * far * near / deep, one)
                : sum(2 / deep, eyeRow(2), -(far + near) / deep, one);
    }

    /** The factors of x, y, z and 1 in one view coordinate. */
    private double[] eyeRow(int axis) {
        double origin = transform.toEye(axis, 0, 0, 0);
        return new double[] {
            transform.toEye(axis, 1, 0, 0) - origin,
            transform.toEye(axis, 0, 1, 0) - origin,
            transform.toEye(axis, 0, 0, 1) - origin,
            origin
        };
    }

    private static double[] sum(double a, double[] p, double b, double[] q) {
        double[] sum = new double[4];
        for (int i = 0; i < 4; i++) sum[i] = a * p[i] + b * q[i];
        return sum;
    }
}
