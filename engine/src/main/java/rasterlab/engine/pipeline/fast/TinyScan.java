package rasterlab.engine.pipeline.fast;

/**
 * The centres of pixels that a small triangle owns, found by asking each in its box.
 *
 * <p>The edge functions and the rule are those of {@link TriangleScan}. In a box of {@value #SIDE}
 * pixels they stay below 2²³, and within {@value #SIDE} columns from its left below 2²⁴: they fit
 * an int, and a float holds them exactly. A centre is written whether it is owned or not, and
 * counted only if it is: no branch, which nobody could foresee.
 */
final class TinyScan extends Scan {
    /** The widest and highest box, in pixels. */
    static final int SIDE = 8;

    /**
     * A box with so many pixels or less has few: no more than five, so that three columns have one
     * row.
     */
    static final int FEW = 4;

    /** The most centres in a box. */
    static final int MOST = SIDE * SIDE;

    /** The longest side of what is small, in steps. */
    static final int WIDEST = SIDE * Subpixels.ONE - 1;

    /** The box: the cell of its first pixel, its first column, its sides in pixels. */
    int at;

    int left;

    int columns;
    int rows;

    /** eA, eB and eC at the box's first pixel; eA is 1 less where its edge owns no centre. */
    int rowA;

    int rowB;
    int rowC;

    /** The growth of eA to the right and down. */
    int stepA;

    int downA;

    /** 0 where the edge owns the centres on it, else −1. */
    int ownB;

    int ownC;

    /** Pixels that are owned: their cells, eB and eC. */
    int count;

    final int[] cell = new int[MOST + 1];
    final int[] edgeB = new int[MOST + 1];
    final int[] edgeC = new int[MOST + 1];

    /** Finds the box. Returns false, and does nothing, where the triangle is too large. */
    boolean load(ScreenVertices v, int first, int second, int third, Band band) {
        int ax = v.x(first);
        int ay = v.y(first);
        int bx = v.x(second) - ax;
        int by = v.y(second) - ay;
        int cx = v.x(third) - ax;
        int cy = v.y(third) - ay;
        int minX = Math.min(0, Math.min(bx, cx));
        int maxX = Math.max(0, Math.max(bx, cx));
        int minY = Math.min(0, Math.min(by, cy));
        int maxY = Math.max(0, Math.max(by, cy));
        if (maxX - minX > WIDEST || maxY - minY > WIDEST) return false;
        left = Math.max(0, Subpixels.firstPixel(ax + minX));
        columns = Math.min(band.width, Subpixels.endPixel(ax + maxX)) - left;
        int highest = Subpixels.firstPixel(ay + minY);
        int lowest = Subpixels.endPixel(ay + maxY);
        int top = Math.max(band.top, highest);
        rows = Math.min(band.bottom(), lowest) - top;
        int area = bx * cy - by * cx;
        fromBehind = area > 0;
        inverseArea = 1f / Math.abs(area);
        a = first;
        int px = (left << Subpixels.BITS) - ax;
        int py = (top << Subpixels.BITS) - ay;
        at = top * band.width + left;
        if (area > 0) {
            b = second;
            c = third;
            edges(bx, by, cx, cy, px, py);
        } else {
            b = third;
            c = second;
            edges(cx, cy, bx, by, px, py);
        }
        return true;
    }

    /** b, c and the first centre p are seen from a. */
    private void edges(int bx, int by, int cx, int cy, int px, int py) {
        stepA = by - cy << Subpixels.BITS;
        stepB = cy << Subpixels.BITS;
        stepC = -by << Subpixels.BITS;
        downA = cx - bx << Subpixels.BITS;
        downB = -cx << Subpixels.BITS;
        downC = bx << Subpixels.BITS;
        ownB = TriangleScan.owned(-cx, -cy);
        ownC = TriangleScan.owned(bx, by);
        rowA = (cx - bx) * (py - by) - (cy - by) * (px - bx) + TriangleScan.owned(cx - bx, cy - by);
        rowB = cy * (px - cx) - cx * (py - cy);
        rowC = bx * py - by * px;
    }

    /**
     * Finds the pixels of the box that are owned.
     *
     * @param width of the picture
     */
    void look(int width) {
        int[] cells = cell;
        int[] edgesB = edgeB;
        int[] edgesC = edgeC;
        int rightA = stepA;
        int rightB = (int) stepB;
        int rightC = (int) stepC;
        int found = 0;
        for (int y = 0; y < rows; y++) {
            int first = at + y * width;
            int eA = rowA + y * downA;
            int eB = rowB + y * (int) downB;
            int eC = rowC + y * (int) downC;
            for (int x = 0; x < columns; x++) {
                cells[found] = first + x;
                edgesB[found] = eB;
                edgesC[found] = eC;
                found += ~(eA | eB + ownB | eC + ownC) >>> 31;
                eA += rightA;
                eB += rightB;
                eC += rightC;
            }
        }
        count = found;
    }
}
