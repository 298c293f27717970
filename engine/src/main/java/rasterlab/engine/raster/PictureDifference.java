package rasterlab.engine.raster;

/**
 * How a picture differs from the expected one, pixel by pixel.
 *
 * @param wrongPixels pixels whose colour differs in any channel
 * @param plainlyWrongPixels those of them that differ by more than {@link #ROUNDING} levels, which
 *     is more than light in floats rather than doubles makes
 * @param pixels pixels of the picture
 * @param largestLevelDifference the largest |expected − actual| of any of the channels alpha, red,
 *     green, blue, in levels 0 to 255
 * @param mask the expected picture, pale and grey, with the wrong pixels in {@link #WRONG} and a
 *     dark edge around them that reaches out as a × around each: a single wrong pixel is found by
 *     shape as well as by colour, and every one stands out from the greys
 */
public record PictureDifference(
        long wrongPixels,
        long plainlyWrongPixels,
        long pixels,
        int largestLevelDifference,
        Raster mask) {
    /** Levels by which rounding alone may change a channel. */
    public static final int ROUNDING = 2;

    /** Colour of a wrong pixel in the mask; nothing else in the mask has it. */
    public static final int WRONG = PixelMark.ARGB;

    /** Colour of the edge and the arms in the mask. */
    public static final int EDGE = 0xFF101010;

    private static final int ARM_LENGTH = 2;

    public PictureDifference {
        if (largestLevelDifference < 0 || largestLevelDifference > 255)
            throw new IllegalArgumentException(
                    "largestLevelDifference must be from 0 to 255, got " + largestLevelDifference);
    }

    /**
     * @throws IllegalArgumentException if the sizes differ
     */
    public static PictureDifference of(Raster expected, Raster actual) {
        if (expected.width() != actual.width() || expected.height() != actual.height())
            throw new IllegalArgumentException(
                    "pictures of one size are compared, got %d×%d expected and %d×%d actual"
                            .formatted(
                                    expected.width(),
                                    expected.height(),
                                    actual.width(),
                                    actual.height()));
        int[] want = expected.argb();
        int[] have = actual.argb();
        long wrong = 0;
        long plain = 0;
        int largest = 0;
        for (int i = 0; i < want.length; i++) {
            if (want[i] == have[i]) continue;
            wrong++;
            int levels = levelDifference(want[i], have[i]);
            if (levels > ROUNDING) plain++;
            largest = Math.max(largest, levels);
        }
        return new PictureDifference(wrong, plain, want.length, largest, mask(expected, have));
    }

    /** Wrong pixels as a share of all, 0 to 1. */
    public double share() {
        return (double) wrongPixels / pixels;
    }

    private static int levelDifference(int a, int b) {
        int largest = 0;
        for (int shift = 0; shift < 32; shift += 8)
            largest = Math.max(largest, Math.abs((a >>> shift & 255) - (b >>> shift & 255)));
        return largest;
    }

    private static Raster mask(Raster expected, int[] have) {
        var mask = new Raster(expected.width(), expected.height());
        int[] want = expected.argb();
        int[] out = mask.argb();
        for (int i = 0; i < out.length; i++) out[i] = pale(want[i]);
        for (int i = 0; i < out.length; i++)
            if (want[i] != have[i]) drawEdge(mask, i % expected.width(), i / expected.width());
        for (int i = 0; i < out.length; i++) if (want[i] != have[i]) out[i] = WRONG;
        return mask;
    }

    /** Grey of 170 to 255 by the usual luma weights (ITU-R BT.601), opaque. */
    private static int pale(int argb) {
        int luma = (299 * (argb >> 16 & 255) + 587 * (argb >> 8 & 255) + 114 * (argb & 255)) / 1000;
        return 0xFF000000 | 0x010101 * (170 + luma / 3);
    }

    private static void drawEdge(Raster mask, int x, int y) {
        for (int dy = -1; dy <= 1; dy++)
            for (int dx = -1; dx <= 1; dx++) darken(mask, x + dx, y + dy);
        for (int dx = -ARM_LENGTH; dx <= ARM_LENGTH; dx += 2 * ARM_LENGTH)
            for (int dy = -ARM_LENGTH; dy <= ARM_LENGTH; dy += 2 * ARM_LENGTH)
                darken(mask, x + dx, y + dy);
    }

    private static void darken(Raster mask, int x, int y) {
        if (mask.contains(x, y)) mask.argb()[y * mask.width() + x] = EDGE;
    }
}
