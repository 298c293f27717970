package rasterlab.engine.pipeline.fast;

/**
 * Depth and colours of one triangle as functions that are linear on the picture.
 *
 * <p>On the picture 1/w and colour/w are linear, so a pixel's colour is their quotient. Where w
 * hardly changes over a triangle the colour itself is as good as linear, and no pixel needs a
 * division: with weights b and q = 1/w, {@code Σbqc/Σbq − Σbc} is the covariance of q and c divided
 * by Σbq, at most {@code (max c − min c)·(max q − min q) / (4·min q)}. The functions fit where this
 * is at most {@link #TOLERANCE} levels.
 *
 * <p>Source of the bound: G. Grüss, Mathematische Zeitschrift 39, 1935.
 */
final class LinearColors {
    /** The largest error allowed, in levels. */
    static final float TOLERANCE = 0.25f;

    /** Colours are whole numbers of 1/65536 level. */
    private static final float ONE = 65536;

    /** Rounds to the nearest level. */
    private static final int HALF = 32768;

    final RowDepth depth = new RowDepth();

    /** Red at corner a, and what the weights of b and c add. */
    double ra;

    double rb;
    double rc;
    double ga;
    double gb;
    double gc;
    double ba;
    double bb;
    double bc;

    /** The growth of each from a pixel to the next on its right. */
    int stepRed;

    int stepGreen;
    int stepBlue;

    /**
     * Red at the corner of a compact triangle's box, and what each channel grows by to the next
     * row.
     */
    int cornerRed;

    int cornerGreen;
    int cornerBlue;
    int downRed;
    int downGreen;
    int downBlue;

    /** Red at the first pixel of the row that {@link #at} was asked for. */
    int red;

    int green;
    int blue;

    boolean fits(TriangleScan scan, ScreenVertices v) {
        int qa = order(v.nearness(scan.a));
        int qb = order(v.nearness(scan.b));
        int qc = order(v.nearness(scan.c));
        float least = Float.intBitsToFloat(least(qa, qb, qc));
        float spread = Float.intBitsToFloat(most(qa, qb, qc)) - least;
        float allowed = TOLERANCE * 4 * least;
        if (255 * spread <= allowed) return true;
        return range(v, 0, scan) * spread <= allowed
                && range(v, 1, scan) * spread <= allowed
                && range(v, 2, scan) * spread <= allowed;
    }

    private static float range(ScreenVertices v, int channel, TriangleScan scan) {
        int a = order(v.attribute(channel, scan.a));
        int b = order(v.attribute(channel, scan.b));
        int c = order(v.attribute(channel, scan.c));
        return Float.intBitsToFloat(most(a, b, c)) - Float.intBitsToFloat(least(a, b, c));
    }

    /** Bits of numbers that are not negative have the numbers' order, and are compared faster. */
    private static int order(float notNegative) {
        return Float.floatToRawIntBits(notNegative);
    }

    private static int least(int a, int b, int c) {
        return Math.min(a, Math.min(b, c));
    }

    private static int most(int a, int b, int c) {
        return Math.max(a, Math.max(b, c));
    }

    void load(TriangleScan scan, ScreenVertices v) {
        int a = v.at(scan.a);
        int b = v.at(scan.b);
        int c = v.at(scan.c);
        float[] rgb = v.values;
        depth.load(scan, v);
        ra = rgb[a] * ONE + HALF;
        rb = (rgb[b] - rgb[a]) * ONE;
        rc = (rgb[c] - rgb[a]) * ONE;
        ga = rgb[a + 1] * ONE + HALF;
        gb = (rgb[b + 1] - rgb[a + 1]) * ONE;
        gc = (rgb[c + 1] - rgb[a + 1]) * ONE;
        ba = rgb[a + 2] * ONE + HALF;
        bb = (rgb[b + 2] - rgb[a + 2]) * ONE;
        bc = (rgb[c + 2] - rgb[a + 2]) * ONE;
        double inverseArea = scan.inverseArea;
        double toB = scan.stepB * inverseArea;
        double toC = scan.stepC * inverseArea;
        stepRed = WholeNumbers.nearest(toB * rb + toC * rc);
        stepGreen = WholeNumbers.nearest(toB * gb + toC * gc);
        stepBlue = WholeNumbers.nearest(toB * bb + toC * bc);
        if (!depth.compact) return;
        toCorner(scan.cornerB() * inverseArea, scan.cornerC() * inverseArea);
        double downB = scan.downB * inverseArea;
        double downC = scan.downC * inverseArea;
        downRed = WholeNumbers.nearest(downB * rb + downC * rc);
        downGreen = WholeNumbers.nearest(downB * gb + downC * gc);
        downBlue = WholeNumbers.nearest(downB * bb + downC * bc);
    }

    private void toCorner(double weightB, double weightC) {
        cornerRed = WholeNumbers.nearest(weightB * rb + ra + weightC * rc);
        cornerGreen = WholeNumbers.nearest(weightB * gb + ga + weightC * gc);
        cornerBlue = WholeNumbers.nearest(weightB * bb + ba + weightC * bc);
    }

    /** Finds depth and colours where a row begins. */
    void at(TriangleScan scan, int row) {
        depth.at(scan, row);
        if (depth.compact) countFromCorner(row, depth.first);
        else weigh(scan.edgeB[row] * scan.inverseArea, scan.edgeC[row] * scan.inverseArea);
    }

    private void countFromCorner(int row, int column) {
        red = cornerRed + row * downRed + column * stepRed;
        green = cornerGreen + row * downGreen + column * stepGreen;
        blue = cornerBlue + row * downBlue + column * stepBlue;
    }

    private void weigh(double weightB, double weightC) {
        red = WholeNumbers.nearest(weightB * rb + ra + weightC * rc);
        green = WholeNumbers.nearest(weightB * gb + ga + weightC * gc);
        blue = WholeNumbers.nearest(weightB * bb + ba + weightC * bc);
    }

    /** 0xFFRRGGBB of whole numbers of 1/65536 level. */
    static int argb(int red, int green, int blue) {
        return 0xFF000000 | red & 0xFF0000 | green >>> 8 & 0xFF00 | blue >>> 16;
    }
}
