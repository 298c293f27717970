package rasterlab.engine.visibility;

import rasterlab.engine.transform.PictureFit;

/**
 * One face at a time, clipped at the near, the far and the clip planes, projected to pixels and
 * filled.
 *
 * <p>Each row is filled as {@link RowSpan} says. Corners are rounded to 2⁻²⁴ pixel: an edge that
 * lies on pixel centres then does so exactly, whatever the rounding before.
 */
public final class ScreenPolygon {
    private static final double SUBPIXELS = 1 << 24;

    private final EyePolygon whole;
    private EyePolygon spare;
    private EyePolygon cut;
    private final double[] x;
    private final double[] y;
    private final RowSpan span = new RowSpan();
    private int size;

    /** A polygon for the faces of a view, to whose corners each plane may add one. */
    public ScreenPolygon(ViewedMesh view) {
        this(view.mesh().mostCorners() + 2 + view.clipPlaneCount());
    }

    private ScreenPolygon(int mostCorners) {
        whole = new EyePolygon(mostCorners);
        spare = new EyePolygon(mostCorners);
        cut = new EyePolygon(mostCorners);
        x = new double[mostCorners];
        y = new double[mostCorners];
    }

    /** The polygon with these corners, x and y of each in pixels; convex, and clipped already. */
    public static ScreenPolygon ofPixels(double[] corners) {
        var polygon = new ScreenPolygon(corners.length / 2);
        for (int at = 0; at < corners.length; at += 2) polygon.add(corners[at], corners[at + 1]);
        return polygon;
    }

    public int size() {
        return size;
    }

    /** Pixel coordinate of a corner. */
    public double x(int corner) {
        return x[corner];
    }

    /** Pixel coordinate of a corner. */
    public double y(int corner) {
        return y[corner];
    }

    /** Takes a face; nothing remains of one before the near plane or behind the far one. */
    public void load(ViewedMesh view, int face) {
        load(view, face, view.eyeX, view.eyeY, view.eyeZ);
    }

    /** Loads the same with other eye coordinates than the view's own. */
    public void load(ViewedMesh view, int face, double[] eyeX, double[] eyeY, double[] eyeZ) {
        var mesh = view.mesh();
        whole.size = 0;
        for (int k = 0; k < mesh.cornerCount(face); k++) {
            int v = mesh.corner(face, k);
            whole.add(eyeX[v], eyeY[v], eyeZ[v]);
        }
        load(view);
    }

    private void load(ViewedMesh view) {
        whole.cut(view.near(), 1, spare);
        spare.cut(view.far(), -1, cut);
        for (int plane = 0; plane < view.clipPlaneCount(); plane++) {
            cut.cut(view, plane, spare);
            EyePolygon before = cut;
            cut = spare;
            spare = before;
        }
        size = 0;
        for (int k = 0; k < cut.size; k++) add(view, cut.x[k], cut.y[k], cut.z[k]);
    }

    private void add(ViewedMesh view, double eyeX, double eyeY, double eyeZ) {
        double shrink = view.transform().central() ? view.transform().distance() / eyeZ : 1;
        PictureFit fit = view.fit();
        add(fit.toPixelX(eyeX * shrink), fit.toPixelY(eyeY * shrink));
    }

    private void add(double pixelX, double pixelY) {
        x[size] = Math.rint(pixelX * SUBPIXELS) / SUBPIXELS;
        y[size] = Math.rint(pixelY * SUBPIXELS) / SUBPIXELS;
        size++;
    }

    /** Moves every corner to the nearest pixel centre, a tie to the even one. */
    public void roundToPixels() {
        for (int k = 0; k < size; k++) {
            x[k] = Math.rint(x[k]);
            y[k] = Math.rint(y[k]);
        }
    }

    /**
     * Sends the owned pixels row by row, cut to the picture. A centre on a left edge or a level top
     * edge is owned, one on a right or level bottom edge is not.
     */
    public void fill(int width, int height, SpanSink out) {
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
        span.load(x, y, 0, size, row);
        int from = span.from(0);
        int to = span.to(width);
        if (from < to) out.span(row, from, to);
    }

    /** The part of the polygon between the planes: x, y, z of each corner. */
    public double[] eyeCorners() {
        var corners = new double[3 * cut.size];
        for (int k = 0; k < cut.size; k++) {
            corners[3 * k] = cut.x[k];
            corners[3 * k + 1] = cut.y[k];
            corners[3 * k + 2] = cut.z[k];
        }
        return corners;
    }
}
