package rasterlab.engine.color;

/**
 * Turns shares of light into the levels of a picture, the only place where they are cut and
 * rounded.
 *
 * <p>The rule: light is summed up without limit, of all sources and terms; each channel of the sum
 * is cut to [0, 1] once, at the end, and rounded to the nearest of 256 levels, a tie upward. A
 * channel that is cut while others are not changes the hue, as it does in OpenGL.
 */
public final class Levels {
    /** The highest level. */
    public static final int HIGHEST = 255;

    private Levels() {}

    /** The share cut to [0, 1]; NaN becomes 0. */
    public static double cut(double share) {
        return share > 0 ? Math.min(share, 1) : 0;
    }

    /** The nearest level, 0 to 255, of the cut share. */
    public static int of(double share) {
        return (int) (cut(share) * HIGHEST + 0.5);
    }

    /** The share that a level stands for. */
    public static double share(int level) {
        if (level < 0 || level > HIGHEST)
            throw new IllegalArgumentException("level must be from 0 to 255, got " + level);
        return level / (double) HIGHEST;
    }

    /** 0xAARRGGBB of four shares. */
    public static int argb(double red, double green, double blue, double alpha) {
        return of(alpha) << 24 | of(red) << 16 | of(green) << 8 | of(blue);
    }

    /** Opaque 0xFFRRGGBB of three shares. */
    public static int rgb(double red, double green, double blue) {
        return argb(red, green, blue, 1);
    }

    /** Red, green and blue shares of 0xRRGGBB; higher bits do not count. */
    public static double[] shares(int rgb) {
        return new double[] {share(rgb >> 16 & 255), share(rgb >> 8 & 255), share(rgb & 255)};
    }
}
