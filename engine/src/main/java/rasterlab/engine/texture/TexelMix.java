package rasterlab.engine.texture;

/**
 * Mixes two colours, all four channels at a time: {@code (a·(256 − share) + b·share)/256} of each,
 * rounded.
 *
 * <p>A colour is spread over a long, 16 bits for each channel, which products with 256 do not
 * leave.
 */
final class TexelMix {
    private static final int WHOLE = 256;
    private static final long HALVES = 0x0080008000800080L;
    private static final long LEVELS = 0x00FF00FF00FF00FFL;

    private TexelMix() {}

    /** Alpha, green, red, blue, from the highest bits to the lowest. */
    private static long spread(int argb) {
        return (argb & 0xFF00FF00L) << 24 | argb & 0xFF00FFL;
    }

    /** The colour as 0xAARRGGBB. */
    static int packed(long spread) {
        return (int) (spread >>> 24 & 0xFF00FF00L | spread & 0xFF00FFL);
    }

    /**
     * @param a 0xAARRGGBB, as b
     * @param share 0 to 256
     */
    static long of(int a, int b, int share) {
        return of(spread(a), spread(b), share);
    }

    /**
     * @param a spread, as b
     */
    static long of(long a, long b, int share) {
        return (a * (WHOLE - share) + b * share + HALVES) >>> 8 & LEVELS;
    }
}
