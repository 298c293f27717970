package rasterlab.engine.pipeline.wire;

import rasterlab.engine.scene.Mesh;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * Which points of an edge are seen, by the face that the picture shows in each pixel.
 *
 * <p>A point is hidden where it lies behind the plane of the face in its pixel, if it lies within
 * that face too. Beside the face, at most a pixel off, the plane says nothing: there the faces in
 * the eight pixels about are asked, and if none of them holds the point it is hidden where all that
 * is shown there is nearer.
 */
final class EdgeSight {
    /** How far behind a plane an edge still counts as in it, as a share of its nearness. */
    private static final double IN_PLANE = 1e-6;

    private final ViewedMesh view;
    private final PictureFit fit;
    private final int[] faces;

    /**
     * @param faces the number of the face in each pixel, plus 1, or {@link FaceNumbers#BACKGROUND}
     */
    EdgeSight(ViewedMesh view, int[] faces) {
        this.view = view;
        fit = view.fit();
        this.faces = faces;
    }

    /**
     * Whether a point is seen.
     *
     * @param pixelX within half a pixel of the picture's pixels, as {@code pixelY} is
     * @param nearness as {@link ScreenEdge} has it
     */
    boolean sees(double pixelX, double pixelY, double nearness) {
        int x = (int) Math.rint(pixelX);
        int y = (int) Math.rint(pixelY);
        int shown = faces[y * fit.width() + x];
        if (shown == FaceNumbers.BACKGROUND) return true;
        if (!behind(nearness, planeNearness(shown - 1, pixelX, pixelY))) return true;
        return !hides(shown - 1, pixelX, pixelY, nearness)
                && reachesOut(x, y, pixelX, pixelY, nearness);
    }

    private boolean hides(int face, double pixelX, double pixelY, double nearness) {
        return holds(face, pixelX, pixelY) && behind(nearness, planeNearness(face, pixelX, pixelY));
    }

    private static boolean behind(double nearness, double plane) {
        return nearness < plane - IN_PLANE * Math.abs(plane);
    }

    /** Whether none of the faces about the pixel hides a point, nor all of them by their depths. */
    private boolean reachesOut(
            int pixelX, int pixelY, double pointX, double pointY, double nearness) {
        boolean out = false;
        for (int y = Math.max(0, pixelY - 1); y <= Math.min(fit.height() - 1, pixelY + 1); y++)
            for (int x = Math.max(0, pixelX - 1); x <= Math.min(fit.width() - 1, pixelX + 1); x++) {
                int shown = faces[y * fit.width() + x];
                boolean empty = shown == FaceNumbers.BACKGROUND;
                if (!empty && hides(shown - 1, pointX, pointY, nearness)) return false;
                out |= empty || !behind(nearness, planeNearness(shown - 1, x, y));
            }
        return out;
    }

    /**
     * The nearness by the plane n·p = k, as depth buffers have it; not finite for a face seen
     * edge-on.
     */
    private double planeNearness(int face, double pixelX, double pixelY) {
        double across =
                view.eyeNormal(face, 0) * fit.toPlaneX(pixelX)
                        + view.eyeNormal(face, 1) * fit.toPlaneY(pixelY);
        double nz = view.eyeNormal(face, 2);
        double k = view.planeOffset(face);
        return view.transform().central()
                ? (across + nz * view.transform().distance()) / k
                : (across - k) / nz;
    }

    /** Whether the line of sight through a point of the picture passes through the face. */
    private boolean holds(int face, double pixelX, double pixelY) {
        double planeX = fit.toPlaneX(pixelX);
        double planeY = fit.toPlaneY(pixelY);
        Mesh mesh = view.mesh();
        boolean left = false;
        boolean right = false;
        for (int k = 0, last = mesh.cornerCount(face) - 1; k < mesh.cornerCount(face); last = k++) {
            double side = side(mesh.corner(face, last), mesh.corner(face, k), planeX, planeY);
            left |= side > 0;
            right |= side < 0;
        }
        return left != right;
    }

    /** The side of an edge on which the line of sight passes: the sign of a triple product. */
    private double side(int a, int b, double planeX, double planeY) {
        double ax = view.eyeX(a);
        double ay = view.eyeY(a);
        double bx = view.eyeX(b);
        double by = view.eyeY(b);
        if (!view.transform().central())
            return (bx - ax) * (planeY - ay) - (by - ay) * (planeX - ax);
        double az = view.eyeZ(a);
        double bz = view.eyeZ(b);
        return (ay * bz - az * by) * planeX
                + (az * bx - ax * bz) * planeY
                + (ax * by - ay * bx) * view.transform().distance();
    }
}
