package rasterlab.engine.pipeline.fast;

/** Colours of shares, many at a time. */
final class PixelLevels {
    private static final int OTHERS = 0xFFFFFF;

    private PixelLevels() {}

    /**
     * Writes opaque colours, each channel's nearest level.
     *
     * @param red 0 to 1, or beyond by no more than some ulps, as the others
     */
    static void pack(int count, float[] red, float[] green, float[] blue, int[] argb) {
        for (int i = 0; i < count; i++)
            argb[i] = SmoothFill.argb(red[i] * 255, green[i] * 255, blue[i] * 255);
    }

    /** Gives opaque colours an alpha. */
    static void setAlpha(int count, float[] alpha, int[] argb) {
        for (int i = 0; i < count; i++) {
            int level = Float.floatToRawIntBits(alpha[i] * 255 + SmoothFill.ROUND);
            argb[i] = argb[i] & OTHERS | level << 24;
        }
    }
}
