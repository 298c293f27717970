package rasterlab.engine.texture;

import org.joml.Matrix4d;

/**
 * Moves texture coordinates: [s t 0 1] · M, divided by the last number of the product.
 *
 * <p>The matrix is in the textbook's layout, points as rows, as {@link
 * rasterlab.engine.transform.MatrixStack} keeps it in its TEXTURE mode.
 */
public final class TextureMatrix {
    private final double[] s = new double[3];
    private final double[] t = new double[3];
    private final double[] q = new double[3];

    /**
     * @param matrix JOML's rows are the textbook's columns, so its constructor takes the numbers in
     *     the textbook's reading order
     */
    public TextureMatrix(Matrix4d matrix) {
        if (!matrix.isFinite())
            throw new IllegalArgumentException("texture matrix must be finite, got " + matrix);
        set(s, matrix.m00(), matrix.m10(), matrix.m30());
        set(t, matrix.m01(), matrix.m11(), matrix.m31());
        set(q, matrix.m03(), matrix.m13(), matrix.m33());
    }

    private static void set(double[] row, double ofS, double ofT, double constant) {
        row[0] = ofS;
        row[1] = ofT;
        row[2] = constant;
    }

    /**
     * Replaces the coordinates of pixels, in place; what goes to infinity does so without a word.
     */
    public void transform(int count, float[] ofS, float[] ofT) {
        for (int i = 0; i < count; i++) {
            double divisor = of(q, ofS[i], ofT[i]);
            double newS = of(s, ofS[i], ofT[i]) / divisor;
            ofT[i] = (float) (of(t, ofS[i], ofT[i]) / divisor);
            ofS[i] = (float) newS;
        }
    }

    /**
     * Computes how fast the new coordinates grow where the old ones, not yet replaced, grow so
     * fast: {@code s' = n/d} gives {@code ds' = (dn − s'·dd)/d}. The slopes are replaced.
     */
    public void transformSlopes(
            int count, float[] ofS, float[] ofT, float[] slopeS, float[] slopeT) {
        for (int i = 0; i < count; i++) {
            double divisor = of(q, ofS[i], ofT[i]);
            double grows = slopeS[i] * q[0] + slopeT[i] * q[1];
            double ofNewS = of(s, ofS[i], ofT[i]) / divisor * grows;
            double ofNewT = of(t, ofS[i], ofT[i]) / divisor * grows;
            double newS = (slopeS[i] * s[0] + slopeT[i] * s[1] - ofNewS) / divisor;
            slopeT[i] = (float) ((slopeS[i] * t[0] + slopeT[i] * t[1] - ofNewT) / divisor);
            slopeS[i] = (float) newS;
        }
    }

    private static double of(double[] row, double s, double t) {
        return s * row[0] + t * row[1] + row[2];
    }
}
