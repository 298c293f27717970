package rasterlab.engine.pipeline.fast;

/**
 * The treatment of a pixel that is nearer than the present one.
 *
 * <p>Mixed: {@code I = I₁·α + I₂·(1 − α)} for each of red, green and blue, rounded to the nearest
 * level, I₁ and α being the pixel's, I₂ what the picture has; the picture's alpha becomes {@code α
 * + α₂·(1 − α)}. Triangles are mixed in the mesh's order: who wants a true picture draws what is
 * opaque first and then the rest from far to near. Not mixed, pixels are opaque whatever their α.
 *
 * @param leastAlpha pixels whose alpha, 0 to 255, is below this leave no trace; 0 keeps all
 * @param mixed whether what is behind shines through
 * @param writesDepth whether the pixel hides what comes later and is farther
 * @param testsDepth whether what is there may hide the pixel; if not, it neither writes its depth
 */
public record Blending(int leastAlpha, boolean mixed, boolean writesDepth, boolean testsDepth) {
    /** Hides what is behind. */
    public static final Blending OPAQUE = new Blending(0, false, true, true);

    /** Lets what is behind shine through, and hides what comes later and is farther. */
    public static final Blending OVER = new Blending(0, true, true, true);

    /** Lets what is behind shine through, and hides nothing that comes later. */
    public static final Blending GLASS = new Blending(0, true, false, true);

    public Blending {
        if (leastAlpha < 0 || leastAlpha > 255)
            throw new IllegalArgumentException(
                    "least alpha must be from 0 to 255, got " + leastAlpha);
        if (writesDepth && !testsDepth)
            throw new IllegalArgumentException("depth that is not tested must not be written");
    }

    /** This blending with the alpha test. */
    public Blending dropBelow(int alpha) {
        return new Blending(alpha, mixed, writesDepth, testsDepth);
    }

    /** This blending without a trace in the depths. */
    public Blending withoutWriting() {
        return new Blending(leastAlpha, mixed, false, testsDepth);
    }

    /**
     * This blending over everything that is there, in the mesh's order, without a trace in the
     * depths.
     */
    public Blending withoutDepth() {
        return new Blending(leastAlpha, mixed, false, false);
    }

    /** Whether depth may be written before the colour is known. */
    boolean early() {
        return leastAlpha == 0 && !mixed && writesDepth;
    }

    /** One pixel over another, 0xAARRGGBB both. */
    static int over(int near, int behind) {
        int alpha = near >>> 24;
        int sum = alpha + share(behind >>> 24, 255 - alpha);
        return sum << 24
                | channel(near, behind, 16, alpha)
                | channel(near, behind, 8, alpha)
                | channel(near, behind, 0, alpha);
    }

    private static int channel(int near, int behind, int shift, int alpha) {
        int weighted = (near >> shift & 255) * alpha + (behind >> shift & 255) * (255 - alpha);
        return rounded(weighted) << shift;
    }

    private static int share(int level, int alpha) {
        return rounded(level * alpha);
    }

    /** v/255 to the nearest whole number, exact for v from 0 to 255². */
    private static int rounded(int v) {
        return (v + 128) * 257 >> 16;
    }
}
