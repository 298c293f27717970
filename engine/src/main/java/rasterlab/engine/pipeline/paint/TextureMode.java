package rasterlab.engine.pipeline.paint;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import rasterlab.engine.naming.Named;

/** How the faces' textures are looked up, as a request says it. */
public enum TextureMode {
    /** The texel that the pixel's centre lies in. */
    NEAREST,
    /** The four texels around it mixed. */
    LINEAR,
    /** The linear filter in the two levels that fit the pixel, mixed. */
    MIPMAP,
    /** The nearest texel without perspective: the textbook's mistake. */
    AFFINE_NEAREST,
    /** Mipmaps on the faces that may be made smaller somewhere; the linear filter elsewhere. */
    AUTO,
    /** Faces without their textures. */
    NONE;

    /** Lower-case name with hyphens, as on the command line. */
    public String code() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** The names that {@link #named} knows. */
    public static List<String> names() {
        return Arrays.stream(values()).map(TextureMode::code).toList();
    }

    /**
     * @throws IllegalArgumentException for an unknown name; the message lists the known ones
     */
    public static TextureMode named(String name) {
        return Named.find("texture filter", name, List.of(values()), TextureMode::code);
    }
}
