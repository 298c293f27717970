package rasterlab.engine.visibility;

import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;

/**
 * One face at a time, clipped at the near plane, projected to pixels and filled.
 *
 * <p>A new edge point of the clip is computed from the visible end to the hidden one, and a row's
 * crossing with an edge from its upper end to its lower one, so two faces that share an edge get
 * bit-equal numbers and own each pixel once. Corners are rounded to 1/65536 pixel: an edge that
 * lies on pixel centres then does so exactly, whatever the rounding before.
 */
final class ScreenPolygon {
    private static final double SUBPIXELS = 65536;

    private final double[] x;
    private final double[] y;
    private int size;

    /**
     * @param mostCorners the most corners of a face; the near plane may add one
     */
    ScreenPolygon(int mostCorners) {
        x = new double[mostCorners + 1];
        y = new double[mostCorners + 1];
    }

    int size() {
        return size;
    }

    /** Pixel coordinate of a corner. */
    double x(int corner) {
        return x[corner];
    }

    /** Pixel coordinate of a corner. */
    double y(int corner) {
        return y[corner];
    }

    /** Takes a face; nothing remains of one that is nearer than the near plane. */
    void load(ViewedMesh view, int face) {
        load(view, face, view.eyeX, view.eyeY, view.eyeZ);
    }

    /** The same with other eye coordinates than the view's own. */
    void load(ViewedMesh view, int face, double[] eyeX, double[] eyeY, double[] eyeZ) {
        var mesh = view.mesh();
        double near = view.near();
        size = 0;
        int n = mesh.cornerCount(face);
        int a = mesh.corner(face, n - 1);
        for (int k = 0; k < n; k++) {
            int b = mesh.corner(face, k);
            boolean aIn = eyeZ[a] >= near;
            boolean bIn = eyeZ[b] >= near;
            if (aIn != bIn) {
                int in = aIn ? a : b;
                int out = aIn ? b : a;
                double t = (eyeZ[in] - near) / (eyeZ[in] - eyeZ[out]);
                add(
                        view,
                        eyeX[in] + t * (eyeX[out] - eyeX[in]),
                        eyeY[in] + t * (eyeY[out] - eyeY[in]),
                        near);
            }
            if (bIn) add(view, eyeX[b], eyeY[b], eyeZ[b]);
            a = b;
        }
    }

    private void add(ViewedMesh view, double eyeX, double eyeY, double eyeZ) {
        double shrink =
                view.projection() == Projection.PERSPECTIVE ? view.camera().rho() / eyeZ : 1;
        PictureFit fit = view.fit();
        x[size] = Math.rint(fit.toPixelX(eyeX * shrink) * SUBPIXELS) / SUBPIXELS;
        y[size] = Math.rint(fit.toPixelY(eyeY * shrink) * SUBPIXELS) / SUBPIXELS;
        size++;
    }

    /** Moves every corner to the nearest pixel centre, a tie to the even one. */
    void roundToPixels() {
        for (int k = 0; k < size; k++) {
            x[k] = Math.rint(x[k]);
            y[k] = Math.rint(y[k]);
        }
    }

    /**
     * Sends the owned pixels row by row, cut to the picture. A centre on a left edge or a level top
     * edge is owned, one on a right or level bottom edge is not.
     */
    void fill(int width, int height, SpanSink out) {
        double top = Double.POSITIVE_INFINITY;
        double bottom = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < size; k++) {
            top = Math.min(top, y[k]);
            bottom = Math.max(bottom, y[k]);
        }
        int first = (int) Math.max(0, Math.ceil(top));
        int end = (int) Math.min(height, Math.ceil(bottom));
        for (int row = first; row < end; row++) fillRow(row, width, out);
    }

    private void fillRow(int row, int width, SpanSink out) {
        double left = Double.POSITIVE_INFINITY;
        double right = Double.NEGATIVE_INFINITY;
        for (int k = 0, p = size - 1; k < size; p = k++) {
            int upper = y[p] < y[k] ? p : k;
            int lower = upper == p ? k : p;
            if (row < y[upper] || row >= y[lower]) continue;
            double slope = (x[lower] - x[upper]) / (y[lower] - y[upper]);
            double crossing = x[upper] + (row - y[upper]) * slope;
            left = Math.min(left, crossing);
            right = Math.max(right, crossing);
        }
        int from = (int) Math.max(0, Math.ceil(left));
        int to = (int) Math.min(width, Math.ceil(right));
        if (from < to) out.span(row, from, to);
    }
}
