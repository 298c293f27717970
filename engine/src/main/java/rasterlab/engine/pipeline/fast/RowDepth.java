package rasterlab.engine.pipeline.fast;

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

    /** How large weights may be within such a box. */
    private static final int STEEPEST = 64;

    /** The slope up to which weights may be counted as floats: they are off by 2⁻²⁰ at most. */
    private static final int GENTLE = 16;

    /** How large depths may be there: seven roundings, those of 1/area too, add up to 2⁻²¹. */
    private static final int DEEPEST = 2;

    /** The bound below which edge functions, which are weights times the area, fit an int. */
    private static final double LARGEST = 0x1p31;

    /** The depth at corner a, and what the weights of b and c add. */
    double za;

    double zb;
    double zc;

    /** The growth of the depth from a pixel to the next on its right. */
    float stepZ;

    boolean compact;

    /** Whether weights may be counted from the box's corner too. */
    boolean gentle;

    /**
     * The depth at the corner of a compact triangle's box, and what it grows by from a row to the
     * next.
     */
    float cornerZ;

    float downZ;

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
        int columns = scan.boxRight - scan.boxLeft;
        double cornerB = scan.cornerB() * inverseArea;
        double cornerC = scan.cornerC() * inverseArea;
        cornerZ = (float) (cornerB * zb + za + cornerC * zc);
        downZ = (float) (downB * zb + downC * zc);
        double across = (Math.abs(toB) + Math.abs(toC)) * columns;
        double along = (Math.abs(downB) + Math.abs(downC)) * scan.rows;
        double steep = 1 + Math.abs(cornerB) + Math.abs(cornerC) + across + along;
        float deep = Math.abs(cornerZ) + Math.abs(stepZ) * columns + Math.abs(downZ) * scan.rows;
        // The 1 allows for the bias of edges that own no centre and for the rounding of 1/area.
        compact =
                columns <= WIDEST
                        && steep <= STEEPEST
                        && steep + 1 <= LARGEST * inverseArea
                        && deep <= DEEPEST;
        gentle = compact && steep <= GENTLE;
    }

    /** Finds the depth where a row begins. */
    void at(TriangleScan scan, int row) {
        if (compact) {
            first = scan.left[row] - scan.boxLeft;
            z = cornerZ + row * downZ;
        } else {
            first = 0;
            double weightB = scan.edgeB[row] * scan.inverseArea;
            double weightC = scan.edgeC[row] * scan.inverseArea;
            z = (float) (weightB * zb + za + weightC * zc);
        }
    }
}
