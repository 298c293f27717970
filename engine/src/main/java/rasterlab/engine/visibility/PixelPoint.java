package rasterlab.engine.visibility;

/**
 * The point at which a pixel is looked at: a hair right of its centre and below, so that a centre
 * on an edge belongs to the face on its right, then below, whatever the rounding of the corners.
 */
public final class PixelPoint {
    /** Pixels from the centre to the right. */
    public static final double RIGHT_OF_CENTER = 0x1p-20;

    /** Pixels from the centre down. */
    public static final double BELOW_CENTER = 0x1p-30;

    private PixelPoint() {}
}
