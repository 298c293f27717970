package rasterlab.engine.texture;

import java.util.List;

/**
 * A picture of any size with its levels of detail, unchangeable.
 *
 * <p>Level 0 is the picture; each next one has half the width and height, rounded down, at least 1,
 * until 1×1. Each texel is the mean of the picture over its area, so that an odd size loses and
 * shifts nothing.
 *
 * <p>Source: L. Williams, Pyramidal parametrics, SIGGRAPH 1983, pp. 1–11.
 */
public final class Texture {
    /** The largest width and height. */
    public static final int LARGEST = 8192;

    private final int components;
    private final List<TextureLevel> levels;
    private final boolean opaque;

    private Texture(int components, List<TextureLevel> levels, boolean opaque) {
        this.components = components;
        this.levels = levels;
        this.opaque = opaque;
    }

    /**
     * A texture of texels row by row, the bottom row first.
     *
     * @param components 1 (luminance), 2 (luminance and alpha), 3 (colour) or 4 (colour and alpha);
     *     luminance is stored as a grey, and without alpha every texel is opaque
     * @param argb 0xAARRGGBB; with luminance only the red counts, without alpha no alpha does
     */
    public static Texture of(int width, int height, int components, int[] argb) {
        requireSize("width", width);
        requireSize("height", height);
        if (components < 1 || components > 4)
            throw new IllegalArgumentException("components must be from 1 to 4, got " + components);
        if (argb.length != width * height)
            throw new IllegalArgumentException(
                    "a texture of %d×%d needs %d texels, got %d"
                            .formatted(width, height, width * height, argb.length));
        var texels = new int[argb.length];
        int hiding = 255;
        for (int i = 0; i < texels.length; i++) {
            texels[i] = stored(argb[i], components);
            hiding &= texels[i] >>> 24;
        }
        return new Texture(
                components,
                Reduction.levels(new TextureLevel(width, height, texels)),
                hiding == 255);
    }

    private static void requireSize(String name, int size) {
        if (size < 1 || size > LARGEST)
            throw new IllegalArgumentException(
                    "texture's %s must be from 1 to %d, got %d".formatted(name, LARGEST, size));
    }

    private static int stored(int argb, int components) {
        int texel = components % 2 == 0 ? argb : argb | 0xFF000000;
        if (components > 2) return texel;
        int luminance = argb >> 16 & 255;
        return texel & 0xFF000000 | luminance * 0x010101;
    }

    public int components() {
        return components;
    }

    /** Whether nothing is seen through any texel. */
    public boolean opaque() {
        return opaque;
    }

    public int width() {
        return levels.get(0).width();
    }

    public int height() {
        return levels.get(0).height();
    }

    public int levelCount() {
        return levels.size();
    }

    /** Level {@code index}, 0 being the picture itself. */
    public TextureLevel level(int index) {
        return levels.get(index);
    }
}
