package rasterlab.engine.pipeline.triangle;

/**
 * Colours of shares, many at a time.
 *
 * <p>Three levels of 8 bits fit into a float's 24: they are rounded and put side by side in loops
 * that the compiler turns into vector instructions, and only their sum is made a whole number.
 */
public final class PixelLevels {
    /** Added and taken away again it rounds a level to the nearest whole number. */
    private static final float ROUND = 0x1p23f;

    private PixelLevels() {}

    /**
     * Opaque colours, each channel's nearest level; the shares of red are lost.
     *
     * @param red 0 to 1, or beyond by no more than some ulps, as the others
     */
    public static void pack(int count, float[] red, float[] green, float[] blue, int[] argb) {
        for (int i = 0; i < count; i++)
            red[i] =
                    (red[i] * 255 + ROUND - ROUND) * 65536
                            + (green[i] * 255 + ROUND - ROUND) * 256
                            + (blue[i] * 255 + ROUND - ROUND);
        for (int i = 0; i < count; i++) argb[i] = 0xFF000000 | (int) red[i];
    }

    /** The same with an alpha, whose shares are lost too. */
    public static void pack(
            int count, float[] red, float[] green, float[] blue, float[] alpha, int[] argb) {
        pack(count, red, green, blue, argb);
        for (int i = 0; i < count; i++) alpha[i] = alpha[i] * 255 + ROUND - ROUND;
        for (int i = 0; i < count; i++) argb[i] &= (int) alpha[i] << 24 | 0xFFFFFF;
    }
}
