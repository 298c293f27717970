package rasterlab.engine.border;

import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.hidden.FacePicture;
import rasterlab.engine.visibility.hidden.SurfaceView;

/**
 * Pixels of topic {@code hidden-surfaces} whose centre lies on an edge within rounding, or in which
 * two faces meet: there, the topic says, answers may differ.
 */
final class SightLimits {
    /** Pixels between a centre and what still counts as passing through it. */
    private static final double REACH = 1e-5;

    private final ViewedMesh view;
    private final PictureFit fit;

    private SightLimits(ViewedMesh view) {
        this.view = view;
        fit = view.fit();
    }

    /** Whether all pixels that differ are such. */
    static boolean excuse(SurfaceView input, FacePicture exact, FacePicture actual) {
        var limits = new SightLimits(input.view());
        for (int y = 0; y < exact.height(); y++)
            for (int x = 0; x < exact.width(); x++) {
                int right = exact.face(x, y);
                int shown = actual.face(x, y);
                if (right != shown && !limits.passNear(x, y) && !limits.meet(right, shown, x, y))
                    return false;
            }
        return true;
    }

    /** Whether an edge of any face is seen at the pixel's centre. */
    private boolean passNear(int x, int y) {
        for (int face = 0; face < view.mesh().faceCount(); face++) {
            int corners = view.mesh().cornerCount(face);
            for (int k = 0; k < corners; k++)
                if (passesNear(
                        view.mesh().corner(face, k),
                        view.mesh().corner(face, (k + 1) % corners),
                        x,
                        y)) return true;
        }
        return false;
    }

    private boolean passesNear(int one, int other, int x, int y) {
        double[] a = eye(one);
        double[] b = eye(other);
        if (a[2] < view.near() && b[2] < view.near()) return false;
        if (a[2] < view.near()) a = cut(b, a);
        if (b[2] < view.near()) b = cut(a, b);
        double ax = pixelX(a) - x;
        double ay = pixelY(a) - y;
        double dx = pixelX(b) - x - ax;
        double dy = pixelY(b) - y - ay;
        double length = Math.hypot(dx, dy);
        double along = length == 0 ? 0 : -(ax * dx + ay * dy) / length / length;
        double t = Math.max(0, Math.min(1, along));
        return Math.hypot(ax + t * dx, ay + t * dy) <= REACH;
    }

    private double[] eye(int vertex) {
        return new double[] {view.eyeX(vertex), view.eyeY(vertex), view.eyeZ(vertex)};
    }

    private double[] cut(double[] kept, double[] lost) {
        double t = (kept[2] - view.near()) / (kept[2] - lost[2]);
        var end = new double[3];
        for (int i = 0; i < 2; i++) end[i] = kept[i] + t * (lost[i] - kept[i]);
        end[2] = view.near();
        return end;
    }

    private double pixelX(double[] eye) {
        return fit.toPixelX(eye[0] * shrink(eye[2]));
    }

    private double pixelY(double[] eye) {
        return fit.toPixelY(eye[1] * shrink(eye[2]));
    }

    private double shrink(double z) {
        return view.transform().central() ? view.transform().distance() / z : 1;
    }

    /** Whether two faces' planes, or a face's plane and the near plane, cross at the centre. */
    private boolean meet(int one, int other, int x, int y) {
        double here = nearness(one, x, y) - nearness(other, x, y);
        double steps =
                Math.abs(nearness(one, x + 1, y) - nearness(other, x + 1, y) - here)
                        + Math.abs(nearness(one, x, y + 1) - nearness(other, x, y + 1) - here);
        return Math.abs(here) <= REACH * steps;
    }

    /** 1/z in perspective, −z in parallel projection: linear in the pixel. */
    private double nearness(int face, int x, int y) {
        boolean central = view.transform().central();
        if (face == FacePicture.NOTHING) return central ? 1 / view.near() : -view.near();
        double planeX = fit.toPlaneX(x);
        double planeY = fit.toPlaneY(y);
        double nx = view.eyeNormal(face, 0);
        double ny = view.eyeNormal(face, 1);
        double nz = view.eyeNormal(face, 2);
        double rho = view.transform().distance();
        double offset = view.planeOffset(face);
        return central
                ? (nx * planeX / rho + ny * planeY / rho + nz) / offset
                : -(offset - nx * planeX - ny * planeY) / nz;
    }
}
