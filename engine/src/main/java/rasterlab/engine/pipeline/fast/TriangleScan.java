package rasterlab.engine.pipeline.fast;

/**
 * The pixels of one triangle within one band, row by row, exactly.
 *
 * <p>With corners a, b, c so turned that {@code area = (b − a)×(c − a) > 0} (y down), the edge
 * function {@code eA(p) = (c − b)×(p − b)}, and likewise eB and eC, is positive inside and {@code
 * eA + eB + eC = area}: e/area are p's weights of the corners. A centre on an edge is owned where
 * the edge is a left one or a level top one, so triangles that share an edge own each pixel once.
 * All is whole numbers below 2⁵² (see {@link Subpixels}): a sliver is as exact as any other.
 *
 * <p>Source: J. Pineda, A parallel algorithm for polygon rasterization, SIGGRAPH 1988, pp. 17–20.
 */
final class TriangleScan extends Scan {
    /** A row's band is its number without so many lowest bits. */
    static final int ROW_BITS = 5;

    /** Rows of a band. */
    static final int ROWS = 1 << ROW_BITS;

    /** The first row and the number of rows. */
    int top;

    int rows;

    /** The first pixel of each row, the number of its pixels, eB and eC at the first. */
    final int[] left = new int[ROWS];

    final int[] count = new int[ROWS];
    final double[] edgeB = new double[ROWS];
    final double[] edgeC = new double[ROWS];

    private int pictureWidth;

    /** The box: its first column and the column after its last. */
    int boxLeft;

    int boxRight;

    /** The growth of eA to the right and down. */
    long stepA;

    long downA;

    /** eA, eB and eC at the box's first pixel, each with what follows added. */
    long rowA;

    long rowB;
    long rowC;

    /** 0 where the edge owns the centres on it, else −1. */
    private int ownA;

    int ownB;
    int ownC;

    /** Finds the box; {@link #scan} has to find the pixels. */
    void load(ScreenVertices v, int first, int second, int third, Band band) {
        pictureWidth = band.width;
        int ax = v.x(first);
        int ay = v.y(first);
        long area = cross(v.x(second) - ax, v.y(second) - ay, v.x(third) - ax, v.y(third) - ay);
        a = first;
        b = area > 0 ? second : third;
        c = area > 0 ? third : second;
        fromBehind = area > 0;
        inverseArea = 1f / Math.abs(area);
        int bx = v.x(b);
        int by = v.y(b);
        int cx = v.x(c);
        int cy = v.y(c);
        boxLeft = Math.max(0, Subpixels.firstPixel(Math.min(ax, Math.min(bx, cx))));
        boxRight = Math.min(pictureWidth, Subpixels.endPixel(Math.max(ax, Math.max(bx, cx))));
        top = Math.max(band.top, Subpixels.firstPixel(Math.min(ay, Math.min(by, cy))));
        rows = Math.min(band.bottom(), Subpixels.endPixel(Math.max(ay, Math.max(by, cy)))) - top;
        stepA = (long) (by - cy) << Subpixels.BITS;
        stepB = (long) (cy - ay) << Subpixels.BITS;
        stepC = (long) (ay - by) << Subpixels.BITS;
        ownA = owned(cx - bx, cy - by);
        ownB = owned(ax - cx, ay - cy);
        ownC = owned(bx - ax, by - ay);
        int px = boxLeft << Subpixels.BITS;
        int py = top << Subpixels.BITS;
        rowA = cross(cx - bx, cy - by, px - bx, py - by) + ownA;
        rowB = cross(ax - cx, ay - cy, px - cx, py - cy) + ownB;
        rowC = cross(bx - ax, by - ay, px - ax, py - ay) + ownC;
        downB = (long) (ax - cx) << Subpixels.BITS;
        downC = (long) (bx - ax) << Subpixels.BITS;
        downA = (long) (cx - bx) << Subpixels.BITS;
    }

    /** eB at the box's first pixel. */
    long cornerB() {
        return rowB - ownB;
    }

    /** eC there. */
    long cornerC() {
        return rowC - ownC;
    }

    /** The cell of a row's first pixel. */
    int cell(int row) {
        return (top + row) * pictureWidth + left[row];
    }

    private static long cross(int ax, int ay, int bx, int by) {
        return (long) ax * by - (long) ay * bx;
    }

    /**
     * 0 where centres on the edge are owned, dy < 0 or dy = 0 and dx > 0; else −1: then e must be
     * at least 1.
     */
    static int owned(int dx, int dy) {
        return ~(2 * dy - (-dx >>> 31) >> 31);
    }

    /**
     * Finds each row's pixels: those that no edge excludes. An edge's function is 0 at {@code k =
     * −e/step} pixels from the box's left; half a unit is added to e, a whole number, so that k is
     * never whole: it is at least 2⁻³⁴ from a whole number and, within a picture, right to 2⁻³⁹, so
     * the quotient by way of a reciprocal is rounded to the right side. Where e grows to the right
     * the pixels begin at k, where it falls they end there; a level edge has step 0 and k = ±∞.
     */
    void scan() {
        double perA = -1.0 / stepA;
        double perB = -1.0 / stepB;
        double perC = -1.0 / stepC;
        // The mask is all ones where the pixels begin at the edge, 0 where they end there.
        int beginA = ~(int) (stepA >> 63);
        int beginB = ~(int) (stepB >> 63);
        int beginC = ~(int) (stepC >> 63);
        int width = boxRight - boxLeft;
        for (int row = 0; row < rows; row++) {
            long eA = rowA + row * downA;
            long eB = rowB + row * downB;
            long eC = rowC + row * downC;
            int kA = (int) Math.ceil((eA + 0.5) * perA);
            int kB = (int) Math.ceil((eB + 0.5) * perB);
            int kC = (int) Math.ceil((eC + 0.5) * perC);
            int from = Math.max(Math.max(0, kA & beginA), Math.max(kB & beginB, kC & beginC));
            int to =
                    Math.min(
                            Math.min(width, end(kA, beginA)),
                            Math.min(end(kB, beginB), end(kC, beginC)));
            // k may be anything up to ±2³¹ where the row or the triangle is out of the box.
            from = Math.min(from, width);
            left[row] = boxLeft + from;
            count[row] = Math.max(from, to) - from;
            edgeB[row] = eB - ownB + from * stepB;
            edgeC[row] = eC - ownC + from * stepC;
        }
    }

    /** k at an edge where pixels end, else the largest number. */
    private static int end(int k, int begin) {
        return k & ~begin | Integer.MAX_VALUE & begin;
    }
}
