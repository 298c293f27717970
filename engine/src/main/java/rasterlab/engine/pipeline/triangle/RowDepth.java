package rasterlab.engine.pipeline.triangle;

/**
 * The depth of one triangle along its rows, the same bit for bit whatever its surface, so that what
 * is drawn twice is seen once.
 *
 * <p>A compact triangle's depth is counted from the corner of its box. Elsewhere each row has its
 * own beginning, since beside a sliver the function is as large as it is steep. One per thread.
 */
final class RowDepth {
    /** The widest box, in pixels, from whose corner all may be counted. */
    static final int WIDEST = 32;

    /** By how much weights may change within such a box: depths there keep 20 of 24 bits. */
    private static final int STEEPEST = 16;

    /** Up to this area no edge function there, {@link #STEEPEST} + 1 areas at most, is 2³¹. */
    private static final double LARGEST = 0x1p26;

    /** At corner a, and what the weights of b and c add. */
    double za;

    double zb;
    double zc;

    /** What the depth grows by from a pixel to the next on its right. */
    float stepZ;

    boolean compact;

    /** At the corner of a compact triangle's box, and what it grows by from a row to the next. */
    double cornerZ;

    double downZ;

    /** Depth where {@link #at} counts pixels from, and the place of the row's first one. */
    float z;

    int first;

    void load(TriangleScan scan, ScreenVertices v) {
        za = v.depth(scan.a);
        zb = v.depth(scan.b) - za;
        zc = v.depth(scan.c) - za;
        double inverseArea = scan.inverseArea;
        double toB = scan.stepB * inverseArea;
        double toC = scan.stepC * inverseArea;
        double downB = scan.downB * inverseArea;
        double downC = scan.downC * inverseArea;
        stepZ = (float) (toB * zb + toC * zc);
        int columns = columns(scan);
        double across = (Math.abs(toB) + Math.abs(toC)) * columns;
        double along = (Math.abs(downB) + Math.abs(downC)) * scan.rows;
        compact = columns <= WIDEST && across + along <= STEEPEST && inverseArea >= 1 / LARGEST;
        cornerZ = scan.cornerB() * inverseArea * zb + za + scan.cornerC() * inverseArea * zc;
        downZ = downB * zb + downC * zc;
    }

    /** How many columns are looked at, eight at a time: they may go beyond the box. */
    static int columns(TriangleScan scan) {
        return scan.boxRight - scan.boxLeft + 7 & ~7;
    }

    /** Finds the depth where a row begins. */
    void at(TriangleScan scan, int row) {
        if (compact) {
            first = scan.left[row] - scan.boxLeft;
            z = (float) (cornerZ + row * downZ);
        } else {
            first = 0;
            double weightB = scan.edgeB[row] * scan.inverseArea;
            double weightC = scan.edgeC[row] * scan.inverseArea;
            z = (float) (weightB * zb + za + weightC * zc);
        }
    }
}
