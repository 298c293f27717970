package rasterlab.app.coordinates.view;

import java.util.Locale;

/** How pictures for two eyes are shown. */
public enum Stereoscopy {
    NONE,
    /** One over the other, red for the left eye and cyan for the right one. */
    ANAGLYPH,
    SIDE_BY_SIDE;

    /** Lower-case name with hyphens. */
    public String code() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    static Stereoscopy named(String code) {
        return valueOf(code.toUpperCase(Locale.ROOT).replace('-', '_'));
    }
}
