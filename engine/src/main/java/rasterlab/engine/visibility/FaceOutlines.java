package rasterlab.engine.visibility;

import java.util.Optional;
import rasterlab.engine.transform.PictureFit;

/** Where faces and their cuts lie on the picture, to show what a step was about. */
public final class FaceOutlines {
    private FaceOutlines() {}

    /**
     * The corners of what is drawn of a face, in pixels: x and y of each; empty where nothing lies
     * between the near and the far plane.
     */
    public static double[] corners(ViewedMesh view, int face) {
        var polygon = new ScreenPolygon(view);
        polygon.load(view, face);
        var corners = new double[2 * polygon.size()];
        for (int k = 0; k < polygon.size(); k++) {
            corners[2 * k] = polygon.x(k);
            corners[2 * k + 1] = polygon.y(k);
        }
        return corners;
    }

    /**
     * The line in which another face's plane cuts a face, from edge to edge of it: x and y of both
     * ends, in pixels; empty where the plane passes it by.
     */
    public static Optional<double[]> cut(ViewedMesh view, int face, int by) {
        var polygon = new ScreenPolygon(view);
        polygon.load(view, face);
        double[] eye = polygon.eyeCorners();
        var ends = new double[4];
        int found = 0;
        for (int at = 0; at < eye.length && found < 2; at += 3) {
            int next = (at + 3) % eye.length;
            double here = above(view, by, eye, at);
            double there = above(view, by, eye, next);
            if (here > 0 == there > 0) continue;
            project(view, eye, at, next, here / (here - there), ends, 2 * found++);
        }
        return found == 2 ? Optional.of(ends) : Optional.empty();
    }

    /** Distance of a corner in eye space from a face's plane, above 0 on its outer side. */
    private static double above(ViewedMesh view, int face, double[] eye, int at) {
        return view.eyeNormal(face, 0) * eye[at]
                + view.eyeNormal(face, 1) * eye[at + 1]
                + view.eyeNormal(face, 2) * eye[at + 2]
                - view.planeOffset(face);
    }

    /** Projects the point that lies a share of the way from one corner to the other. */
    private static void project(
            ViewedMesh view, double[] eye, int from, int to, double share, double[] pixel, int at) {
        double z = eye[from + 2] + share * (eye[to + 2] - eye[from + 2]);
        double shrink = view.transform().central() ? view.transform().distance() / z : 1;
        PictureFit fit = view.fit();
        pixel[at] = fit.toPixelX((eye[from] + share * (eye[to] - eye[from])) * shrink);
        pixel[at + 1] =
                fit.toPixelY((eye[from + 1] + share * (eye[to + 1] - eye[from + 1])) * shrink);
    }
}
