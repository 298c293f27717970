package rasterlab.engine.visibility.depth;

import rasterlab.contract.DepthRange;

/**
 * Surfaces one behind the other along a scan line, or in a single pixel.
 *
 * <p>Pixel i of n is the share f = i/(n − 1) along the line, where surface s has the nearness (1 −
 * f)/depths[s] + f/to[s].
 *
 * @param depths z of each surface in the first pixel, between the planes; 1 to 1000 surfaces
 * @param to z of each surface in the last pixel, between the planes
 * @param pixels 1 to 8192; times the surfaces at most 131072; a single one is the first
 */
public record DepthRows(DepthRange range, double[] depths, double[] to, int pixels) {
    /** The most surfaces. */
    public static final int MOST_SURFACES = 1000;

    /** The most pixels. */
    public static final int MOST_PIXELS = 8192;

    static final int MOST_DEPTHS = 131_072;

    public DepthRows {
        require("number of surfaces", depths.length, MOST_SURFACES);
        if (to.length != depths.length)
            throw new IllegalArgumentException(
                    "to must have as many depths as depths, %d, got %d"
                            .formatted(depths.length, to.length));
        require("pixels", pixels, MOST_PIXELS);
        require("surfaces times pixels", depths.length * pixels, MOST_DEPTHS);
        depths = between("depths", range, depths);
        to = between("to", range, to);
    }

    /** Surfaces in a single pixel. */
    public static DepthRows pixel(DepthRange range, double... depths) {
        return new DepthRows(range, depths, depths, 1);
    }

    public int surfaces() {
        return depths.length;
    }

    /** How many depths there are, those of all surfaces and pixels. */
    public int count() {
        return depths.length * pixels;
    }

    /** 1/z of a surface in the first pixel. */
    public double nearness(int surface) {
        return 1 / depths[surface];
    }

    /** How much 1/z of a surface grows from pixel to pixel. */
    public double perPixel(int surface) {
        return pixels == 1 ? 0 : (1 / to[surface] - 1 / depths[surface]) / (pixels - 1);
    }

    /** z of a surface in a pixel, between the planes whatever was rounded. */
    double depth(int surface, int pixel) {
        if (pixel == 0) return depths[surface];
        double z = 1 / (nearness(surface) + pixel * perPixel(surface));
        return Math.max(range.near(), Math.min(range.far(), z));
    }

    private static void require(String name, int value, int most) {
        if (value < 1 || value > most)
            throw new IllegalArgumentException(
                    "%s must be from 1 to %d, got %d".formatted(name, most, value));
    }

    private static double[] between(String name, DepthRange range, double[] depths) {
        for (int s = 0; s < depths.length; s++)
            if (!(depths[s] >= range.near()
                    && depths[s] <= range.far()
                    && Double.isFinite(depths[s])))
                throw new IllegalArgumentException(
                        "%s[%d] must be finite and from near to far, %s to %s, got %s"
                                .formatted(name, s, range.near(), range.far(), depths[s]));
        return depths.clone();
    }
}
