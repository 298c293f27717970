package rasterlab.app.opengl.software;

import java.util.Arrays;
import org.joml.Matrix4d;

/**
 * Lines and points one pixel wide as triangles, so that the triangles' pipeline draws them.
 *
 * <p>A line that is wider than high has in each column the pixel whose centre is nearest, so it is
 * a parallelogram one pixel high with upright ends, and a higher one likewise; a point is a square.
 * Source: M. Segal, K. Akeley, The OpenGL Graphics System: A Specification, version 2.1, 2006,
 * sections 3.3 and 3.4.
 */
final class Strokes {
    /**
     * Half a step of the raster, in pixels: a point between two columns belongs to the right one.
     */
    private static final double TIE = 1.0 / 512;

    private final Matrix4d projection;
    private final double perPixelX;
    private final double perPixelY;
    private final double halfWidth;
    private final double halfHeight;
    private final TriangleCorners out;

    Strokes(Matrix4d projection, int width, int height, TriangleCorners out) {
        this.projection = projection;
        this.out = out;
        halfWidth = width / 2.0;
        halfHeight = height / 2.0;
        perPixelX = 1 / (halfWidth * projection.m00());
        perPixelY = 1 / (halfHeight * projection.m11());
    }

    /**
     * @param a {@value TriangleCorners#NUMBERS} numbers, before the near plane, as b
     */
    void line(double[] a, double[] b) {
        double dx = pixelX(b) - pixelX(a);
        double dy = pixelY(b) - pixelY(a);
        boolean across = Math.abs(dx) >= Math.abs(dy);
        double[] from = end(a, a, b, across);
        double[] to = end(b, a, b, across);
        double[] first = inRange(from);
        double[] last = inRange(to);
        if (Arrays.equals(first, from)) band(from, last, across);
        else {
            band(first, a, across);
            band(a, last, across);
        }
    }

    /** Fills the parallelogram about a to b. */
    private void band(double[] a, double[] b, boolean across) {
        double aside = across ? 0 : 0.5;
        double up = across ? 0.5 : 0;
        double tie = across && betweenRows(a) && betweenRows(b) ? -2 * TIE : 0;
        double[] a0 = moved(a, -aside, tie - up);
        double[] a1 = moved(a, aside, tie + up);
        double[] b0 = moved(b, -aside, tie - up);
        double[] b1 = moved(b, aside, tie + up);
        triangle(a0, b0, b1);
        triangle(a0, b1, a1);
    }

    /** Whether it lies where two rows of pixels meet, as the raster has it: the lower one's. */
    private boolean betweenRows(double[] corner) {
        double y = halfHeight + pixelY(corner);
        return Math.abs(y - Math.rint(y)) < TIE;
    }

    /** The corner with colours from 0 to 1, which they may leave where an end moved outwards. */
    private static double[] inRange(double[] corner) {
        double[] limited = corner.clone();
        for (int k = TriangleCorners.RED; k <= TriangleCorners.ALPHA; k++)
            limited[k] = Math.max(0, Math.min(1, limited[k]));
        return limited;
    }

    /**
     * An end of the line from a to b as the parallelogram has it. A line has the pixels whose
     * diamond |x| + |y| &lt; ½ about the middle it leaves: where an end is in a diamond and past
     * its middle, the first pixel is left and the last one is not, so both ends go back to the
     * pixel's border.
     */
    private double[] end(double[] end, double[] a, double[] b, boolean across) {
        double x = halfWidth + pixelX(end);
        double y = halfHeight + pixelY(end);
        double right = x - Math.floor(x) - 0.5;
        double up = y - Math.floor(y) - 0.5;
        if (Math.abs(right) + Math.abs(up) >= 0.5) return end;
        double along = across ? right : up;
        boolean grows = across ? pixelX(b) > pixelX(a) : pixelY(b) > pixelY(a);
        if (!past(along, across, grows)) return end;
        double back = grows ? -along - 0.5 : 0.5 - along;
        return across
                ? at((pixelX(end) + back) / (halfWidth * projection.m00()), 0, a, b)
                : at((pixelY(end) + back) / (halfHeight * projection.m11()), 1, a, b);
    }

    /**
     * Whether a place is past an edge as the raster decides it: the left and the upper edge belong
     * to what they bound.
     */
    private static boolean past(double along, boolean across, boolean grows) {
        long steps = Math.round(along / (2 * TIE));
        boolean beyond = across ? steps > 0 : steps >= 0;
        return beyond == grows;
    }

    /** Where x or y over w has that value, on the line through a and b. */
    private double[] at(double value, int coordinate, double[] a, double[] b) {
        double t =
                (value * w(a) - a[coordinate])
                        / (b[coordinate] - a[coordinate] - value * (w(b) - w(a)));
        double[] point = new double[TriangleCorners.NUMBERS];
        for (int k = 0; k < point.length; k++) point[k] = a[k] + t * (b[k] - a[k]);
        return point;
    }

    void point(double[] a) {
        double[] low = moved(a, TIE - 0.5, -0.5);
        double[] high = moved(a, TIE + 0.5, 0.5);
        triangle(low, moved(a, TIE + 0.5, -0.5), high);
        triangle(low, high, moved(a, TIE - 0.5, 0.5));
    }

    private void triangle(double[] a, double[] b, double[] c) {
        out.add(a);
        out.add(b);
        out.add(c);
    }

    private double w(double[] corner) {
        return projection.m23() * corner[2] + projection.m33();
    }

    private double pixelX(double[] corner) {
        return halfWidth * projection.m00() * corner[0] / w(corner);
    }

    private double pixelY(double[] corner) {
        return halfHeight * projection.m11() * corner[1] / w(corner);
    }

    /** The corner moved by pixels to the right and up, at the same depth. */
    private double[] moved(double[] corner, double right, double up) {
        double[] moved = corner.clone();
        moved[0] += right * perPixelX * w(corner);
        moved[1] += up * perPixelY * w(corner);
        return moved;
    }
}
