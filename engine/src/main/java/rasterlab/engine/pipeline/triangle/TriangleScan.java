package rasterlab.engine.pipeline.triangle;

/**
 * The pixels of one triangle within one band, row by row, exactly.
 *
 * <p>With corners a, b, c so turned that {@code area = (b − a)×(c − a) > 0} (y down), the edge
 * function {@code eA(p) = (c − b)×(p − b)}, and likewise eB and eC, is positive inside and {@code
 * eA + eB + eC = area}: e/area are p's weights of the corners. A centre on an edge is owned where
 * the edge is a left one or a level top one, so triangles that share an edge own each pixel once.
 * All is whole numbers below 2⁵² (see {@link Subpixels}): a sliver is as exact as any other.
 *
 * <p>Source: J. Pineda, A parallel algorithm for polygon rasterization, 1988.
 */
final class TriangleScan {
    /** Rows of a band. */
    static final int ROWS = 32;

    /** Boxes up to this many pixels wide are searched from the left. */
    private static final int NARROW = 8;

    /** The corners' numbers, so turned that the area is positive. */
    int a;

    int b;
    int c;

    /** 1 / area. */
    float inverseArea;

    /** What eB and eC grow by from a pixel to the next on its right. */
    long stepB;

    long stepC;

    /** The first row and the number of rows. */
    int top;

    int rows;

    /** For each row: the first pixel, the number of pixels, eB and eC at the first. */
    final int[] left = new int[ROWS];

    final int[] count = new int[ROWS];
    final long[] edgeB = new long[ROWS];
    final long[] edgeC = new long[ROWS];

    private int boxLeft;
    private int boxRight;
    private long stepA;
    private long rowA;
    private long rowB;
    private long rowC;
    private int ownA;
    private int ownB;
    private int ownC;

    /**
     * @param bandTop first row of the band
     * @param bandBottom row after its last
     */
    void load(ScreenVertices v, int first, int second, int third, DepthRaster out, int bandTop) {
        int bandBottom = Math.min(bandTop + ROWS, out.height());
        int ax = v.x[first];
        int ay = v.y[first];
        long area = cross(v.x[second] - ax, v.y[second] - ay, v.x[third] - ax, v.y[third] - ay);
        a = first;
        b = area > 0 ? second : third;
        c = area > 0 ? third : second;
        inverseArea = 1f / Math.abs(area);
        int bx = v.x[b];
        int by = v.y[b];
        int cx = v.x[c];
        int cy = v.y[c];
        boxLeft = Math.max(0, Subpixels.firstPixel(Math.min(ax, Math.min(bx, cx))));
        boxRight = Math.min(out.width(), Subpixels.endPixel(Math.max(ax, Math.max(bx, cx))));
        top = Math.max(bandTop, Subpixels.firstPixel(Math.min(ay, Math.min(by, cy))));
        rows = Math.min(bandBottom, Subpixels.endPixel(Math.max(ay, Math.max(by, cy)))) - top;
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
        scan((long) (cx - bx) << 8, (long) (ax - cx) << 8, (long) (bx - ax) << 8);
    }

    private static long cross(int ax, int ay, int bx, int by) {
        return (long) ax * by - (long) ay * bx;
    }

    /** 0 where centres on the edge are owned, else −1: then e must be at least 1. */
    private static int owned(int dx, int dy) {
        return dy < 0 || dy == 0 && dx > 0 ? 0 : -1;
    }

    private void scan(long downA, long downB, long downC) {
        if (boxRight - boxLeft <= NARROW) scanNarrow(downA, downB, downC);
        else scanWide(downA, downB, downC);
    }

    private void scanNarrow(long downA, long downB, long downC) {
        long lineA = rowA;
        long lineB = rowB;
        long lineC = rowC;
        for (int row = 0; row < rows; row++) {
            long eA = lineA;
            long eB = lineB;
            long eC = lineC;
            int x = boxLeft;
            while (x < boxRight && (eA | eB | eC) < 0) {
                eA += stepA;
                eB += stepB;
                eC += stepC;
                x++;
            }
            left[row] = x;
            edgeB[row] = eB - ownB;
            edgeC[row] = eC - ownC;
            int end = x;
            while (end < boxRight && (eA | eB | eC) >= 0) {
                eA += stepA;
                eB += stepB;
                eC += stepC;
                end++;
            }
            count[row] = end - x;
            lineA += downA;
            lineB += downB;
            lineC += downC;
        }
    }

    private void scanWide(long downA, long downB, long downC) {
        double perA = 1.0 / stepA;
        double perB = 1.0 / stepB;
        double perC = 1.0 / stepC;
        int width = boxRight - boxLeft;
        for (int row = 0; row < rows; row++) {
            long eA = rowA + row * downA;
            long eB = rowB + row * downB;
            long eC = rowC + row * downC;
            int from = Math.max(first(eA, stepA, perA), first(eB, stepB, perB));
            from = Math.max(0, Math.max(from, first(eC, stepC, perC)));
            int to = Math.min(end(eA, stepA, perA, width), end(eB, stepB, perB, width));
            to = Math.min(to, end(eC, stepC, perC, width));
            left[row] = boxLeft + from;
            count[row] = Math.max(0, to - from);
            edgeB[row] = eB - ownB + from * stepB;
            edgeC[row] = eC - ownC + from * stepC;
        }
    }

    /**
     * The first k ≥ 0 with e + k·step ≥ 0 on an edge that is entered; the quotient in doubles is
     * off by less than one, and the whole numbers set it right.
     */
    private static int first(long e, long step, double perStep) {
        if (step <= 0 || e >= 0) return 0;
        int k = (int) Math.min(Math.ceil(-e * perStep), Integer.MAX_VALUE / 2);
        if (e + k * step < 0) return k + 1;
        return e + (k - 1) * step >= 0 ? k - 1 : k;
    }

    /** The first k in [0, width] with e + k·step &lt; 0 on an edge that is left. */
    private static int end(long e, long step, double perStep, int width) {
        if (e < 0 && step <= 0) return 0;
        if (step >= 0) return width;
        if (e + (width - 1) * step >= 0) return width;
        int k = (int) (-e * perStep) + 1;
        if (e + k * step >= 0) return k + 1;
        return e + (k - 1) * step < 0 ? k - 1 : k;
    }
}
