package rasterlab.engine.visibility.painter;

import java.util.ArrayList;
import java.util.List;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.visibility.ScreenPolygon;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.order.Cut;
import rasterlab.engine.visibility.order.Sight;

/**
 * Eye space changed so that an eye at the origin sees in it what the view sees, with everything in
 * a narrow cone round z.
 *
 * <p>In perspective x and y shrink: (σx, σy, z). In parallel projection the eye is at infinity, and
 * a projective map brings it to the origin: {@code Z = e/(a − z)}, X = σ·x·Z, Y = σ·y·Z, a − z
 * running from 2e down to e. It keeps planes plane, takes lines of sight to lines through the
 * origin, and Z grows with z, so what hides what is the same; a far eye would only be nearly right.
 */
final class SightSpace {
    /** The widest tangent of the cone. */
    private static final double WIDEST = 0.25;

    private final ViewedMesh view;
    private final boolean central;
    private final int[] faces;
    private final double[][] polygons;
    private double shrink;
    private double extent = 1;
    private double end;

    /** Faces that own no pixel of the picture are left out, others cut at near and far planes. */
    SightSpace(ViewedMesh view) {
        this.view = view;
        central = view.transform().central();
        List<double[]> cut = new ArrayList<>();
        faces = new int[view.mesh().faceCount()];
        var polygon = new ScreenPolygon(view);
        var owned = new boolean[1];
        for (int f = 0; f < faces.length; f++) {
            owned[0] = false;
            polygon.load(view, f);
            polygon.fill(view.fit().width(), view.fit().height(), (y, from, to) -> owned[0] = true);
            if (!owned[0]) continue;
            faces[cut.size()] = f;
            cut.add(polygon.eyeCorners());
        }
        span(cut);
        polygons = cut.stream().map(this::toSight).toArray(double[][]::new);
    }

    private void span(List<double[]> cut) {
        double widest = Double.MIN_NORMAL;
        double least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        for (double[] corners : cut)
            for (int i = 0; i < corners.length; i += 3) {
                double across = Math.max(Math.abs(corners[i]), Math.abs(corners[i + 1]));
                widest = Math.max(widest, central ? across / corners[i + 2] : across);
                least = Math.min(least, corners[i + 2]);
                most = Math.max(most, corners[i + 2]);
            }
        // The scale is a power of two, so that nothing is rounded in perspective.
        shrink = Math.scalb(0.5, Math.getExponent(WIDEST) - Math.getExponent(widest));
        if (most > least) extent = most - least;
        if (most >= least) end = most + extent;
    }

    private double[] toSight(double[] corners) {
        var seen = new double[corners.length];
        for (int i = 0; i < corners.length; i += 3) {
            double z = central ? corners[i + 2] : extent / (end - corners[i + 2]);
            double across = central ? shrink : shrink * z;
            seen[i] = across * corners[i];
            seen[i + 1] = across * corners[i + 1];
            seen[i + 2] = z;
        }
        return seen;
    }

    /** The polygons and the eye at the origin. */
    Sight sight() {
        return new Sight(polygons, new double[3]);
    }

    /** The face that a polygon of {@link #sight} is of. */
    int face(int polygon) {
        return faces[polygon];
    }

    /** Where the picture shows corners of a polygon of {@link #sight}: x and y of each. */
    double[] toPixels(double[] corners) {
        PictureFit fit = view.fit();
        double across = central ? shrink / view.transform().distance() : shrink;
        var pixels = new double[corners.length / 3 * 2];
        for (int k = 0; 3 * k < corners.length; k++) {
            double scale = 1 / (across * corners[3 * k + 2]);
            pixels[2 * k] = fit.toPixelX(corners[3 * k] * scale);
            pixels[2 * k + 1] = fit.toPixelY(corners[3 * k + 1] * scale);
        }
        return pixels;
    }

    /**
     * A cut as a line on the picture: pixel (x, y) is seen along (σX/ρ, σY/ρ, 1) or (σX, σY, 1).
     */
    CutLine line(Cut cut) {
        PictureFit fit = view.fit();
        double across = central ? shrink / view.transform().distance() : shrink;
        double perX = across * cut.x();
        double perY = across * cut.y();
        return new CutLine(
                cut.z() + perX * fit.toPlaneX(0) + perY * fit.toPlaneY(0),
                perX / fit.pixelsPerUnit(),
                -perY / fit.pixelsPerUnit(),
                cut.near());
    }
}
