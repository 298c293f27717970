package rasterlab.contract;

/**
 * A row of pixels across a textured face.
 *
 * @param fromS s at the first pixel's centre, −1000 to 1000, as are the next three
 * @param fromT t there
 * @param fromDepth its distance from the eye along the line of sight, 10⁻⁶ to 10⁶
 * @param toS s at the last pixel's centre
 * @param toT t there
 * @param toDepth its distance from the eye, 10⁻⁶ to 10⁶
 * @param pixels how many, 1 to 8192; a single one stands at the first centre
 */
public record TexturedSpan(
        double fromS,
        double fromT,
        double fromDepth,
        double toS,
        double toT,
        double toDepth,
        int pixels) {
    /** The most pixels. */
    public static final int MOST_PIXELS = 8192;

    /** The largest magnitude of a texture coordinate. */
    public static final double LARGEST = 1000;

    /** The least depth. */
    public static final double NEAREST = 1e-6;

    /** The greatest depth. */
    public static final double FARTHEST = 1e6;

    public TexturedSpan {
        require("from[0]", fromS, -LARGEST, LARGEST);
        require("from[1]", fromT, -LARGEST, LARGEST);
        require("from[2]", fromDepth, NEAREST, FARTHEST);
        require("to[0]", toS, -LARGEST, LARGEST);
        require("to[1]", toT, -LARGEST, LARGEST);
        require("to[2]", toDepth, NEAREST, FARTHEST);
        if (pixels < 1 || pixels > MOST_PIXELS)
            throw new IllegalArgumentException("pixels must be from 1 to 8192, got " + pixels);
    }

    private static void require(String name, double value, double least, double most) {
        if (!(value >= least && value <= most))
            throw new IllegalArgumentException(
                    "%s must be from %s to %s, got %s".formatted(name, least, most, value));
    }
}
