package rasterlab.app.line.trace;

import java.util.List;
import java.util.Locale;
import rasterlab.engine.naming.Named;

/** The kinds of figures that the lab draws. */
public enum LineMode {
    SEGMENT,
    CIRCLE,
    ELLIPSE,
    /** A line with a width and dashes. */
    PEN,
    /** How much light lines get for their length, by their slope. */
    BRIGHTNESS;

    /** Lower-case name, the key of its texts. */
    public String code() {
        return name().toLowerCase(Locale.ROOT);
    }

    public static LineMode coded(String code) {
        return Named.find("mode", code, List.of(values()), LineMode::code);
    }
}
