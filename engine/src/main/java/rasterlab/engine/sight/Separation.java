package rasterlab.engine.sight;

import rasterlab.engine.scene.Mesh;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * The smallest distance in depth between faces that lie over each other on the picture and have no
 * corner in common.
 *
 * <p>1/z of a plane is linear on the picture (in parallel projection z is), so that the difference
 * of two is least at a corner of the part they share: a corner of one within the other, or where
 * two edges cross.
 */
public final class Separation {
    private final ViewedMesh view;
    private final Mesh mesh;
    private double least = Double.POSITIVE_INFINITY;

    private Separation(ViewedMesh view) {
        this.view = view;
        mesh = view.mesh();
    }

    /** World units; infinite where no two faces lie over each other. */
    public static double of(ViewedMesh view) {
        var search = new Separation(view);
        for (int a = 0; a < search.mesh.faceCount(); a++)
            for (int b = a + 1; b < search.mesh.faceCount(); b++)
                if (!search.touch(a, b)) search.compare(a, b);
        return search.least;
    }

    private boolean touch(int a, int b) {
        for (int i = 0; i < mesh.cornerCount(a); i++)
            for (int j = 0; j < mesh.cornerCount(b); j++)
                if (mesh.corner(a, i) == mesh.corner(b, j)) return true;
        return false;
    }

    private void compare(int a, int b) {
        for (int i = 0; i < mesh.cornerCount(a); i++) {
            int v = mesh.corner(a, i);
            int next = mesh.corner(a, (i + 1) % mesh.cornerCount(a));
            if (within(b, x(v), y(v))) meet(a, b, x(v), y(v));
            for (int j = 0; j < mesh.cornerCount(b); j++)
                cross(
                        a,
                        b,
                        v,
                        next,
                        mesh.corner(b, j),
                        mesh.corner(b, (j + 1) % mesh.cornerCount(b)));
        }
        for (int j = 0; j < mesh.cornerCount(b); j++) {
            int v = mesh.corner(b, j);
            if (within(a, x(v), y(v))) meet(a, b, x(v), y(v));
        }
    }

    private void cross(int a, int b, int p, int q, int r, int s) {
        double dx = x(q) - x(p);
        double dy = y(q) - y(p);
        double ex = x(s) - x(r);
        double ey = y(s) - y(r);
        double turn = dx * ey - dy * ex;
        if (turn == 0) return;
        double t = ((x(r) - x(p)) * ey - (y(r) - y(p)) * ex) / turn;
        double u = ((x(r) - x(p)) * dy - (y(r) - y(p)) * dx) / turn;
        if (t >= 0 && t <= 1 && u >= 0 && u <= 1) meet(a, b, x(p) + t * dx, y(p) + t * dy);
    }

    private void meet(int a, int b, double x, double y) {
        double apart = Math.abs(depth(a, x, y) - depth(b, x, y));
        if (apart < least) least = apart;
    }

    private boolean within(int face, double x, double y) {
        int sign = 0;
        for (int k = 0; k < mesh.cornerCount(face); k++) {
            int p = mesh.corner(face, k);
            int q = mesh.corner(face, (k + 1) % mesh.cornerCount(face));
            double side = (x(q) - x(p)) * (y - y(p)) - (y(q) - y(p)) * (x - x(p));
            if (side == 0) continue;
            int here = side > 0 ? 1 : -1;
            if (sign == -here) return false;
            sign = here;
        }
        return sign != 0;
    }

    /** Eye z of a face's plane on the line of sight through a place of the picture plane. */
    private double depth(int face, double x, double y) {
        double offset = view.planeOffset(face);
        double along = view.eyeNormal(face, 0) * x + view.eyeNormal(face, 1) * y;
        return view.transform().central()
                ? offset / (along + view.eyeNormal(face, 2))
                : (offset - along) / view.eyeNormal(face, 2);
    }

    private double x(int v) {
        return view.transform().central() ? view.eyeX(v) / view.eyeZ(v) : view.eyeX(v);
    }

    private double y(int v) {
        return view.transform().central() ? view.eyeY(v) / view.eyeZ(v) : view.eyeY(v);
    }
}
