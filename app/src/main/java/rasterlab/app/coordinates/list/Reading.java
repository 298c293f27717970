package rasterlab.app.coordinates.list;

import java.util.List;
import java.util.Locale;
import rasterlab.engine.naming.Named;

/** How a list of transformations is read. */
public enum Reading {
    /** The list read backwards: the object moves in axes that stay. */
    OBJECTS,
    /** The list read forwards: the axes move, and the object is drawn in them as it is given. */
    FRAME;

    /** Lower-case name. */
    public String code() {
        return name().toLowerCase(Locale.ROOT);
    }

    static Reading named(String code) {
        return Named.find("reading", code, List.of(values()), Reading::code);
    }
}
