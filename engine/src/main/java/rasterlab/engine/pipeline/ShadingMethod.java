package rasterlab.engine.pipeline;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import rasterlab.engine.naming.Named;

/** How faces get their light. */
public enum ShadingMethod {
    /** The vase's author's own rule, one tone for each face. */
    TONE,
    /** No faces but their edges. */
    WIRE,
    /** The formula once for each face. */
    FLAT,
    /** The formula at the corners, mixed between them. */
    GOURAUD,
    /** The formula at every pixel, with mixed normals. */
    PHONG,
    /** The cheapest of flat, Gouraud and Phong that shows what the scene has. */
    AUTO;

    /** Lower-case name, as on the command line. */
    public String code() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** The names that {@link #named} knows, in teaching order. */
    public static List<String> names() {
        return Arrays.stream(values()).map(ShadingMethod::code).toList();
    }

    /**
     * @throws IllegalArgumentException for an unknown name; the message lists the known ones
     */
    public static ShadingMethod named(String name) {
        return Named.find("shading", name, List.of(values()), ShadingMethod::code);
    }
}
