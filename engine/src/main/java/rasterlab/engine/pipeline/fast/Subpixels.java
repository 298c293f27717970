package rasterlab.engine.pipeline.fast;

/**
 * Turns −1..1 into whole steps of 1/256 pixel, 0 being the centre of the top left pixel.
 *
 * <p>{@code x = (X + 1)·width/2 − 1/2} and {@code y = (1 − Y)·height/2 − 1/2} pixels, to the
 * nearest step, halfway to the even one. Up to {@link #GUARD} times the picture's half side they
 * stay below 2²⁴ steps, so that products of two differences are below 2⁵¹: exact in a long and in a
 * double.
 */
final class Subpixels {
    /** Bits of a pixel's fraction. */
    static final int BITS = 8;

    /** Steps of a pixel. */
    static final int ONE = 1 << BITS;

    /**
     * Vertices farther out than this times w are clipped; a power of two, so products are exact.
     */
    static final int GUARD = 8;

    /**
     * The way from the picture's side to its first pixel's centre, in steps, and what rounds to
     * one.
     */
    static final double ROUND = WholeNumbers.ROUND - ONE / 2.0;

    /** Half the size of the picture, in steps. */
    final double halfWidth;

    final double halfHeight;

    Subpixels(int width, int height) {
        halfWidth = width * (ONE / 2.0);
        halfHeight = height * (ONE / 2.0);
    }

    /** Whether these are the steps of a picture of that size. */
    boolean of(int width, int height) {
        return halfWidth == width * (ONE / 2.0) && halfHeight == height * (ONE / 2.0);
    }

    int x(double ndcX) {
        return WholeNumbers.lowestBits((ndcX + 1) * halfWidth + ROUND);
    }

    int y(double ndcY) {
        return WholeNumbers.lowestBits((1 - ndcY) * halfHeight + ROUND);
    }

    /** The first pixel whose centre is at a step or after it. */
    static int firstPixel(int step) {
        return step + ONE - 1 >> BITS;
    }

    /** The pixel after the last one whose centre is at a step or before it. */
    static int endPixel(int step) {
        return (step >> BITS) + 1;
    }
}
