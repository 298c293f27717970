package rasterlab.engine.sight;

import rasterlab.engine.scene.Mesh;
import rasterlab.engine.visibility.Tally;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.painter.Painter;

/**
 * Whether the painter's order by mean depth is right for a view, proved pair by pair.
 *
 * <p>A face may be painted before another where their boxes on the picture are apart, or it is
 * nowhere nearer than the other is far, or it lies wholly behind the other's plane, or the other
 * wholly before its plane. These are the first four of Newell's tests.
 *
 * <p>Source: M. E. Newell, R. G. Newell, T. L. Sancha, A solution to the hidden surface problem,
 * ACM Annual Conference, 1972, pp. 443–450.
 */
public final class PaintOrder {
    /** How far beyond a plane still counts as in it, as a share of the distance from the eye. */
    private static final double ROOM = 1e-9;

    private final ViewedMesh view;
    private final Mesh mesh;
    private final double[][] box;

    private PaintOrder(ViewedMesh view) {
        this.view = view;
        mesh = view.mesh();
        box = new double[mesh.faceCount()][];
        for (int f = 0; f < box.length; f++) box[f] = box(f);
    }

    /** Faces that lie over each other in one plane have no order here; they must be ruled out. */
    public static boolean proved(ViewedMesh view) {
        if (view.cutsOpen()) return false;
        return new PaintOrder(view).holds();
    }

    private boolean holds() {
        double[] depth = Painter.meanZ(view);
        int[] all = new int[depth.length];
        for (int f = 0; f < all.length; f++) all[f] = f;
        int[] order = Painter.farthestFirst(depth, all, new Tally());
        for (int i = 0; i < order.length; i++)
            for (int j = i + 1; j < order.length; j++)
                if (!mayPrecede(order[i], order[j])) return false;
        return true;
    }

    private boolean mayPrecede(int first, int second) {
        double[] a = box[first];
        double[] b = box[second];
        if (a[0] >= b[1] || b[0] >= a[1] || a[2] >= b[3] || b[2] >= a[3]) return true;
        if (a[4] >= b[5]) return true;
        return onSide(first, second, -1) || onSide(second, first, 1);
    }

    /**
     * Whether a face is on one side of another's plane.
     *
     * @param eyeSide 1 for the eye's, −1 for the far one
     */
    private boolean onSide(int face, int of, int eyeSide) {
        double offset = view.planeOffset(of);
        // n·p − c is −c at the eye of a perspective picture; in parallel projection it grows
        // towards the eye as −n_z does.
        double eye = view.transform().central() ? -offset : -view.eyeNormal(of, 2);
        double side = eyeSide * Math.signum(eye);
        if (side == 0) return false;
        for (int k = 0; k < mesh.cornerCount(face); k++) {
            int v = mesh.corner(face, k);
            double x = view.eyeNormal(of, 0) * view.eyeX(v);
            double y = view.eyeNormal(of, 1) * view.eyeY(v);
            double z = view.eyeNormal(of, 2) * view.eyeZ(v);
            double room = ROOM * (Math.abs(x) + Math.abs(y) + Math.abs(z) + Math.abs(offset));
            if (side * (x + y + z - offset) < -room) return false;
        }
        return true;
    }

    /** Least and most of x and y on the picture plane and of z. */
    private double[] box(int face) {
        double inf = Double.POSITIVE_INFINITY;
        double[] box = {inf, -inf, inf, -inf, inf, -inf};
        for (int k = 0; k < mesh.cornerCount(face); k++) {
            int v = mesh.corner(face, k);
            double shrink = view.transform().central() ? 1 / view.eyeZ(v) : 1;
            double[] at = {view.eyeX(v) * shrink, view.eyeY(v) * shrink, view.eyeZ(v)};
            for (int axis = 0; axis < 3; axis++) {
                box[2 * axis] = Math.min(box[2 * axis], at[axis]);
                box[2 * axis + 1] = Math.max(box[2 * axis + 1], at[axis]);
            }
        }
        return box;
    }
}
