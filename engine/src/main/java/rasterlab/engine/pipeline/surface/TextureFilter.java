package rasterlab.engine.pipeline.surface;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import rasterlab.engine.naming.Named;

/** How a pixel gets its colour from the texels. */
public enum TextureFilter {
    /** The texel that the pixel's centre lies in. */
    NEAREST,
    /** The four texels around the centre, of the picture itself. */
    LINEAR,
    /** The linear filter in the two levels of detail that fit the pixel best. */
    MIPMAP,
    /** Texture coordinates linear on the screen: right only where the triangle faces the eye. */
    AFFINE_NEAREST;

    /** Names in teaching order. */
    public static List<String> names() {
        return Arrays.stream(values()).map(TextureFilter::code).toList();
    }

    /**
     * @throws IllegalArgumentException for an unknown name; the message lists the known ones
     */
    public static TextureFilter named(String name) {
        return Named.find("texture filter", name, List.of(values()), TextureFilter::code);
    }

    private String code() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
