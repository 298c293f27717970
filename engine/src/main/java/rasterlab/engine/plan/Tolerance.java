package rasterlab.engine.plan;

/**
 * How far a picture may be from the full pipeline's.
 *
 * <p>It promises that each channel of each pixel is at most {@code levels} beyond those that the
 * other picture has less than {@code pixels} away, and the other way round, so that nothing is
 * missing either: {@link ToleratedDifference} measures just that, for plans, their trials and brute
 * force.
 *
 * @param pixels how far things may be out of place, above 0
 * @param levels how far a channel of 0 to 255 may be off, at least 0
 * @param share the share of the pixels that may be off by more, 0 to 1
 */
public record Tolerance(double pixels, double levels, double share) {
    /** The largest distance, in pixels. */
    public static final double MOST_PIXELS = 64;

    public Tolerance {
        if (!(pixels > 0 && pixels <= MOST_PIXELS))
            throw new IllegalArgumentException(
                    "tolerance must be above 0 and at most 64 pixels, got " + pixels);
        if (!(levels >= 0 && levels <= 255))
            throw new IllegalArgumentException("levels must be from 0 to 255, got " + levels);
        if (!(share >= 0 && share <= 1))
            throw new IllegalArgumentException("error must be from 0 to 1, got " + share);
    }
}
