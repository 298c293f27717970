package rasterlab.app.coordinates.figure;

import java.util.List;
import java.util.Locale;
import rasterlab.engine.naming.Named;

/** Which of the labs of coordinates the tab shows. */
public enum CoordinatesMode {
    VIEWS,
    TRANSFORMATIONS,
    STACK,
    ROTATION,
    MEETING;

    /** Lower-case name, as components and texts are named by. */
    public String code() {
        return name().toLowerCase(Locale.ROOT);
    }

    public static CoordinatesMode named(String code) {
        return Named.find("mode", code, List.of(values()), CoordinatesMode::code);
    }
}
